// SPDX-License-Identifier: MIT
#include "app/gallery/exhibit.h"
#include "app/session/failure.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <array>
#include <iostream>

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

constexpr std::array<ExhibitKind, 4> kinds{{
    {"study", "A video of a study or a scene, with what its ledger says", study_exhibit},
    {"scrub", "Pictures of a study for several values of a parameter, behind a slider", scrub_exhibit},
    {"figure", "A teaching figure", figure_exhibit},
    {"file", "A video or a picture that is there", file_exhibit},
}};

} // namespace

std::span<const ExhibitKind> exhibit_kinds() {
  return kinds;
}

std::unique_ptr<Exhibit> make_exhibit(const Entry& entry, const std::vector<Assignment>& all) {
  for (const ExhibitKind& k : kinds)
    if (k.name == entry.kind) return k.make(entry, all);
  throw std::logic_error("no exhibit of kind " + entry.kind);
}

void Exhibit::make_picture(const PictureRequest& request, const fs::path& /*file*/, Workshop& /*workshop*/) {
  throw UserError(request.file + ": this kind of entry makes no picture; flipbook figure --contact-sheet and flipbook "
                                 "still make others");
}

std::string path_of(const Entry& entry) {
  const fs::path path(entry.what);
  if (path.is_absolute() || entry.where.line == 0) return entry.what; // the command line: from where the program runs
  return (fs::path(entry.where.file).parent_path() / path).string();
}

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool word =
        ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_';
    if (word)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  constexpr std::size_t longest = 60;
  return name.empty() ? "entry" : name.substr(0, longest);
}

void Workshop::go_on() {
  if (const int signal = signal_received()) throw Interrupted(signal);
}

void Workshop::say(const std::string& what) const {
  if (!session.quiet) std::cerr << what << '\n';
}

} // namespace flipbook::app::gallery
