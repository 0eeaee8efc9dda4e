// SPDX-License-Identifier: MIT
// What a body is made of, and with which parameters. The materials themselves are in materials.h, which few files need
// to see: a change to one of them is compiled into those only.
#pragma once

#include "sim/frame/parameters.h"
#include "sim/materials/memory.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

struct MaterialSet;

/// The parameters of every material; copies are apart from each other.
class MaterialParameters {
public:
  MaterialParameters();
  ~MaterialParameters();
  MaterialParameters(const MaterialParameters& other);
  MaterialParameters& operator=(const MaterialParameters& other);
  MaterialSet* operator->() { return set_.get(); }
  const MaterialSet* operator->() const { return set_.get(); }

private:
  std::unique_ptr<MaterialSet> set_;
};

struct MaterialSettings {
  int model = 0; ///< index into Materials; names in a file
  MaterialParameters materials;

  /// model and the parameters of every material, each path once, as for the schemes: the model is set before them.
  void describe(ParameterVisitor& v);

  // === Of the material in use
  [[nodiscard]] std::string_view name() const;  ///< "neo_hookean"
  [[nodiscard]] std::string_view label() const; ///< "neo-Hookean"
  [[nodiscard]] double density() const;         ///< undeformed, kg/m^3
  [[nodiscard]] Memory<double> memory() const;  ///< at the start
  /// How far it has flowed: what it remembers first, or what the material says.
  [[nodiscard]] double plastic(const Memory<double>& memory) const;
  [[nodiscard]] bool flows() const;
  /// Does flow only ever take elastic energy, whatever the material remembers?
  [[nodiscard]] bool flow_only_takes() const;
};

/// One material of the list, for people.
struct MaterialInfo {
  std::string_view name, label, summary;
};
[[nodiscard]] std::vector<MaterialInfo> material_infos();

} // namespace flipbook
