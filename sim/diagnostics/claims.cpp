// SPDX-License-Identifier: MIT
#include "sim/diagnostics/claims.h"

#include "sim/transfer/schemes.h"

#include <vector>

namespace flipbook {
namespace {

using enum Quantity;
using enum Check;

const Corner pic = Pic{}.corner(), rpic = Rpic{}.corner(), apic = Apic{}.corner();

/// Sections 4 and 5 of the report, in its words and order.
const Claim report[] = {
    {"4.1", "a rigid field survives G2P and P2G, dt = 0", "RPIC", rpic, field, round_trips},
    {"4.2", "linear momentum, particles to grid", "RPIC", rpic, momentum, to_grid},
    {"4.3", "linear momentum, grid to particles", "RPIC", rpic, momentum, to_particles},
    {"4.4", "angular momentum, particles to grid", "RPIC", rpic, angular, to_grid},
    {"4.5", "angular momentum, grid to particles, over dt", "RPIC", rpic, angular, to_particles},
    {"5.1", "an affine field survives G2P and P2G, dt = 0", "APIC", apic, field, round_trips},
    {"5.2", "linear momentum, particles to grid", "APIC", apic, momentum, to_grid},
    {"5.3", "linear momentum, grid to particles", "APIC", apic, momentum, to_particles},
    {"5.4", "angular momentum, particles to grid", "APIC", apic, angular, to_grid},
    {"5.5", "angular momentum, grid to particles, over dt", "APIC", apic, angular, to_particles},
};

struct Named {
  std::string_view name;
  Corner corner;
};
const Named spinning[] = {{"RPIC", rpic}, {"APIC", apic}}, all_three[] = {{"PIC", pic}, {"RPIC", rpic}, {"APIC", apic}};

/// What the report leaves to the reader.
void add_ours(std::vector<Claim>& all) {
  const auto add = [&](const auto& schemes, std::string_view id, std::string_view statement, Quantity q, Check c,
                       int cycles = 1) {
    for (const Named& s : schemes) all.push_back({id, statement, s.name, s.corner, q, c, cycles});
  };
  add(spinning, "T.1", "P2G is the report's (1), (3), summed plainly", transfer, plain_p2g);
  add(spinning, "T.2", "G2P is the report's (2), (4), summed plainly", transfer, plain_g2p);
  add(all_three, "M.1", "mass, particles to grid", mass, to_grid);
  add(all_three, "E.1", "kinetic energy never rises in P2G (-: it falls)", energy, to_grid);
  add(all_three, "E.2", "kinetic energy never rises in G2P (-: it falls)", energy, to_particles);
  add(spinning, "E.3", "a rigid or affine field keeps its energy", energy, own_field);
  add(spinning, "C.1", "rigid or affine field, 10 cycles, dt = 0", field, round_trips, 10);
  add(spinning, "C.1", "rigid or affine field, 100 cycles, dt = 0", field, round_trips, 100);
  add(spinning, "C.2", "linear momentum after 10 cycles", momentum, Check::cycles, 10);
  add(spinning, "C.2", "linear momentum after 100 cycles", momentum, Check::cycles, 100);
  add(spinning, "C.3", "angular momentum after 10 cycles", angular, Check::cycles, 10);
  add(spinning, "C.3", "angular momentum after 100 cycles", angular, Check::cycles, 100);
}

/// What must fail. A floor is a fifth or less of the least error over the seeds 1 to 50, so that it shows a transfer
/// that conserves after all and not an unlucky seed.
void add_faulty(std::vector<Claim>& all) {
  const Corner flip = Flip{}.corner(), aflip = Aflip{}.corner(), skew = Rpic{.form = Rpic::Form::skew}.corner();
  const auto add = [&](std::string_view id, std::string_view statement, std::string_view scheme, const Corner& corner,
                       Quantity q, Check c, double floor, int cycles = 1) {
    all.push_back({id, statement, scheme, corner, q, c, cycles, floor});
  };
  add("5.5", "velocity without a gradient", "PIC", pic, angular, to_particles, 5e-3);
  add("5.5", "velocity without a gradient, FLIP's update", "FLIP 1", flip, angular, to_particles, 4e-3);
  add("5.5", "C with FLIP's update", "AFLIP 1", aflip, angular, to_particles, 3e-3);
  add("4.5", "skew part of C for K^-1 L, linear kernel", "RPIC skew", skew, angular, to_particles, 1e-3);
  add("5.5", "C = sum v (grad w)^T, quadratic and cubic kernel", "APIC", apic, angular, gradient_form, 5e-4);
  add("5.5", "particles moved by the midpoint rule", "APIC", apic, angular, midpoint_move, 2e-4);
  add("5.2", "kernel clamped at the walls: linear momentum", "APIC", apic, momentum, clamped_kernel, 1e-3);
  add("5.4", "kernel clamped at the walls: angular momentum", "APIC", apic, angular, clamped_kernel, 1e-3);
  add("C.3", "omega kept while D_p changes, linear kernel", "RPIC", rpic, angular, carried_gradient, 4e-4, 10);
  add("C.3", "C kept while D_p changes, linear kernel", "APIC", apic, angular, carried_gradient, 8e-4, 10);
  add("E.2", "kinetic energy in G2P, from an idle grid", "FLIP 1", flip, energy, idle_grid, 4e-2);
  add("E.2", "kinetic energy in G2P, from an idle grid", "AFLIP 1", aflip, energy, idle_grid, 3e-2);
}

} // namespace

std::vector<Claim> report_card(std::string_view scheme, const Corner& corner) {
  std::vector<Claim> card;
  const auto ask = [&](std::string_view id, std::string_view statement, Quantity q, Check c, int cycles = 1) {
    card.push_back({id, statement, scheme, corner, q, c, cycles, 0, true});
  };
  ask("4.1", "a rigid field survives G2P and P2G, dt = 0", field, rigid_trips);
  ask("5.1", "an affine field survives G2P and P2G, dt = 0", field, affine_trips);
  ask("M.1", "mass, particles to grid", mass, to_grid);
  ask("5.2", "linear momentum, particles to grid", momentum, to_grid);
  ask("5.3", "linear momentum, grid to particles", momentum, to_particles);
  ask("5.4", "angular momentum, particles to grid", angular, to_grid);
  ask("5.5", "angular momentum, grid to particles, over dt", angular, to_particles);
  ask("E.1", "kinetic energy never rises in P2G (-: it falls)", energy, to_grid);
  ask("E.2", "kinetic energy never rises in G2P (-: it falls)", energy, to_particles);
  ask("E.2", "nor in G2P from an idle grid", energy, idle_grid);
  ask("C.2", "linear momentum after 10 cycles", momentum, Check::cycles, 10);
  ask("C.3", "angular momentum after 10 cycles", angular, Check::cycles, 10);
  return card;
}

bool Claim::applies(KernelName kernel) const {
  if (graded) return true;
  const bool linear = kernel == KernelName::linear;
  switch (check) {
  case carried_gradient: return linear;
  case gradient_form: return !linear; // with the linear kernel D^-1 w r is grad w
  case clamped_kernel:
    return !linear; // on nodes the linear kernel reaches none beyond a wall; on faces too few are left
  default: return !corner.skew || linear; // where D is a multiple of the identity, the skew part of C is K^-1 L
  }
}

std::span<const Claim> claims() {
  static const auto all = [] {
    std::vector<Claim> made(std::begin(report), std::end(report));
    add_ours(made);
    add_faulty(made);
    std::apply(
        [&]<class... S>(const S&... scheme) {
          for (const auto& card : {report_card(S::label, corner_of(scheme))...})
            made.insert(made.end(), card.begin(), card.end());
        },
        Schemes{});
    return made;
  }();
  return all;
}

} // namespace flipbook
