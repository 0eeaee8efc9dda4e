// SPDX-License-Identifier: MIT
#include "tests/physics/tutorial_oracle.h"

namespace flipbook::test {

void OracleBox::resize(int x, int y, int z) {
  nx = x;
  ny = y;
  nz = z;
  values.assign(static_cast<std::size_t>(x) * static_cast<std::size_t>(y) * static_cast<std::size_t>(z), 0.0);
}

double& OracleBox::operator()(int i, int j, int k) {
  return values.at(static_cast<std::size_t>((i * ny + j) * nz + k));
}

double OracleBox::operator()(int i, int j, int k) const {
  return values.at(static_cast<std::size_t>((i * ny + j) * nz + k));
}

TutorialOracle::TutorialOracle(const int res[3], double h, const double lc[3], double dt, double flip_ratio,
                               std::vector<OracleParticle> given)
    : particles(std::move(given)), res_{res[0], res[1], res[2]}, h_(h), lc_{lc[0], lc[1], lc[2]}, dt_(dt),
      flip_ratio_(flip_ratio) {
  splat();
}

void TutorialOracle::step() {
  advect();
  splat();
  gravity();
  pressure();
  grid_to_particles();
}

void TutorialOracle::locate(int axis, const double x[3], int index[3], double weight[3]) const {
  for (int a = 0; a < 3; ++a) {
    const double shift = a == axis ? 0.0 : h_ / 2;
    const double q = ((x[a] - lc_[a]) - shift) / h_;
    index[a] = static_cast<int>(q);
    weight[a] = q - index[a];
  }
}

double TutorialOracle::interpolate(int axis, const OracleBox& f, const double x[3]) const {
  int n[3];
  double a[3];
  locate(axis, x, n, a);
  const int i = n[0], j = n[1], k = n[2];
  return (1 - a[0]) * (1 - a[1]) * (1 - a[2]) * f(i, j, k) + (1 - a[0]) * (1 - a[1]) * a[2] * f(i, j, k + 1) +
         (1 - a[0]) * a[1] * (1 - a[2]) * f(i, j + 1, k) + (1 - a[0]) * a[1] * a[2] * f(i, j + 1, k + 1) +
         a[0] * (1 - a[1]) * (1 - a[2]) * f(i + 1, j, k) + a[0] * (1 - a[1]) * a[2] * f(i + 1, j, k + 1) +
         a[0] * a[1] * (1 - a[2]) * f(i + 1, j + 1, k) + a[0] * a[1] * a[2] * f(i + 1, j + 1, k + 1);
}

void TutorialOracle::advect() {
  for (OracleParticle& p : particles) {
    const double velocity[3] = {interpolate(0, u, p.x), interpolate(1, v, p.x), interpolate(2, w, p.x)};
    for (int a = 0; a < 3; ++a) {
      const double uc = lc_[a] + res_[a] * h_;
      p.x[a] += dt_ * velocity[a];
      if (p.x[a] < lc_[a] + h_ + 1e-4) p.x[a] = lc_[a] + h_ + 1e-4;
      if (p.x[a] > uc - h_ - 1e-4) p.x[a] = uc - h_ - 1e-4;
    }
  }
}

void TutorialOracle::splat(int axis, OracleBox& velocity, OracleBox& weight) {
  velocity.resize(res_[0] + (axis == 0), res_[1] + (axis == 1), res_[2] + (axis == 2));
  weight = velocity;
  for (const OracleParticle& p : particles) {
    int n[3];
    double a[3];
    locate(axis, p.x, n, a);
    for (int di = 0; di < 2; ++di)
      for (int dj = 0; dj < 2; ++dj)
        for (int dk = 0; dk < 2; ++dk) {
          const double part = (di ? a[0] : 1 - a[0]) * (dj ? a[1] : 1 - a[1]) * (dk ? a[2] : 1 - a[2]);
          velocity(n[0] + di, n[1] + dj, n[2] + dk) += part * p.v[axis];
          weight(n[0] + di, n[1] + dj, n[2] + dk) += part;
        }
  }
  for (int i = 0; i < velocity.nx; ++i)
    for (int j = 0; j < velocity.ny; ++j)
      for (int k = 0; k < velocity.nz; ++k)
        velocity(i, j, k) = weight(i, j, k) >= 1e-6 ? velocity(i, j, k) / weight(i, j, k) : 0.0;
}

void TutorialOracle::splat() {
  has_particle_.resize(res_[0], res_[1], res_[2]);
  for (const OracleParticle& p : particles) {
    int c[3];
    for (int a = 0; a < 3; ++a) c[a] = static_cast<int>((p.x[a] - lc_[a]) / h_);
    has_particle_(c[0], c[1], c[2]) = 1;
  }
  splat(0, u, weight_u_);
  splat(1, v, weight_v_);
  splat(2, w, weight_w_);
  u_old_ = u;
  v_old_ = v;
  w_old_ = w;
  close();
}

TutorialOracle::Cell TutorialOracle::cell(int i, int j, int k) const {
  if (i == 0 || j == 0 || k == 0 || i == res_[0] - 1 || j == res_[1] - 1 || k == res_[2] - 1) return solid;
  return has_particle_(i, j, k) > 0 ? fluid : empty;
}

void TutorialOracle::close() {
  const int nx = res_[0], ny = res_[1], nz = res_[2];
  for (int j = 0; j < ny; ++j)
    for (int k = 0; k < nz; ++k) u(0, j, k) = u(1, j, k) = u(nx - 1, j, k) = u(nx, j, k) = 0;
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k < nz; ++k) v(i, 0, k) = v(i, 1, k) = v(i, ny - 1, k) = v(i, ny, k) = 0;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) w(i, j, 0) = w(i, j, 1) = w(i, j, nz - 1) = w(i, j, nz) = 0;

  for (int i = 0; i <= nx; ++i)
    for (int k = 0; k < nz; ++k) u(i, 0, k) = u(i, 1, k), u(i, ny - 1, k) = u(i, ny - 2, k);
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j < ny; ++j) u(i, j, 0) = u(i, j, 1), u(i, j, nz - 1) = u(i, j, nz - 2);
  for (int j = 0; j <= ny; ++j)
    for (int k = 0; k < nz; ++k) v(0, j, k) = v(1, j, k), v(nx - 1, j, k) = v(nx - 2, j, k);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j <= ny; ++j) v(i, j, 0) = v(i, j, 1), v(i, j, nz - 1) = v(i, j, nz - 2);
  for (int j = 0; j < ny; ++j)
    for (int k = 0; k <= nz; ++k) w(0, j, k) = w(1, j, k), w(nx - 1, j, k) = w(nx - 2, j, k);
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k <= nz; ++k) w(i, 0, k) = w(i, 1, k), w(i, ny - 1, k) = w(i, ny - 2, k);
}

