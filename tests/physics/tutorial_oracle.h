// SPDX-License-Identifier: MIT
// The algorithm of the fluid notes written down a second time, as plainly as possible: particles as structures, grids
// as boxes of doubles, loops over i, j, k. It shares nothing with sim/tutorial, which it is there to check.
#pragma once

#include <cstddef>
#include <vector>

namespace flipbook::test {

/// A box of numbers, k fastest.
struct OracleBox {
  int nx = 0, ny = 0, nz = 0;
  std::vector<double> values;
  void resize(int x, int y, int z);
  double& operator()(int i, int j, int k);
  double operator()(int i, int j, int k) const;
};

struct OracleParticle {
  double x[3], v[3];
};

class TutorialOracle {
public:
  TutorialOracle(const int res[3], double h, const double lc[3], double dt, double flip_ratio,
                 std::vector<OracleParticle> particles);
  void step();

  std::vector<OracleParticle> particles;
  OracleBox u, v, w; ///< on the faces across x, y, z
  int iterations = 0;

  [[nodiscard]] double kinetic_energy() const; ///< per unit of mass of a particle
  [[nodiscard]] double centre(int axis) const;

private:
  enum Cell { empty, fluid, solid };
  void advect();
  void splat();
  void close();
  void gravity();
  void pressure();
  void grid_to_particles();
  [[nodiscard]] Cell cell(int i, int j, int k) const;
  void splat(int axis, OracleBox& velocity, OracleBox& weight);
  [[nodiscard]] double interpolate(int axis, const OracleBox& velocity, const double x[3]) const;
  void locate(int axis, const double x[3], int index[3], double weight[3]) const;
  void multiply(const OracleBox& d, OracleBox& q) const;
  [[nodiscard]] double dot(const OracleBox& a, const OracleBox& b) const;

  int res_[3];
  double h_, lc_[3], dt_, flip_ratio_;
  OracleBox u_old_, v_old_, w_old_, weight_u_, weight_v_, weight_w_, has_particle_;
};

} // namespace flipbook::test
