// SPDX-License-Identifier: MIT
// Schemes as plain scalar code: written again they are those of the family to rounding, and what is wrong with them is
// found out.
#include "tests/property/cases.h"

#include "sim/diagnostics/propositions.h"
#include "sim/transfer/schemes.h"
#include "sim/transfer/transfer.h"

#include <algorithm>
#include <cmath>

namespace flipbook {
namespace {

/// AFLIP with its two limits: APIC at flip_ratio 0.
struct AgainScheme {
  static constexpr std::string_view name = "again", label = "AGAIN", summary = "AFLIP";
  static constexpr AffineMode remembers = AffineMode::full;
  double flip_ratio = 0, sign = 1;
  void describe(ParameterVisitor& v) { v.real({.name = "flip_ratio", .help = "", .min = 0, .max = 1}, flip_ratio); }

  template <int Dim> double paint(const ScalarParticle<Dim>& p, int a, const Vec<Dim, double>& r) const {
    double v = p.v[a];
    for (int b = 0; b < Dim; ++b) v += sign * p.C(a, b) * r[b];
    return v;
  }
  template <int Dim> void gather(ScalarParticle<Dim>& p, const ScalarSamples<Dim>& samples) const {
    for (int a = 0; a < Dim; ++a) {
      double v = flip_ratio * p.v[a];
      Vec<Dim, double> c = Vec<Dim, double>::Zero();
      for (const ScalarSample<Dim>& s : samples[a]) {
        v += s.w * (s.u - flip_ratio * s.u_old);
        c += s.fit * s.u;
      }
      p.v[a] = v;
      for (int b = 0; b < Dim; ++b) p.C(a, b) = c[b];
    }
  }
};
static_assert(Scheme<AgainScheme> && ScalarCode<AgainScheme> && !ScalarCode<Apic>);

/// The largest difference between the columns of two results, against the largest entry.
template <class Columns> double difference(const Columns& a, const Columns& b) {
  double worst = 0, largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t i = 0; i < a[c].size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(a[c][i]) - static_cast<double>(b[c][i])));
      largest = std::max(largest, std::abs(static_cast<double>(a[c][i])));
    }
  return worst / largest;
}

template <int Dim, class Real> struct Pair {
  using Field = Components<Dim, Real>;
  Threads threads{2};
  Trial<Dim, Real> trial{AffineMode::full, 300, 5, threads.pool};
  KernelName kernel;
  Layout layout;
  Corner family, again;

  Pair(KernelName k, Layout l, double flip_ratio)
      : kernel(k), layout(l), family{.mode = AffineMode::full, .flip_ratio = flip_ratio},
        again(corner_of(AgainScheme{.flip_ratio = flip_ratio})) {}

  void to_grid(const Corner& c, Field& m, Field& mu, const std::vector<std::uint8_t>* ballistic) {
    m.resize(trial.grid);
    mu.resize(trial.grid);
    p2g(c, kernel, layout, trial.grid, trial.particles, trial.order, m, mu, threads.pool, ballistic);
  }
  [[nodiscard]] std::vector<std::uint8_t> every_third() const {
    std::vector<std::uint8_t> marks(trial.particles.size());
    for (std::size_t p = 0; p < marks.size(); p += 3) marks[p] = 1;
    return marks;
  }
  void expect_equal(double bound) {
    const auto marks = every_third();
    Field m, mu, m2, mu2;
    to_grid(family, m, mu, &marks);
    to_grid(again, m2, mu2, &marks);
    EXPECT_LT(difference(m, m2), bound);
    EXPECT_LT(difference(mu, mu2), bound);

    const Field u = trial.random_field(1), u_old = trial.random_field(2);
    const auto both = [&](auto&& transfer) {
      Particles<Dim, Real> p = trial.particles, q = trial.particles;
      transfer(family, p);
      transfer(again, q);
      EXPECT_LT(difference(p.v, q.v), bound);
      EXPECT_LT(difference(p.A, q.A), 30 * bound); // near a plane of samples D^-1 makes roundings larger
    };
    auto& grid = trial.grid;
    auto& pool = threads.pool;
    both([&](const Corner& c, auto& p) { g2p(c, kernel, layout, grid, u, u_old, p, pool, &marks); });
    both([&](const Corner& c, auto& p) { g2p_increment(c, kernel, layout, grid, u, p, pool, &marks); });
    both([&](const Corner& c, auto& p) { gather_affine(c, kernel, layout, grid, u, p, pool); });
  }
};