void TutorialOracle::gravity() {
  for (double& face : w.values) face -= 9.80665 * dt_;
  close();
}

/// q = A d on the fluid cells.
void TutorialOracle::multiply(const OracleBox& d, OracleBox& q) const {
  for (int i = 1; i < res_[0] - 1; ++i)
    for (int j = 1; j < res_[1] - 1; ++j)
      for (int k = 1; k < res_[2] - 1; ++k) {
        if (cell(i, j, k) != fluid) continue;
        const int neighbours[6][3] = {{i - 1, j, k}, {i + 1, j, k}, {i, j - 1, k},
                                      {i, j + 1, k}, {i, j, k - 1}, {i, j, k + 1}};
        double sum = 0;
        for (const auto& n : neighbours) {
          const Cell kind = cell(n[0], n[1], n[2]);
          if (kind != solid) sum += d(i, j, k);
          if (kind == fluid) sum -= d(n[0], n[1], n[2]);
        }
        q(i, j, k) = sum;
      }
}

double TutorialOracle::dot(const OracleBox& a, const OracleBox& b) const {
  double sum = 0;
  for (int i = 0; i < res_[0]; ++i)
    for (int j = 0; j < res_[1]; ++j)
      for (int k = 0; k < res_[2]; ++k) sum += a(i, j, k) * b(i, j, k);
  return sum;
}

void TutorialOracle::pressure() {
  OracleBox r, d, q, p;
  for (OracleBox* box : {&r, &q, &p}) box->resize(res_[0], res_[1], res_[2]);
  for (int i = 1; i < res_[0] - 1; ++i)
    for (int j = 1; j < res_[1] - 1; ++j)
      for (int k = 1; k < res_[2] - 1; ++k)
        if (cell(i, j, k) == fluid)
          r(i, j, k) = -(u(i + 1, j, k) - u(i, j, k) + v(i, j + 1, k) - v(i, j, k) + w(i, j, k + 1) - w(i, j, k));
  d = r;
  double sigma = dot(r, r);
  const double tolerance = 1e-6 * sigma;
  for (iterations = 0; sigma > tolerance && iterations < 1000; ++iterations) {
    multiply(d, q);
    const double alpha = sigma / dot(d, q);
    for (std::size_t c = 0; c < p.values.size(); ++c) {
      p.values[c] += alpha * d.values[c];
      r.values[c] -= alpha * q.values[c];
    }
    const double before = sigma;
    sigma = dot(r, r);
    for (std::size_t c = 0; c < p.values.size(); ++c) d.values[c] = r.values[c] + sigma / before * d.values[c];
  }
  for (int i = 1; i < res_[0]; ++i)
    for (int j = 1; j < res_[1]; ++j)
      for (int k = 1; k < res_[2]; ++k) {
        if (cell(i, j, k) == solid) continue;
        if (cell(i - 1, j, k) != solid) u(i, j, k) -= p(i, j, k) - p(i - 1, j, k);
        if (cell(i, j - 1, k) != solid) v(i, j, k) -= p(i, j, k) - p(i, j - 1, k);
        if (cell(i, j, k - 1) != solid) w(i, j, k) -= p(i, j, k) - p(i, j, k - 1);
      }
}

void TutorialOracle::grid_to_particles() {
  const OracleBox* now[3] = {&u, &v, &w};
  const OracleBox* old[3] = {&u_old_, &v_old_, &w_old_};
  for (OracleParticle& p : particles)
    for (int a = 0; a < 3; ++a)
      p.v[a] = interpolate(a, *now[a], p.x) + flip_ratio_ * (p.v[a] - interpolate(a, *old[a], p.x));
}

double TutorialOracle::kinetic_energy() const {
  double sum = 0;
  for (const OracleParticle& p : particles) sum += (p.v[0] * p.v[0] + p.v[1] * p.v[1] + p.v[2] * p.v[2]) / 2;
  return sum;
}

double TutorialOracle::centre(int axis) const {
  double sum = 0;
  for (const OracleParticle& p : particles) sum += p.x[axis];
  return sum / static_cast<double>(particles.size());
}

} // namespace flipbook::test
