// SPDX-License-Identifier: MIT
#include "sim/materials/material_settings.h"

#include "sim/frame/described_list.h"
#include "sim/materials/materials.h"

#include <array>
#include <span>

namespace flipbook {
namespace {

[[nodiscard]] std::span<const Option> material_options() {
  static const auto options = std::apply(
      [](const auto&... m) {
        return std::array{Option{m.name, m.summary}...};
      },
      Materials{});
  return options;
}

/// answer(material) of the one in use.
template <class Answer> auto of(const MaterialSettings& s, Answer&& answer) {
  decltype(answer(NeoHookean{})) result{};
  with_item(s.materials->list, s.model, [&]<class M>(const M& m) {
    static_assert(Material<M>);
    result = answer(m);
  });
  return result;
}

} // namespace

MaterialParameters::MaterialParameters() : set_(std::make_unique<MaterialSet>()) {}
MaterialParameters::~MaterialParameters() = default;
MaterialParameters::MaterialParameters(const MaterialParameters& other)
    : set_(std::make_unique<MaterialSet>(*other.set_)) {}
MaterialParameters& MaterialParameters::operator=(const MaterialParameters& other) {
  *set_ = *other.set_;
  return *this;
}

void MaterialSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "model", .help = "What bodies are made of", .level = Level::teach, .effect = Effect::restart},
           model, material_options());
  describe_list(v, materials->list, model);
}

std::string_view MaterialSettings::name() const {
  return of(*this, [](const auto& m) { return m.name; });
}
std::string_view MaterialSettings::label() const {
  return of(*this, [](const auto& m) { return m.label; });
}
double MaterialSettings::density() const {
  return of(*this, [](const auto& m) { return m.density; });
}
Memory<double> MaterialSettings::memory() const {
  return of(*this, [](const auto& m) { return m.memory(); });
}
double MaterialSettings::plastic(const Memory<double>& memory) const {
  return of(*this, [&](const auto& m) {
    if constexpr (requires { m.plastic(memory); })
      return m.plastic(memory);
    else
      return memory[0];
  });
}
bool MaterialSettings::flows() const {
  return of(*this, [](const auto& m) { return m.flows; });
}
bool MaterialSettings::flow_only_takes() const {
  return of(*this, [](const auto& m) {
    if constexpr (m.flows)
      return m.flow_only_takes;
    else
      return true;
  });
}

std::vector<MaterialInfo> material_infos() {
  std::vector<MaterialInfo> infos;
  std::apply([&](const auto&... m) { (infos.push_back({m.name, m.label, m.summary}), ...); }, Materials{});
  return infos;
}

} // namespace flipbook
