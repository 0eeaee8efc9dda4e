// SPDX-License-Identifier: MIT
#include "app/serve/flow.h"

#include <algorithm>

namespace flipbook::app::serve {
namespace {

constexpr double slow = 0.150, quick = 0.060;             // seconds from sending to acknowledging
constexpr double before_falling = 0.4, before_rising = 2; // seconds that a grade is tried
constexpr double asleep = 2; // a page in the background holds its acknowledgement back: that says nothing of the way

} // namespace

void Flow::acknowledged(std::uint32_t picture, double now) {
  const auto at = std::find_if(sent_.begin(), sent_.end(), [&](const Sent& s) { return s.picture == picture; });
  if (at == sent_.end()) return;
  const double seconds = now - at->at;
  sent_.erase(sent_.begin(), at + 1);
  if (seconds < asleep) judge(seconds, now);
}

void Flow::judge(double seconds, double now) {
  mean_ = mean_ == 0 ? seconds : 0.8 * mean_ + 0.2 * seconds;
  if (mean_ > slow && grade_ + 1 < picture_grades.size() && now - changed_ > before_falling)
    ++grade_;
  else if (mean_ < quick && grade_ > 0 && now - changed_ > before_rising)
    --grade_;
  else
    return;
  changed_ = now;
  mean_ = 0;
}

bool RateLimit::take(double now) {
  left_ = std::min(burst_, left_ + (now - last_) * per_second_);
  last_ = now;
  if (left_ < 1) return false;
  left_ -= 1;
  return true;
}

} // namespace flipbook::app::serve
