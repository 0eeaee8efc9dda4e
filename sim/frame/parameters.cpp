// SPDX-License-Identifier: MIT
#include "sim/frame/parameters.h"

#include "sim/frame/text.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

std::string quoted_list(std::span<const Option> options) {
  std::string text;
  for (const Option& o : options) text.append(text.empty() ? "\"" : ", \"").append(o.name).append("\"");
  return text;
}

std::string nearest_option(std::string_view word, std::span<const Option> options) {
  std::vector<std::string> names;
  for (const Option& o : options) names.emplace_back(o.name);
  return nearest_name(word, names);
}

/// ` from 0 to 1`, ` of at least 0`, or nothing.
std::string range_text(const Spec& s) {
  const bool below = std::isfinite(s.min), above = std::isfinite(s.max);
  if (below && above) return " from " + to_toml(s.min) + " to " + to_toml(s.max);
  if (below) return " of at least " + to_toml(s.min);
  if (above) return " of at most " + to_toml(s.max);
  return "";
}

/// Turns a value into the stored type, or says why it cannot. Nothing is stored unless everything fits.
class Assign {
public:
  Assign(const std::string& path, const Spec& spec, const Value& value) : path_(path), spec_(spec), value_(value) {}

  Refusal operator()(bool* x) const {
    const bool* b = std::get_if<bool>(&value_);
    if (!b) return must_be("true or false");
    *x = *b;
    return {};
  }
  Refusal operator()(double* x) const {
    const double* d = std::get_if<double>(&value_);
    if (!d || !fits(*d)) return must_be(number());
    *x = *d;
    return {};
  }
  Refusal operator()(int* x) const {
    const double* d = std::get_if<double>(&value_);
    if (!d || !fits(*d) || !whole(*d)) return must_be(integer());
    *x = static_cast<int>(*d);
    return {};
  }
  Refusal operator()(ChoiceRef x) const {
    const std::string* word = std::get_if<std::string>(&value_);
    for (std::size_t i = 0; word && i < x.options.size(); ++i)
      if (same_word(*word, x.options[i].name)) return x.index = static_cast<int>(i), Refusal{};
    Refusal r = must_be("one of " + quoted_list(x.options));
    if (word) r.nearest = nearest_option(*word, x.options);
    return r;
  }
  Refusal operator()(std::string* x) const {
    const std::string* word = std::get_if<std::string>(&value_);
    if (!word) return must_be("a text in quotes");
    *x = *word;
    return {};
  }
  Refusal operator()(std::span<double> x) const {
    const auto* list = std::get_if<std::vector<double>>(&value_);
    if (!list || !length(list->size(), x.size())) return must_be(how_many(x.size()) + " numbers" + range_text(spec_));
    for (double d : *list)
      if (!fits(d)) return must_be(how_many(x.size()) + " numbers" + range_text(spec_));
    std::copy(list->begin(), list->end(), x.begin());
    return {};
  }
  Refusal operator()(std::span<int> x) const {
    const auto* list = std::get_if<std::vector<double>>(&value_);
    const std::string wanted = how_many(x.size()) + " whole numbers" + range_text(spec_);
    if (!list || !length(list->size(), x.size())) return must_be(wanted);
    for (double d : *list)
      if (!fits(d) || !whole(d)) return must_be(wanted);
    std::transform(list->begin(), list->end(), x.begin(), [](double d) { return static_cast<int>(d); });
    return {};
  }
  Refusal operator()(NamesRef x) const {
    std::vector<std::string> list;
    if (const auto* names = std::get_if<std::vector<std::string>>(&value_))
      list = *names;
    else if (const auto* one = std::get_if<std::string>(&value_))
      list = {*one};
    else if (const auto* none = std::get_if<std::vector<double>>(&value_); !none || !none->empty())
      return must_be("a list of names");
    for (std::string& name : list) {
      if (x.options.empty()) break;
      const auto o = std::find_if(x.options.begin(), x.options.end(), [&](auto& k) { return same_word(k.name, name); });
      if (o == x.options.end())
        return {"\"" + name + "\" is not a name that " + path_ + " knows: " + quoted_list(x.options),
                nearest_option(name, x.options)};
      name = o->name;
    }
    x.names = std::move(list);
    return {};
  }

private:
  // NaN fits nothing and no parameter is infinite.
  [[nodiscard]] bool fits(double d) const { return std::isfinite(d) && d >= spec_.min && d <= spec_.max; }
  static bool whole(double d) { return d == std::floor(d) && std::abs(d) <= std::numeric_limits<int>::max(); }
  [[nodiscard]] std::string number() const {
    const std::string range = range_text(spec_);
    std::string text = range.empty() ? "a finite number" : "a number" + range;
    if (!spec_.unit.empty()) text.append(" (").append(spec_.unit).append(")");
    return text;
  }
  [[nodiscard]] std::string integer() const { return "a whole number" + range_text(spec_); }
  /// A list with an entry for each axis may leave out the third.
  static bool length(std::size_t given, std::size_t stored) { return given == stored || (stored == 3 && given == 2); }
  static std::string how_many(std::size_t n) { return n == 3 ? "2 or 3" : std::to_string(n); }
  [[nodiscard]] Refusal must_be(const std::string& what) const {
    return {path_ + " must be " + what + ", not " + to_toml(value_), ""};
  }

