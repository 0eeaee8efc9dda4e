// SPDX-License-Identifier: MIT
#include "app/stages/story.h"

#include "render/views/ticks.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace flipbook::app {

namespace {

using render::number;

/// "0.0312 m/s", "3.1 cm/s" would be another unit than the axes': always the given one.
std::string quantity(double x, const std::string& unit) {
  return number(x, 3) + " " + render::unit_text(unit);
}

double largest_divergence(const StageStill& still) {
  const StageSamples* d = still.find("divergence");
  double most = 0;
  if (d)
    for (const double x : d->values) most = std::max(most, std::abs(x));
  return most;
}

class Teller {
public:
  explicit Teller(const RecordedStep& step)
      : step_(step), settings_(step.settings), corner_(settings_.transfer.corner()) {}

  std::vector<StoryStage> tell() {
    const auto& stills = step_.stills;
    add(StageKind::start, "Start", corner_.mode == AffineMode::none ? "$*x*_p,  *v*_p$" : "$*x*_p,  *v*_p,  *A*_p$",
        corner_.mode == AffineMode::none
            ? "Every particle has a place and a velocity (arrow). The grid of the last step is forgotten."
            : "Every particle has a place, a velocity (arrow) and how it varies around it. The grid of the last step "
              "is "
              "forgotten.",
        0, 0);
    for (std::size_t i = 1; i < stills.size(); ++i) tell_of(stills[i].stage, i);
    return std::move(story_);
  }

private:
  void add(StageKind kind, std::string name, std::string equation, std::string says, std::size_t before,
           std::size_t after) {
    story_.push_back({kind, std::move(name), std::move(equation), std::move(says), "", before, after});
  }

  /// What comes of a still; nothing of those that only prepare the next.
  void tell_of(const std::string& stage, std::size_t i) {
    if (stage == "p2g") painted(i);
    if (stage == "forces") forces(i);
    if (stage == "stress")
      add(StageKind::changed, "Stress", "$*u*_i ← *u*_i + Δt *f*_i / m_i,  *f*_i = −Σ V^0 τ ∇w_{ip}$",
          "What the material does to itself: inner forces, which sum up to nothing.", i - 1, i);
    if (stage == "contact")
      add(StageKind::changed, "Contact", "$*u*·*n* = *U*·*n*$ in walls and solids",
          "Walls and solid bodies take what would move into them.", i - 1, i);
    if (stage == "projection") projection(i);
    if (stage == "second_half")
      add(StageKind::changed, "Second half", "$*u* ← *u*_{old} + 2 (*u* − *u*_{old})$",
          "The forces acted at the middle of the step; their change is taken twice.", i - 1, i);
    if (stage == "g2p") gathered(i);
    if (stage == "advection" || stage == "motion") moved(stage == "motion", i);
    if (stage == "spacing")
      add(StageKind::moved, "Spacing", "$*x*_p ← *x*_p + δ_p$", "What crowds is pushed apart.", i - 1, i);
  }

  void painted(std::size_t i) {
    forced_ = false;
    const std::string paint = corner_.mode == AffineMode::none ? "*v*_p" : "(*v*_p + *A*_p (*x*_i − *x*_p))";
    const bool faces = settings_.solver == Solver::fluid || settings_.grid.layout == Layout::mac;
    const std::string sample = settings_.solver == Solver::mpm || !faces ? "node" : "face";
    add(StageKind::painted, "P2G", "$*u*_i = Σ_p w_{ip} m_p " + paint + " / m_i$",
        "Each " + sample +
            " takes the mean of the particles near it. A disc is as large as its mass; lines are the weights of one "
            "particle.",
        i - 1, i);
  }

  void forces(std::size_t i) {
    forced_ = true;
    double g = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(settings_.dim); ++a)
      g += settings_.fluid.gravity[a] * settings_.fluid.gravity[a];
    const bool half = settings_.time.splitting != Splitting::lie && settings_.solver == Solver::fluid;
    const double change = std::sqrt(g) * step_.dt() * (half ? 0.5 : 1);
    add(StageKind::changed, "Forces", half ? "$*u* ← *u* + \xC2\xBD Δt *g*$" : "$*u* ← *u* + Δt *g*$",
        g > 0 ? "The same change everywhere: " + quantity(change, "m/s") + "."
              : "There is no gravity: nothing changes.",
        i - 1, i);
  }

