// SPDX-License-Identifier: MIT
#include "tests/golden/ledgers.h"

#include "tests/golden/pictures.h"

#include <memory>
#include <stdexcept>

namespace flipbook::test {
namespace {

using Claim = LedgerTable::Claim;

/// Calls f(entry) for what the names mean; the stage is one, the quantity may be the beginning of several.
template <class F> void at(const LedgerTable& l, const std::string& stage, const std::string& quantity, F&& f) {
  bool found = false;
  for (std::size_t s = 0; s < l.stages.size(); ++s)
    for (std::size_t q = 0; q < l.quantities.size(); ++q)
      if (l.stages[s].name == stage && l.quantities[q].name.starts_with(quantity)) f(l.at(s, q)), found = true;
  if (!found) throw std::runtime_error("the ledger has no " + stage + ", " + quantity);
}

} // namespace

LedgerTable empty_ledger(int dim) {
  LedgerTable l;
  const std::string per = dim == 2 ? "/m" : "";
  const auto add = [&](const std::string& name, const std::string& label, const std::string& unit) {
    l.quantities.push_back({name, label, unit + per, 0, 0, true});
  };
  add("mass", "m", "kg");
  for (const char axis : std::string("xyz").substr(0, static_cast<std::size_t>(dim)))
    add(std::string("momentum_") + axis, std::string("p_") + axis, "kg m/s");
  for (const char axis : std::string(dim == 2 ? "z" : "xyz"))
    add(std::string("angular_momentum_") + axis, std::string("L_") + axis, "kg m^2/s");
  add("kinetic", "kinetic", "J");
  add("potential", "potential", "J");
  l.stages = {{"p2g", "P2G"},     {"free_faces", "free faces"}, {"forces", "forces"},
              {"walls", "walls"}, {"projection", "projection"}, {"extrapolation", "extrapolation"},
              {"g2p", "G2P"},     {"advection", "advection"}};
  const std::size_t entries = l.stages.size() * l.quantities.size();
  l.step.assign(entries, 0);
  l.total.assign(entries, 0);
  l.claims.assign(entries, Claim::none);
  l.quantities[0].start = l.quantities[0].now = 320;
  return l;
}

void set_change(LedgerTable& l, const std::string& stage, const std::string& quantity, double change) {
  at(l, stage, quantity, [&](std::size_t i) { l.total[i] = l.step[i] = change; });
}

void set_claim(LedgerTable& l, const std::string& stage, const std::string& quantity, Claim claim) {
  at(l, stage, quantity, [&](std::size_t i) { l.claims[i] = claim; });
}

void close(LedgerTable& l) {
  for (std::size_t q = 0; q < l.quantities.size(); ++q) {
    l.quantities[q].now = l.quantities[q].start;
    for (std::size_t s = 0; s < l.stages.size(); ++s) l.quantities[q].now += l.total[l.at(s, q)];
  }
}

LedgerTable dam_ledger(int dim, bool affine) {
  LedgerTable l = empty_ledger(dim);
  for (const char* stage : {"p2g", "g2p"})
    for (const char* quantity : {"mass", "momentum_", "angular_momentum_", "kinetic"})
      set_claim(l, stage, quantity, Claim::holds);
  if (!affine) set_claim(l, "g2p", "angular_momentum_", Claim::fails);
  set_change(l, "p2g", "momentum_", affine ? 1e-13 : -2e-5); // rounding, in double and in single
  set_change(l, "p2g", "angular_momentum_", -1e-13);
  set_change(l, "p2g", "kinetic", affine ? -6.1 : 0);
  set_change(l, "forces", "momentum_y", -1412);
  set_change(l, "forces", "angular_momentum_z", 91.6);
  set_change(l, "forces", "kinetic", 761);
  set_change(l, "walls", "momentum_", 0.003);
  set_change(l, "projection", "momentum_x", 402.3);
  set_change(l, "projection", "momentum_y", 1389);
  set_change(l, "projection", "angular_momentum_z", -228.4);
  set_change(l, "projection", "kinetic", -3.4);
  set_change(l, "extrapolation", "kinetic", 0.12);
  set_change(l, "g2p", "angular_momentum_", affine ? 2e-12 : -17.9);
  set_change(l, "g2p", "kinetic", affine ? -2.3 : -41.7);
  set_change(l, "advection", "potential", -738.6);
  for (LedgerTable::Quantity& q : l.quantities)
    if (q.name == "potential") q.start = 1255.7;
  l.energy_in = l.step_in = 761;
  close(l);
  return l;
}

LedgerTable vortex_ledger() {
  LedgerTable l = empty_ledger(2);
  for (LedgerTable::Quantity& q : l.quantities) {
    if (q.name == "mass") q.start = 1;
    if (q.name == "kinetic") q.start = 0.25;
    if (q.name == "angular_momentum_z") q.defined = false;
  }
  for (const char* stage : {"p2g", "g2p"}) set_claim(l, stage, "momentum_", Claim::holds);
  set_claim(l, "p2g", "kinetic", Claim::holds);
  set_change(l, "p2g", "kinetic", -5.8125);
  set_change(l, "projection", "kinetic", -0.0041);
  set_change(l, "g2p", "kinetic", 5.809);
  set_change(l, "p2g", "momentum_", 3e-17);
  l.energy_in = l.step_in = 0.25;
  close(l);
  return l;
}

render::Frame ledger_frame(std::size_t panes) {
  render::Frame f = dam_frame(panes);
  for (std::size_t i = 0; i < panes; ++i) {
    auto s = std::make_shared<Snapshot>(*f.panes[i].snapshot);
    s->ledger = std::make_shared<LedgerTable>(dam_ledger(s->dim, i % 3 == 2));
    s->notes = {
        "Particles move with the grid's velocity (rk2, rk3), not with their own: angular momentum need not hold "
        "exactly."};
    if (i % 3 == 0) s->notes.emplace_back("PIC damps every rotation: angular momentum is not expected to hold.");
    f.panes[i].snapshot = s;
  }
  return f;
}

} // namespace flipbook::test
