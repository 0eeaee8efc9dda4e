// SPDX-License-Identifier: MIT
// What a shell may offer for the word that is being typed. The scripts of `flipbook completion` ask the program itself
// (`flipbook complete WORD...`), so that a new option, scene or parameter needs no new script.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace flipbook::app {

struct Offer {
  enum class Paths { none, files, folders };
  struct Entry {
    std::string text; ///< begins with the word
    std::string help;
  };
  std::vector<Entry> entries;
  Paths paths = Paths::none; ///< which names of the file system fit, too
  bool unfinished = false;   ///< more of the same word can follow an entry: no space after it
};

/// `words`: those behind the program's name, up to the one that is being typed, which may be empty.
[[nodiscard]] Offer complete(const std::vector<std::string>& words);

/// As the scripts read it: a line for each entry, text and help with a tab between, then ":files" or ":folders" and
/// ":nospace" where they hold.
void print_offer(std::ostream& out, const Offer& offer);

} // namespace flipbook::app
