// SPDX-License-Identifier: MIT
#include "sim/transfer/schemes.h"

#include "sim/frame/described_list.h"
#include "sim/frame/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace flipbook {
namespace {

template <class S> [[nodiscard]] constexpr bool titled() {
  static_assert(Scheme<S>);
  if constexpr (requires { S::parameter_in_title; }) return S::parameter_in_title;
  return false;
}

[[nodiscard]] std::span<const Option> scheme_options() {
  static const auto options = std::apply(
      [](const auto&... s) {
        return std::array{Option{s.name, s.summary}...};
      },
      Schemes{});
  return options;
}

[[nodiscard]] std::string short_number(double x, int digits = 6) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

/// Three digits, so that a title is steady while the number slides; more where they would make 0.9995 a 1.
[[nodiscard]] std::string title_number(double x) {
  const double whole = std::round(x);
  return short_number(x, x != whole && std::abs(x - whole) < 5e-3 ? 6 : 3);
}

} // namespace

SchemeParameters::SchemeParameters() : set_(std::make_unique<SchemeSet>()) {}
SchemeParameters::~SchemeParameters() = default;
SchemeParameters::SchemeParameters(const SchemeParameters& other) : set_(std::make_unique<SchemeSet>(*other.set_)) {}
SchemeParameters& SchemeParameters::operator=(const SchemeParameters& other) {
  *set_ = *other.set_;
  return *this;
}

int usual_scheme() {
  return scheme_index<Apic>;
}

void TransferSettings::describe(ParameterVisitor& v) {
  v.choice({.name = "scheme", .help = "How velocity goes between particles and grid", .level = Level::teach}, scheme,
           scheme_options());
  v.choice({.name = "kernel", .help = "The interpolation kernel of every transfer", .level = Level::teach}, kernel,
           kernel_options());
  describe_list(v, schemes->list, scheme);
}

Corner TransferSettings::corner() const {
  Corner c;
  with_item(schemes->list, scheme, [&](const auto& s) { c = corner_of(s); });
  return c;
}

std::string TransferSettings::name() const {
  std::string n;
  with_item(schemes->list, scheme, [&](const auto& s) { n = s.name; });
  return n;
}

std::string TransferSettings::title() const {
  std::string text;
  with_item(schemes->list, scheme, [&]<class S>(const S& in_use) {
    text = S::label;
    S now = in_use, fresh;
    const auto set = parameters_of(now), usual = parameters_of(fresh);
    for (std::size_t i = 0; i < set.size(); ++i) {
      const bool changed = set[i].value != usual[i].value;
      const auto* number = std::get_if<double>(&set[i].value);
      const auto* choice = std::get_if<std::string>(&set[i].value);
      if (i == 0 && number && (changed || titled<S>()))
        text += " " + title_number(*number);
      else if (changed && choice)
        text += " " + *choice;
    }
  });
  return text;
}

std::vector<SchemeInfo> scheme_infos() {
  std::vector<SchemeInfo> infos;
  Schemes schemes;
  std::apply(
      [&](auto&... s) {
        const auto add = [&](auto& one) {
          SchemeInfo info{one.name, one.label, one.summary, std::nullopt};
          if (const auto all = parameters_of(one); !all.empty()) {
            info.first = all.front();
            info.first->path = "transfer." + info.first->path;
          }
          infos.push_back(std::move(info));
        };
        (add(s), ...);
      },
      schemes);
  return infos;
}

SchemeRequest parse_scheme(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string name = lower(text.substr(0, colon));
  const auto infos = scheme_infos();
  const auto found = std::find_if(infos.begin(), infos.end(), [&](const SchemeInfo& i) { return i.name == name; });
  if (found == infos.end()) {
    std::vector<std::string> names;
    for (const SchemeInfo& i : infos) names.emplace_back(i.name);
    throw UserError("unknown scheme \"" + std::string(text.substr(0, colon)) + "\"", {}, nearest_name(name, names));
  }
  SchemeRequest request;
  request.scheme = static_cast<int>(found - infos.begin());
  if (colon == std::string_view::npos) return request;

  const auto refuse = [&](const std::string& why) { throw UserError("scheme \"" + std::string(text) + "\": " + why); };
  if (!found->first) refuse(std::string(found->label) + " has no parameter");
  const Parameter& p = *found->first;
  const std::string_view digits = text.substr(colon + 1);
  double x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error != std::errc() || end != digits.data() + digits.size())
    refuse("\"" + std::string(digits) + "\" is not a number");
  if (!(x >= p.min && x <= p.max))
    refuse(p.path + " must be between " + short_number(p.min) + " and " + short_number(p.max));
  request.number = {p.path, x};
  return request;
}

} // namespace flipbook
