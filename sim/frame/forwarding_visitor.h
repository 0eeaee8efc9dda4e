// SPDX-License-Identifier: MIT
// Hands parameters on to another visitor, some of them with a changed specification, some not at all.
#pragma once

#include "sim/frame/parameters.h"

namespace flipbook {

class ForwardingVisitor : public ParameterVisitor {
public:
  explicit ForwardingVisitor(ParameterVisitor& to) : to_(to) {}

protected:
  /// Changes what the other visitor is told about a parameter; false: it is not told of it.
  virtual bool change(const std::string& path, Spec& spec) = 0;

  void visit(const std::string& path, const Spec& spec, Ref ref) final {
    Spec s = spec;
    s.name = path;
    if (change(path, s)) std::visit([&](auto& r) { pass(s, r); }, ref);
  }

private:
  void pass(const Spec& s, bool* x) { to_.flag(s, *x); }
  void pass(const Spec& s, double* x) { to_.real(s, *x); }
  void pass(const Spec& s, int* x) { to_.integer(s, *x); }
  void pass(const Spec& s, ChoiceRef& x) { to_.choice(s, x.index, x.options); }
  void pass(const Spec& s, std::string* x) { to_.text(s, *x); }
  void pass(const Spec& s, std::span<double> x) { to_.reals(s, x); }
  void pass(const Spec& s, std::span<int> x) { to_.integers(s, x); }
  void pass(const Spec& s, NamesRef& x) { to_.names(s, x.names, x.options); }

  ParameterVisitor& to_;
};

} // namespace flipbook
