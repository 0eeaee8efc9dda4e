// SPDX-License-Identifier: MIT
// How many pictures a client gets, and how good: what a slow network or a slow page can take.
//
// At most two pictures are on the way at once, so that the client decodes one while the next travels; a third has to
// wait for an acknowledgement, and by then it is a newer one. The time from sending to acknowledging says what the way
// can carry: where it is long, pictures become coarser and smaller, where it is short, finer again. Rising takes longer
// than falling, so that it does not swing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace flipbook::app::serve {

/// How a picture is coded for a client.
struct PictureGrade {
  int quality = 85;                   ///< JPEG
  int numerator = 1, denominator = 1; ///< of its width and height
};

inline constexpr std::array<PictureGrade, 7> picture_grades{
    {{88, 1, 1}, {78, 1, 1}, {65, 1, 1}, {65, 3, 4}, {60, 1, 2}, {45, 1, 2}, {40, 1, 4}}};

class Flow {
public:
  static constexpr std::size_t most_on_the_way = 2;

  /// May a picture be sent now?
  [[nodiscard]] bool open() const { return sent_.size() < most_on_the_way; }
  [[nodiscard]] std::size_t grade() const { return grade_; }
  /// Times in seconds, of any clock that does not go back.
  void sent(std::uint32_t picture, double now) { sent_.push_back({picture, now}); }
  /// This picture, and with it all before it. One that is not on the way changes nothing.
  void acknowledged(std::uint32_t picture, double now);

private:
  struct Sent {
    std::uint32_t picture;
    double at;
  };
  void judge(double seconds, double now);

  std::deque<Sent> sent_;
  std::size_t grade_ = 1;
  double mean_ = 0;    ///< of the seconds from sending to acknowledging; 0: none yet
  double changed_ = 0; ///< when the grade was changed last
};

/// So many in the long run, with some to spend at once.
class RateLimit {
public:
  RateLimit(double per_second, double burst) : per_second_(per_second), burst_(burst), left_(burst) {}
  /// Takes one; false if there is none left.
  [[nodiscard]] bool take(double now);

private:
  double per_second_, burst_, left_, last_ = 0;
};

} // namespace flipbook::app::serve