  void projection(std::size_t i) {
    const double before = largest_divergence(step_.stills[i - 1]), after = largest_divergence(step_.stills[i]);
    add(StageKind::divergence, "Divergence before", "$∇·*u* ≠ 0$",
        "Where more flows out of a cell than in, or less; the largest of the whole liquid is told.", i - 1, i - 1);
    story_.back().reading = "at most " + quantity(before, "1/s");
    if (forced_ || settings_.time.splitting == Splitting::lie) // that of a correction is kept nowhere
      add(StageKind::pressure, "Pressure", "$∇·(*u* − Δt/ρ ∇p) = 0$",
          "The pressure whose gradient takes the divergence away; p = 0 on the surface.", i - 1, i);
    add(StageKind::projected, "Divergence after", "$*u* ← *u* − Δt/ρ ∇p$",
        "On the same scale as before. Arrows: what the pressure did to the faces.", i - 1, i);
    story_.back().reading = "at most " + quantity(after, "1/s");
  }

  void gathered(std::size_t i) {
    const bool correction = !forced_ && settings_.solver == Solver::fluid;
    std::string equation = "$*v*_p ← Σ_i w_{ip} *u*_i$", says = "Particles take over the grid's velocity: ";
    if (correction) {
      equation = "$*v*_p ← *v*_p + Σ_i w_{ip} (*u*_i − *u*_{old})$";
      says = "A correction: particles add what the projection did. ";
    } else if (corner_.scalar || corner_.order > 1) {
      equation = step_.before->title;
      says = "Particles take from the grid what the scheme keeps. ";
    } else if (corner_.flip_ratio > 0) {
      const std::string share = corner_.flip_ratio == 1 ? "" : number(corner_.flip_ratio, 4) + " ";
      equation = "$*v*_p ← Σ_i w_{ip} *u*_i + " + share + "(*v*_p − Σ_i w_{ip} *u*_{old})$";
      says = corner_.flip_ratio == 1 ? "Particles add the grid's change to their own velocity. "
                                     : "Mostly the grid's change is added, and a part of the velocity replaced. ";
      if (corner_.flip_ratio < 0.5) says = "A part of the grid's change is added; the rest is the grid's velocity. ";
    } else {
      says = "The grid's velocity replaces that of the particles. ";
    }
    add(StageKind::gathered, "G2P", equation, says + "Colour: how much the velocity changed.", i - 1, i);
  }

  void moved(bool solid, std::size_t i) {
    static constexpr std::array<const char*, 3> order{"RK1", "RK2", "RK3"};
    const char* rk = order[static_cast<std::size_t>(settings_.time.advection)];
    add(StageKind::moved, solid ? "Motion" : "Advection",
        solid ? "$*x*_p ← *x*_p + Δt Σ_i w_{ip} *u*_i,  *F* ← (*I* + Δt ∇*u*) *F*$"
              : std::string("$d*x*_p/dt = *u*(*x*_p)$, ") + rk,
        std::string("Along the grid's velocity; rings show where the particles were.") +
            (solid ? " Their deformation follows." : ""),
        i - 1, i);
  }

  const RecordedStep& step_;
  const Settings& settings_;
  const Corner corner_;
  std::vector<StoryStage> story_;
  bool forced_ = false; ///< have forces acted since the last P2G?
};

/// What is said where the variants differ.
void generalise(StoryStage& stage) {
  switch (stage.kind) {
  case StageKind::start:
    stage.equation = "$*x*_p,  *v*_p,  *A*_p$";
    stage.says = "Every particle has a place, a velocity (arrow) and, in affine schemes, how it varies around it.";
    break;
  case StageKind::painted: stage.equation = "$*u*_i = Σ_p w_{ip} m_p (*v*_p + *A*_p (*x*_i − *x*_p)) / m_i$"; break;
  case StageKind::gathered:
    stage.equation = "$*v*_p ← Σ_i w_{ip} *u*_i + r (*v*_p − Σ_i w_{ip} *u*_{old})$";
    stage.says = "Each scheme keeps something else: r is 1 for FLIP, 0 for PIC and APIC. Colour: how much the velocity "
                 "changed.";
    break;
  case StageKind::divergence:
  case StageKind::projected:
  case StageKind::changed:
  case StageKind::pressure:
  case StageKind::moved:
    if (const std::size_t colon = stage.says.find(':'); colon != std::string::npos)
      stage.says = stage.says.substr(0, colon) + ".";
    break;
  }
}

} // namespace

std::vector<StoryStage> story_of(const RecordedStep& step) {
  return Teller(step).tell();
}

std::vector<StoryStage> common_story(const std::vector<RecordedStep>& steps) {
  std::vector<StoryStage> story = story_of(steps.front());
  for (const RecordedStep& step : steps) {
    const std::vector<StoryStage> other = story_of(step);
    const bool same = std::equal(story.begin(), story.end(), other.begin(), other.end(),
                                 [](const auto& a, const auto& b) { return a.name == b.name; });
    if (!same)
      throw UserError("the steps of \"" + steps.front().title + "\" and \"" + step.title +
                      "\" have different stages: choose one with --variant");
    for (std::size_t k = 0; k < story.size(); ++k)
      if (story[k].equation != other[k].equation || story[k].says != other[k].says) generalise(story[k]);
  }
  return story;
}

} // namespace flipbook::app
