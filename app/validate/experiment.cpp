// SPDX-License-Identifier: MIT
#include "app/validate/experiment.h"

#include "sim/scene/read_scene.h"

namespace flipbook::app {

TransferSettings transfer_of(const std::string& scheme) {
  const SchemeRequest request = parse_scheme(scheme);
  Settings settings;
  settings.transfer.scheme = request.scheme;
  if (request.number)
    if (const Refusal r = set_parameter(settings, request.number->first, request.number->second); !r.message.empty())
      throw UserError(scheme + ": " + r.message);
  return settings.transfer;
}

std::string scheme_title(const std::string& scheme) {
  return transfer_of(scheme).title();
}

std::optional<double> viscous_share(const std::string& scheme) {
  const TransferSettings transfer = transfer_of(scheme);
  const std::string name = transfer.name();
  const Corner corner = transfer.corner();
  if (name == "pic") return 1;
  if (name == "rpic" && corner.affine == 1) return 0.5;
  if (name == "flip" && corner.flip_ratio < 1) return 1 - corner.flip_ratio;
  return std::nullopt;
}

std::unique_ptr<Simulation> start(const std::string& scene, const Setup& setup, int seed, Pool& pool) {
  const SchemeRequest request = parse_scheme(setup.scheme);
  const TransferSettings transfer = transfer_of(setup.scheme);
  const std::array<double, 3> size = parse_scene(scene, "validate").settings.grid.size;
  const double along_y = setup.cells * size[1] / size[0];
  if (std::abs(along_y - std::round(along_y)) > 1e-6)
    throw UserError(std::to_string(setup.cells) + " cells along x would not be cubic in a domain of " +
                    to_toml(Value(size[0])) + " x " + to_toml(Value(size[1])) + " m");
  const std::vector<double> cells{static_cast<double>(setup.cells), std::round(along_y)};
  std::vector<Assignment> changes{assign("precision", "double"),
                                  assign("pressure.tolerance", 1e-8),
                                  assign("grid.cells", cells),
                                  assign("time.cfl", setup.cfl),
                                  assign("seeding.seed", static_cast<double>(seed)),
                                  assign("transfer.scheme", transfer.name())};
  if (request.number) changes.push_back(assign(request.number->first, request.number->second));
  changes.insert(changes.end(), setup.more.begin(), setup.more.end());
  return make_simulation(parse_scene(scene, "validate", changes), pool);
}

void advance(Simulation& sim, double time, double dt) {
  constexpr double slack = 1e-12;
  while (sim.time() < time * (1 - slack)) {
    const double left = time - sim.time(), most = dt > 0 ? dt : sim.max_dt();
    sim.step(left / std::ceil(left / most * (1 - slack)));
  }
}

} // namespace flipbook::app
