// SPDX-License-Identifier: MIT
#include "sim/museum/museum.h"

#include "sim/core/random.h"
#include "sim/fluid/fluid_solver.h"
#include "sim/frame/errors.h"
#include "sim/museum/mistakes.h"
#include "sim/scene/seeding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <numeric>
#include <optional>

namespace flipbook::museum {
namespace {

/// A step this much shorter than the first says that the particles fly apart.
constexpr double shortest_share = 1e-3;

class Mistaken final : public Simulation {
public:
  /// `dt` is what the mistake reads as the length of the step.
  Mistaken(std::unique_ptr<Simulation> solver, std::unique_ptr<double> dt, const Hung& hung)
      : dt_(std::move(dt)), solver_(std::move(solver)), hung_(hung), shortest_(shortest_share * solver_->max_dt()) {}

  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::uint64_t steps() const override { return solver_->steps(); }
  [[nodiscard]] double max_dt() const override { return std::numeric_limits<double>::infinity(); }
  void step(double dt) override;

  [[nodiscard]] std::vector<Parameter> parameters() const override { return solver_->parameters(); }
  [[nodiscard]] Refusal set(std::string_view path, const Value& value) override {
    if (path == "time.splitting") return {"the mistakes of the museum belong to time.splitting = \"lie\"", ""};
    return solver_->set(path, value);
  }

  [[nodiscard]] std::string title() const override { return solver_->title() + ", " + hung_.label; }
  [[nodiscard]] std::size_t particles() const override { return stopped_ ? 0 : solver_->particles(); }
  [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t frame, const FrameRequest& request) override;
  [[nodiscard]] ParticleTable particle_table() const override;
  void profile(Profile* p) override { solver_->profile(p); }
  [[nodiscard]] bool watch(StageTap* tap) override { return solver_->watch(tap); }

private:
  bool advance(double dt);

  std::unique_ptr<double> dt_;
  std::unique_ptr<Simulation> solver_;
  const Hung hung_;
  const double shortest_;
  double time_ = 0;
  bool stopped_ = false, shown_ = false; ///< flew apart; and this was published
  std::exception_ptr lost_;              ///< set where the solver holds no numbers any more
  std::shared_ptr<const Snapshot> last_;
  std::shared_ptr<const History> curves_;
  mutable std::optional<ParticleTable> last_table_;
};

void Mistaken::step(double dt) {
  time_ += dt;
  if (stopped_) return;
  try {
    stopped_ = !advance(dt);
  } catch (const NonFiniteError&) {
    lost_ = std::current_exception();
    stopped_ = true;
  }
}

/// In as few equal steps as it may take; what rounding leaves is not another one. False: they get far too short.
bool Mistaken::advance(double dt) {
  for (double left = dt; left > 0;) {
    const double most = solver_->max_dt();
    if (shortest_ < 1 && !(most >= shortest_)) return false;
    const double count = std::max(std::ceil(left / most * (1 - 1e-9)), 1.0);
    *dt_ = left / count;
    solver_->step(*dt_);
    left = count > 1 ? left - *dt_ : 0;
  }
  return true;
}

std::shared_ptr<const Snapshot> Mistaken::snapshot(std::uint64_t frame, const FrameRequest& request) {
  if (!lost_ && !shown_) last_ = solver_->snapshot(frame, request);
  shown_ = stopped_;
  if (!last_) std::rethrow_exception(lost_);
  if (!stopped_) curves_ = last_->history;
  auto s = std::make_shared<Snapshot>(*last_);
  s->history = curves_; // those of the wreck would set the scale of all
  s->frame = frame;
  s->time = time_;
  s->title = title();
  s->watermark = hung_.watermark;
  if (stopped_) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), ", flew apart at %.3g s", solver_->time());
    s->watermark += text.data();
  }
  s->notes.insert(s->notes.begin(), hung_.note);
  return s;
}

ParticleTable Mistaken::particle_table() const {
  if (!lost_) last_table_ = solver_->particle_table();
  if (!last_table_) std::rethrow_exception(lost_);
  return *last_table_;
}

template <int Dim, class Real>
std::unique_ptr<Simulation> make_mistaken(const Scene& scene, const Hung& hung, Pool& pool) {
  auto dt = std::make_unique<double>(0);
  auto solver = std::make_unique<FluidSolver<Dim, Real>>(
      scene.settings, seed_particles<Dim, Real>(scene, grid_of<Dim>(scene.settings)), pool, scene.obstacles,
      make_mistake<Dim, Real>(hung.exhibit, *dt, pool));
  return std::make_unique<Mistaken>(std::move(solver), std::move(dt), hung);
}

template <int Dim> std::unique_ptr<Simulation> make_mistaken(const Scene& scene, const Hung& hung, Pool& pool) {
  return scene.settings.precision == Precision::single ? make_mistaken<Dim, float>(scene, hung, pool)
                                                       : make_mistaken<Dim, double>(scene, hung, pool);
}

constexpr std::string_view mystery = "mystery";

int mystery_number(std::string_view text) {
  constexpr int last = 9999;
  int n = 0;
  const std::string_view digits = text.substr(std::min(text.size(), mystery.size() + 1));
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || n < 1 || n > last)
    throw UserError("\"" + std::string(text) + "\": a mystery has a number from 1 to " + std::to_string(last) +
                    ", for example mystery:1");
  return n;
}

} // namespace

std::string Choice::option() const {
  return mystery_n > 0 ? "mystery:" + std::to_string(mystery_n) : std::string(exhibits()[candidates.front()].name);
}

std::string Choice::label() const {
  return mystery_n > 0 ? "mystery " + std::to_string(mystery_n) : "mistake";
}

Choice parse_choice(std::string_view text) {
  if (text == mystery || text.starts_with(std::string(mystery) + ":")) {
    const int n = mystery_number(text);
    return {mystery_order(n), n};
  }
  std::vector<std::string> names{std::string(mystery) + ":1"};
  for (std::size_t i = 0; i < exhibits().size(); ++i) {
    if (exhibits()[i].name == text) return {{i}, 0};
    names.emplace_back(exhibits()[i].name);
  }
  throw UserError("the museum has no mistake \"" + std::string(text) + "\"", {}, nearest_name(text, names));
}

std::vector<std::size_t> mystery_order(int n) {
  std::vector<std::size_t> order(exhibits().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = order.size(); left > 1; --left) {
    const double u = uniform(static_cast<std::uint64_t>(n), left, 0);
    std::swap(order[left - 1], order[static_cast<std::size_t>(u * static_cast<double>(left))]);
  }
  return order;
}

Hung hang(const Choice& choice, std::size_t exhibit) {
  const Exhibit& e = exhibits()[exhibit];
  const bool secret = choice.mystery_n > 0;
  const std::string number = std::to_string(choice.mystery_n);
  return {exhibit, choice.label(), "WITH A MISTAKE: " + (secret ? choice.label() : std::string(e.label)),
          secret ? "A mistake on purpose; flipbook list mistakes --reveal " + number + " tells which."
                 : "On purpose: " + std::string(e.wrong)};
}

std::unique_ptr<Simulation> make_mistaken(const Scene& scene, const Hung& hung, Pool& pool) {
  check_scene(scene);
  if (const std::string missing = needs(hung.exhibit, scene.settings); !missing.empty())
    throw UserError("--with-mistake needs " + missing);
  return scene.settings.dim == 2 ? make_mistaken<2>(scene, hung, pool) : make_mistaken<3>(scene, hung, pool);
}

} // namespace flipbook::museum