  const std::string& path_;
  const Spec& spec_;
  const Value& value_;
};

void fill(Parameter& p, std::span<const Option> options) {
  for (const Option& o : options) {
    p.options.emplace_back(o.name);
    p.option_help.emplace_back(o.help);
  }
}

} // namespace

void detail::Collector::visit(const std::string& path, const Spec& spec, Ref ref) {
  Parameter p;
  p.path = path;
  p.help = spec.help;
  p.unit = spec.unit;
  p.min = spec.min;
  p.max = spec.max;
  p.level = spec.level;
  p.effect = spec.effect;
  p.applies = spec.applies;
  p.at_min = spec.at_min;
  p.at_max = spec.at_max;
  const auto store = [&p](Kind kind, Value value) { p.kind = kind, p.value = std::move(value); };
  if (auto* b = std::get_if<bool*>(&ref))
    store(Kind::flag, **b);
  else if (auto* d = std::get_if<double*>(&ref))
    store(Kind::real, **d);
  else if (auto* i = std::get_if<int*>(&ref))
    store(Kind::integer, static_cast<double>(**i));
  else if (auto* t = std::get_if<std::string*>(&ref))
    store(Kind::text, **t);
  else if (auto* r = std::get_if<std::span<double>>(&ref))
    store(Kind::reals, std::vector<double>(r->begin(), r->end()));
  else if (auto* n = std::get_if<std::span<int>>(&ref))
    store(Kind::integers, std::vector<double>(n->begin(), n->end()));
  else if (auto* c = std::get_if<ChoiceRef>(&ref)) {
    store(Kind::choice, std::string(c->options[static_cast<std::size_t>(c->index)].name));
    fill(p, c->options);
  } else if (auto* l = std::get_if<NamesRef>(&ref)) {
    store(Kind::names, l->names);
    fill(p, l->options);
  }
  found.push_back(std::move(p));
}

void detail::Setter::visit(const std::string& path, const Spec& spec, Ref ref) {
  if (path != path_) return;
  matched = true;
  if (Refusal r = std::visit(Assign(path, spec, value_), ref); !r.message.empty()) refusal = std::move(r);
}

Value blend(const Value& from, const Value& to, double s) {
  if (s >= 1) return to;
  if (s <= 0) return from;
  const auto mix = [s](double a, double b) { return a + (b - a) * s; };
  const auto *a = std::get_if<double>(&from), *b = std::get_if<double>(&to);
  if (a && b) return mix(*a, *b);
  const auto *va = std::get_if<std::vector<double>>(&from), *vb = std::get_if<std::vector<double>>(&to);
  if (!va || !vb || va->size() != vb->size()) return from;
  std::vector<double> v(va->size());
  std::transform(va->begin(), va->end(), vb->begin(), v.begin(), mix);
  return v;
}

} // namespace flipbook
