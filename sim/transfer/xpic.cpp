// SPDX-License-Identifier: MIT
#include "sim/transfer/xpic.h"

#include "sim/transfer/transfer.h"

namespace flipbook {
namespace {

constexpr std::int64_t samples_per_chunk = 1 << 15;

template <int Dim, class Real, class Body>
void each_sample(const Components<Dim, Real>& field, Pool& pool, Body&& body) {
  for (std::size_t a = 0; a < Dim; ++a)
    pool.ranges(static_cast<std::int64_t>(field[a].size()), samples_per_chunk,
                [&](std::int64_t begin, std::int64_t end) {
                  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) body(a, i);
                });
}

} // namespace

template <int Dim, class Real>
const Components<Dim, Real>&
XpicTerms<Dim, Real>::operator()(int terms, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                                 const Particles<Dim, Real>& particles, const CellOrder<Dim>& order,
                                 const Components<Dim, Real>& u_old, const Fold& fold, Pool& pool,
                                 const std::vector<std::uint8_t>* ballistic) {
  sum_.resize(grid);
  if (terms < 2) return sum_;
  carrier_ = particles;
  carrier_.set_mode(AffineMode::none);
  delta_ = u_old;
  mass_.resize(grid);
  back_.resize(grid);
  const Corner pic{};
  for (int l = 2; l <= terms; ++l) {
    g2p(pic, kernel, layout, grid, delta_, delta_, carrier_, pool, ballistic);
    p2g(pic, kernel, layout, grid, carrier_, order, mass_, back_, pool, ballistic);
    fold(mass_);
    fold(back_);
    to_velocity(mass_, back_, pool);
    each_sample(delta_, pool, [&](std::size_t a, std::size_t i) {
      // A sample without mass has no part in S+: it stays out of the terms.
      delta_[a][i] = mass_[a][i] > 0 ? delta_[a][i] - back_[a][i] : Real(0);
      sum_[a][i] += delta_[a][i];
    });
  }
  return sum_;
}

template <int Dim, class Real>
void XpicTerms<Dim, Real>::gather(const Corner& corner, KernelName kernel, Layout layout, const Grid<Dim>& grid,
                                  const Components<Dim, Real>& u, const Components<Dim, Real>& u_old,
                                  const CellOrder<Dim>& order, const Fold& fold, Particles<Dim, Real>& particles,
                                  Pool& pool, const std::vector<std::uint8_t>* ballistic) {
  if (corner.order <= 1) return g2p(corner, kernel, layout, grid, u, u_old, particles, pool, ballistic);
  const Components<Dim, Real>& terms =
      (*this)(corner.order, kernel, layout, grid, particles, order, u_old, fold, pool, ballistic);
  filtered_ = u;
  each_sample(filtered_, pool, [&](std::size_t a, std::size_t i) { filtered_[a][i] += terms[a][i]; });
  g2p(corner, kernel, layout, grid, filtered_, u_old, particles, pool, ballistic);
}

template class XpicTerms<2, float>;
template class XpicTerms<2, double>;
template class XpicTerms<3, float>;
template class XpicTerms<3, double>;

} // namespace flipbook
