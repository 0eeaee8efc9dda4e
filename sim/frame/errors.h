// SPDX-License-Identifier: MIT
// The three kinds of failure and the exit code of each. Everything the program refuses ends in one of these.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace flipbook {

/// A place in a text that a user wrote. Line and column count from 1; 0 means unknown. An empty `file` means the
/// command line.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

/// The user's input is wrong: exit code 2. `what()` is one line: `file:line:column: message; did you mean "x"?`
class UserError : public std::runtime_error {
public:
  explicit UserError(const std::string& message, const Location& where = {}, std::string_view nearest = {});
};

/// The mistakes of one text, collected so that its writer sees all of them at once, one line each.
class Mistakes {
public:
  void add(const std::string& message, const Location& where = {}, std::string_view nearest = {});
  void add(const UserError& error);
  [[nodiscard]] bool none() const { return lines_.empty(); }
  /// Throws a UserError of all lines if there is any, each line once.
  void raise() const;

private:
  std::vector<std::string> lines_;
};

/// The machine cannot do it (no GL, no encoder, full disk): exit code 3. The message says what was tried and why each
/// attempt failed.
class MachineError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A particle stopped being finite: exit code 4. It is never drawn away.
class NonFiniteError : public std::runtime_error {
public:
  NonFiniteError(std::string_view scheme, std::uint64_t at_step, double time, std::uint32_t id)
      : NonFiniteError(scheme, at_step, time, id, "is no longer finite") {}
  std::uint64_t step;
  std::uint32_t particle; ///< the particle's id

protected:
  /// `what`: "is no longer finite".
  NonFiniteError(std::string_view scheme, std::uint64_t at_step, double time, std::uint32_t id, std::string_view what);
};

/// A particle's material was turned inside out, where it has no energy and so no stress: nothing finite follows.
class InvertedError : public NonFiniteError {
public:
  /// `det_F`: what should have been positive.
  InvertedError(std::string_view scheme, std::uint64_t at_step, double time, std::uint32_t id,
                std::string_view material, double det_F);
};

/// The name in `valid` that is nearest to `word` by edit distance (case ignored), or empty if none is near enough to be
/// a plausible slip.
[[nodiscard]] std::string nearest_name(std::string_view word, std::span<const std::string> valid);

} // namespace flipbook
