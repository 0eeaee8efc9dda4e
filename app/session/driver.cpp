// SPDX-License-Identifier: MIT
#include "app/session/driver.h"

#include "app/session/apply_command.h"
#include "app/session/make_variants.h"
#include "app/session/queue.h"
#include "app/study/paths.h"
#include "sim/frame/errors.h"

#include <optional>

namespace flipbook::app {

namespace {

/// The same failure, told with the frame on the way to which it happened.
class NonFiniteAtFrame final : public NonFiniteError {
public:
  NonFiniteAtFrame(const NonFiniteError& e, std::uint64_t frame)
      : NonFiniteError(e), text_(std::string(e.what()) + ", on the way to frame " + std::to_string(frame)) {}
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

private:
  std::string text_;
};

} // namespace

std::size_t Bundle::bytes() const {
  std::size_t sum = 0;
  for (const auto& s : snapshots) sum += s->bytes();
  return sum;
}

Driver::Driver(const Resolved& resolved, const Schedule& schedule, Budget& budget, Exchange<Bundle>& out,
               std::function<bool()> stop, SeriesWriter* particles, LedgerFile* ledger)
    : resolved_(resolved), view_(resolved), differences_(resolved.timeline.views(resolved.view)),
      commands_(resolved.timeline.commands(resolved.output.fps, resolved.scale, schedule.boundaries())),
      schedule_(schedule), budget_(budget), out_(out), stop_(std::move(stop)), particles_(particles), ledger_(ledger) {}

void Driver::drive() {
  std::optional<Budget::Permit> permit(std::in_place, budget_);
  Pool pool(budget_);
  while (const auto stop = schedule_.next()) {
    try {
      if (!variants_) make_variants(pool);
      if (!variants_->advance_to(stop->time, stop_)) break;
    } catch (const NonFiniteError& e) {
      throw NonFiniteAtFrame(e, stop->frame);
    }
    particle_steps_ = variants_->particle_steps();
    if (stop->boundary) apply_commands(stop->frame);
    Bundle bundle = look(pool, *stop);
    if (ledger_) ledger_->write(bundle.stop, bundle.snapshots);
    if (stop->shown && particles_) write_particles(pool, bundle);
    if (stop->boundary) apply_edits(stop->frame);
    if (!stop->shown) continue;
    permit.reset(); // the queue may be full, and whoever empties it needs the permit
    const std::size_t charge = queue_charge(bundle.bytes(), bundle_queue_bytes);
    if (!out_.put(std::move(bundle), charge)) break;
    permit.emplace(budget_);
  }
  out_.close();
}

void Driver::make_variants(Pool& pool) {
  variants_ = flipbook::app::make_variants(resolved_, pool);
  if (!profiles_) return;
  profiles_->resize(variants_->size());
  for (std::size_t i = 0; i < variants_->size(); ++i) (*variants_)[i].profile(&(*profiles_)[i]);
}

void Driver::apply_commands(std::uint64_t frame) {
  for (; next_command_ < commands_.size() && commands_[next_command_].frame <= frame; ++next_command_)
    must_apply(commands_[next_command_], *variants_, "timeline: ");
}

void Driver::apply_edits(std::uint64_t frame) {
  const CommandLog& edits = resolved_.edits;
  for (; next_edit_ < edits.size() && edits[next_edit_].frame <= frame; ++next_edit_) {
    const Command& edit = edits[next_edit_];
    const auto* change = std::get_if<SetParameter>(&edit.action);
    if (change && is_view(change->path))
      view_.set(*change, resolved_.time_of(edit.frame));
    else
      must_apply(edit, *variants_, "an edit: ");
  }
}

Bundle Driver::look(Pool& pool, const Stop& at) {
  Bundle bundle{at, std::vector<std::shared_ptr<const Snapshot>>(variants_->size()), view_.at(at.time)};
  pool.each(static_cast<int>(variants_->size()), [&](int i) {
    const auto v = static_cast<std::size_t>(i);
    bundle.snapshots[v] = (*variants_)[v].snapshot(at.frame, view_.request());
  });
  differences_.add(bundle.view, at.time, bundle.snapshots);
  bundle.difference = differences_.of(bundle.view);
  return bundle;
}

void Driver::write_particles(Pool& pool, const Bundle& bundle) {
  particles_->write(
      bundle.stop, bundle.snapshots, [&](std::size_t v) { return (*variants_)[v].particle_table(); }, pool);
}

} // namespace flipbook::app