TEST(ScalarSchemes, WrittenAgainTheyAreTheFamilysToRounding) {
  for (const KernelName k : kernels)
    for (const Layout l : layouts)
      for (const double flip_ratio : {0.0, 0.7}) {
        SCOPED_TRACE(std::string(kernel_options()[static_cast<std::size_t>(k)].name) +
                     (l == Layout::mac ? ", mac, " : ", nodes, ") + std::to_string(flip_ratio));
        Pair<2, double>(k, l, flip_ratio).expect_equal(1e-13);
        Pair<3, double>(k, l, flip_ratio).expect_equal(1e-13);
        Pair<2, float>(k, l, flip_ratio).expect_equal(1e-5);
        Pair<3, float>(k, l, flip_ratio).expect_equal(1e-5);
      }
}

TEST(ScalarSchemes, ParticlesMustRememberWhatTheSchemeNeeds) {
  Pair<2, double> pair(KernelName::linear, Layout::mac, 0);
  pair.trial.particles.set_mode(AffineMode::none);
  Components<2, double> m, mu;
  EXPECT_THROW(pair.to_grid(pair.again, m, mu, nullptr), std::logic_error);
}

using Results = std::vector<PropositionResult>;
bool holds(const Results& card, const std::string& id, const std::string& begins = "") {
  bool all = true, found = false;
  for (const PropositionResult& r : card)
    if (r.id == id && r.statement.starts_with(begins)) all = all && r.passed, found = true;
  EXPECT_TRUE(found) << id;
  return all;
}

TEST(ScalarSchemes, AreGradedByThePropositions) {
  Threads t(2);
  const Results apic = grade("AGAIN", corner_of(AgainScheme{}), 1, t.pool);
  for (const PropositionResult& r : apic) {
    EXPECT_EQ(r.standing, Standing::graded);
    EXPECT_TRUE(r.passed) << r.id << " " << r.statement << ": " << r.error;
  }
  const Results flip = grade("AGAIN", corner_of(AgainScheme{.flip_ratio = 1}), 1, t.pool);
  for (const char* id : {"M.1", "5.2", "5.3", "5.4", "C.2", "E.1"}) EXPECT_TRUE(holds(flip, id)) << id;
  for (const char* id : {"5.5", "C.3", "E.2", "4.1", "5.1"}) EXPECT_FALSE(holds(flip, id)) << id;
  EXPECT_FALSE(holds(flip, "E.2", "nor in G2P from an idle grid"));

  // The sign of the affine offset reversed: momentum is none the wiser.
  const Results wrong = grade("AGAIN", corner_of(AgainScheme{.sign = -1}), 1, t.pool);
  for (const char* id : {"M.1", "5.2", "5.3", "5.5"}) EXPECT_TRUE(holds(wrong, id)) << id;
  for (const char* id : {"5.4", "4.1", "5.1", "C.3"}) EXPECT_FALSE(holds(wrong, id)) << id;
}

TEST(ScalarSchemes, ReportCardsAnswerToASchemeOfWhichNothingIsClaimed) {
  Threads t(2);
  const auto run = [&](std::vector<std::string> only) { return run_propositions({.only = std::move(only)}, t.pool); };
  const auto graded = [](const PropositionResult& r) { return r.standing == Standing::graded; };
  const Results xpic = run({"xpic", "5."}), apic = run({"apic", "5."}), card = run({"graded", "apic", "5."});
  EXPECT_TRUE(std::all_of(xpic.begin(), xpic.end(), graded));
  EXPECT_TRUE(holds(xpic, "5.3"));
  EXPECT_FALSE(holds(xpic, "5.5"));
  EXPECT_TRUE(std::none_of(apic.begin(), apic.end(), graded));
  EXPECT_TRUE(std::all_of(card.begin(), card.end(), graded));
  EXPECT_TRUE(std::all_of(card.begin(), card.end(), [](const auto& r) { return r.passed; }));
}

} // namespace
} // namespace flipbook
