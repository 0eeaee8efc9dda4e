// SPDX-License-Identifier: MIT
#include "sim/frame/trails.h"

#include <algorithm>

namespace flipbook {

/// Ids count along rows of particles; this scatters them (the finaliser of MurmurHash3, by A. Appleby, public domain).
static std::uint32_t scattered(std::uint32_t id) {
  id ^= id >> 16U;
  id *= 0x85ebca6bU;
  id ^= id >> 13U;
  id *= 0xc2b2ae35U;
  return id ^ id >> 16U;
}

bool Trails::chosen(std::uint32_t id) const {
  return scattered(id) < share_ * 4294967296.0;
}

std::shared_ptr<const TrailPoints> Trails::points(const Snapshot& s) {
  if (share_ == 0) share_ = static_cast<double>(most_ways) / static_cast<double>(s.particles());
  std::vector<std::size_t> taken;
  do {
    taken.clear();
    for (std::size_t p = 0; p < s.particles(); ++p)
      if (chosen(s.id[p])) taken.push_back(p);
    if (taken.size() > 2 * most_ways) share_ /= 2; // many have come in since
  } while (taken.size() > 2 * most_ways && share_ > 1e-9);
  taken.resize(std::min(taken.size(), 2 * most_ways));
  std::sort(taken.begin(), taken.end(), [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
  auto row = std::make_shared<TrailPoints>();
  row->time = s.time;
  for (const std::size_t p : taken) {
    row->id.push_back(s.id[p]);
    row->x.insert(row->x.end(), {s.x[2 * p], s.x[2 * p + 1]});
  }
  return row;
}

void Trails::follow(Snapshot& s, double seconds) {
  if (s.dim != 2 || !(seconds > 0) || s.particles() == 0) return;
  // Of points closer in time than can be shown the newer ones stay.
  const double apart = seconds / static_cast<double>(most_rows);
  while (!rows_.empty() && rows_.back()->time >= s.time) rows_.pop_back();
  if (rows_.size() > 1 && rows_.back()->time - rows_[rows_.size() - 2]->time < apart) rows_.pop_back();
  rows_.push_back(points(s));
  const auto recent = std::find_if(rows_.begin(), rows_.end(),
                                   [&](const auto& row) { return row->time >= s.time - seconds * (1 + 1e-9); });
  rows_.erase(rows_.begin(), recent);
  s.trails = rows_;
}

} // namespace flipbook
