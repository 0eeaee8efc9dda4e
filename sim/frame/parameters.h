// SPDX-License-Identifier: MIT
// One declaration of each parameter. A component's describe(visitor) names every parameter it has, once: name, unit,
// range, help. From that come the TOML keys, --set, the panel, the timeline's targets, `list parameters` and the
// provenance in each picture. A parameter is described or it does not exist.
#pragma once

#include "sim/frame/errors.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace flipbook {

enum class Level { teach, expert };  ///< who should see it in a panel
enum class Effect { live, restart }; ///< may it change during a run, or only before the first step?

/// One named value of a choice, with a line of help.
struct Option {
  std::string_view name;
  std::string_view help;
};

/// What a parameter is, apart from its value.
struct Spec {
  std::string_view name;      ///< last part of the path
  std::string_view help;      ///< one sentence
  std::string_view unit = ""; ///< SI, empty for a pure number
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  Level level = Level::expert;
  Effect effect = Effect::live;
  bool applies = true; ///< false: known, but without effect in the present settings (another scheme's parameter)
  std::string_view at_min = "", at_max = ""; ///< what the ends of the range mean, for a label: "PIC" and "FLIP"
};

/// A value as files, the command line, the timeline and the panel exchange it. Numbers are double, a choice is its
/// name.
using Value = std::variant<bool, double, std::string, std::vector<double>, std::vector<std::string>>;

enum class Kind { flag, real, integer, choice, text, reals, integers, names };

/// A parameter with its value, detached from the component it came from.
struct Parameter {
  std::string path; ///< dotted, for example "transfer.flip_ratio"
  Kind kind = Kind::real;
  Value value;
  std::string help, unit;
  double min = 0, max = 0;
  std::vector<std::string> options; ///< of a choice, or the valid entries of a names list (empty: any)
  std::vector<std::string> option_help;
  Level level = Level::expert;
  Effect effect = Effect::live;
  bool applies = true;
  std::string at_min, at_max;
};

/// A reference to a parameter's storage.
struct ChoiceRef {
  int& index;
  std::span<const Option> options;
};
struct NamesRef {
  std::vector<std::string>& names;
  std::span<const Option> options; ///< empty: any name
};
using Ref = std::variant<bool*, double*, int*, ChoiceRef, std::string*, std::span<double>, std::span<int>, NamesRef>;

class ParameterVisitor {
public:
  virtual ~ParameterVisitor() = default;

  /// Everything that `body` describes gets "name." before its path.
  template <class Body> void group(std::string_view name, Body&& body) {
    const std::size_t before = prefix_.size();
    prefix_.append(name).append(".");
    body();
    prefix_.resize(before);
  }

  void flag(const Spec& s, bool& x) { visit(path(s), s, &x); }
  void real(const Spec& s, double& x) { visit(path(s), s, &x); }
  void integer(const Spec& s, int& x) { visit(path(s), s, &x); }
  void text(const Spec& s, std::string& x) { visit(path(s), s, &x); }
  void reals(const Spec& s, std::span<double> x) { visit(path(s), s, x); }
  void integers(const Spec& s, std::span<int> x) { visit(path(s), s, x); }
  void names(const Spec& s, std::vector<std::string>& x, std::span<const Option> options = {}) {
    visit(path(s), s, NamesRef{x, options});
  }
  /// An enumeration whose values 0, 1, ... are named by `options` in order (or a plain int index).
  template <class E> void choice(const Spec& s, E& x, std::span<const Option> options) {
    int index = static_cast<int>(x);
    visit(path(s), s, ChoiceRef{index, options});
    x = static_cast<E>(index);
  }

protected:
  virtual void visit(const std::string& path, const Spec& spec, Ref ref) = 0;

private:
  [[nodiscard]] std::string path(const Spec& s) const { return prefix_ + std::string(s.name); }
  std::string prefix_;
};

/// Something with describe(ParameterVisitor&).
template <class T>
concept Described = requires(T& t, ParameterVisitor& v) {
  t.describe(v);
};

/// Why a value was refused. The caller knows the file and line and turns it into a UserError.
struct Refusal {
  std::string message;
  std::string nearest; ///< a valid name, or empty
};

namespace detail {
/// Collects every described parameter.
class Collector final : public ParameterVisitor {
public:
  std::vector<Parameter> found;

protected:
  void visit(const std::string& path, const Spec& spec, Ref ref) override;
};
/// Sets the one parameter whose path matches; fills `refusal` when the value does not fit.
class Setter final : public ParameterVisitor {
public:
  Setter(std::string_view path, const Value& value) : path_(path), value_(value) {}
  bool matched = false;
  Refusal refusal;

protected:
  void visit(const std::string& path, const Spec& spec, Ref ref) override;

private:
  std::string_view path_;
  const Value& value_;
};
} // namespace detail

/// All parameters of a component, in the order in which it describes them.
template <Described T> [[nodiscard]] std::vector<Parameter> parameters_of(T& component) {
  detail::Collector c;
  component.describe(c);
  return std::move(c.found);
}

/// Sets `path` to `value`; on failure nothing has changed and the reason is returned (message empty: done).
template <Described T> [[nodiscard]] Refusal set_parameter(T& component, std::string_view path, const Value& value) {
  detail::Setter s(path, value);
  component.describe(s);
  if (s.matched) return s.refusal;
  std::vector<std::string> known;
  for (const Parameter& p : parameters_of(component)) known.push_back(p.path);
  return {"unknown parameter \"" + std::string(path) + "\"", nearest_name(path, known)};
}

/// `1.5`, `true`, `"apic"`, `[1, 2]`: the value as TOML writes it, with the shortest digits that read back exactly.
[[nodiscard]] std::string to_toml(const Value& value);

/// Reads one value from command line text: a TOML value, or a bare word taken as a string ("apic"), or numbers or words
/// separated by commas taken as a list ("128,128").
[[nodiscard]] Value parse_value(std::string_view text);

/// Linear interpolation for the timeline: numbers and lists of numbers move, everything else switches at s = 1.
[[nodiscard]] Value blend(const Value& from, const Value& to, double s);

} // namespace flipbook
