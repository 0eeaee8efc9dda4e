// SPDX-License-Identifier: MIT
// Which scheme transfers, and with which parameters. The schemes themselves are in schemes.h, which few files need to
// see: a change to one of them is compiled into those only.
#pragma once

#include "sim/kernels/kernels.h"
#include "sim/transfer/corner.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flipbook {

struct SchemeSet;

/// The parameters of every scheme; copies are apart from each other.
class SchemeParameters {
public:
  SchemeParameters();
  ~SchemeParameters();
  SchemeParameters(const SchemeParameters& other);
  SchemeParameters& operator=(const SchemeParameters& other);
  SchemeSet* operator->() { return set_.get(); }
  const SchemeSet* operator->() const { return set_.get(); }

private:
  std::unique_ptr<SchemeSet> set_;
};

/// APIC.
[[nodiscard]] int usual_scheme();

/// Which scheme transfers, with which kernel. The parameters of every scheme are kept, so that switching back finds
/// them.
struct TransferSettings {
  int scheme = usual_scheme(); ///< index into Schemes; names in a file
  KernelName kernel = KernelName::linear;
  SchemeParameters schemes;

  /// scheme, kernel and the parameters of every scheme, each path once. A path that several schemes have belongs to the
  /// one in use; a path that only others have does not apply and sets the first of them. So the scheme is set before
  /// its parameters.
  void describe(ParameterVisitor& v);
  [[nodiscard]] Corner corner() const;     ///< of the scheme in use
  [[nodiscard]] std::string title() const; ///< "FLIP 0.97", "APIC": the scheme and the parameter that distinguishes it
  [[nodiscard]] std::string name() const;  ///< "flip"
};

/// One scheme of the list, for people.
struct SchemeInfo {
  std::string_view name, label, summary;
  std::optional<Parameter> first; ///< the parameter that `name:number` sets; its path is the full one
};
[[nodiscard]] std::vector<SchemeInfo> scheme_infos();

/// What `flip:0.97` asks for.
struct SchemeRequest {
  int scheme = 0;                                       ///< index into Schemes
  std::optional<std::pair<std::string, double>> number; ///< full path of the first parameter, and its value
};
/// Reads `name` or `name:number`; the case of the name does not matter. Throws UserError.
[[nodiscard]] SchemeRequest parse_scheme(std::string_view text);

} // namespace flipbook
