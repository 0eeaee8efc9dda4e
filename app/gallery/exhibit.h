// SPDX-License-Identifier: MIT
// One entry of a gallery: it is read and checked when it is made, so that mistakes come before any work; then it
// renders what is missing or stale, and says what the page shows.
#pragma once

#include "app/gallery/piece.h"
#include "app/gallery/spec.h"
#include "app/gallery/workshop.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace flipbook::app::gallery {

class Exhibit {
public:
  virtual ~Exhibit() = default;
  /// Of its files and of its place in the page, before it is made unique: "dam_break".
  [[nodiscard]] virtual std::string name() const = 0;
  /// `name`: what it is called among the others.
  [[nodiscard]] virtual Piece make(const std::string& name, Workshop& workshop) = 0;
  /// Makes the picture that the entry asks for, into `file`. Throws UserError where this kind has none.
  virtual void make_picture(const PictureRequest& request, const std::filesystem::path& file, Workshop& workshop);
};

struct ExhibitKind {
  std::string_view name; ///< the key of an entry
  std::string_view help;
  /// Throws UserError. `all`: parameters for all studies.
  std::unique_ptr<Exhibit> (*make)(const Entry& entry, const std::vector<Assignment>& all);
};

[[nodiscard]] std::span<const ExhibitKind> exhibit_kinds();
[[nodiscard]] std::unique_ptr<Exhibit> make_exhibit(const Entry& entry, const std::vector<Assignment>& all);

/// The path of an entry as a file or a folder: relative to the file that says it.
[[nodiscard]] std::string path_of(const Entry& entry);

/// Only letters, digits, - and _; never empty.
[[nodiscard]] std::string file_name(const std::string& text);

// === The kinds, a file each

[[nodiscard]] std::unique_ptr<Exhibit> study_exhibit(const Entry& entry, const std::vector<Assignment>& all);
[[nodiscard]] std::unique_ptr<Exhibit> figure_exhibit(const Entry& entry, const std::vector<Assignment>& all);
[[nodiscard]] std::unique_ptr<Exhibit> scrub_exhibit(const Entry& entry, const std::vector<Assignment>& all);
[[nodiscard]] std::unique_ptr<Exhibit> file_exhibit(const Entry& entry, const std::vector<Assignment>& all);

} // namespace flipbook::app::gallery
