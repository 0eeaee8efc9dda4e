// SPDX-License-Identifier: MIT
// A video or a picture that is there already: it is copied into the gallery.
#include "app/encode/staging.h"
#include "app/gallery/exhibit.h"
#include "app/gallery/html.h"
#include "sim/frame/errors.h"

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

class FileExhibit final : public Exhibit {
public:
  explicit FileExhibit(const Entry& entry) : entry_(entry), file_(path_of(entry)) {
    std::error_code none;
    if (!fs::is_regular_file(file_, none)) throw UserError("there is no file \"" + file_.string() + "\"", entry.where);
    type_ = media_type(file_.string());
    if (!type_.starts_with("video/") && !type_.starts_with("image/"))
      throw UserError("\"" + entry.what + "\": a gallery shows .mp4, .webm, .gif, .webp, .png, .jpg and .svg files",
                      entry.where);
    if (entry.alt.empty())
      throw UserError("a file says nothing about itself: give alt = \"what one sees\"", entry.where);
  }

  [[nodiscard]] std::string name() const override { return file_name(file_.stem().string()); }

  Piece make(const std::string& name, Workshop& shop) override {
    Piece p;
    p.kind = type_.starts_with("video/") ? Piece::Kind::video : Piece::Kind::picture;
    p.id = name;
    p.title = entry_.title.empty() ? file_.stem().string() : entry_.title;
    p.text = entry_.text;
    p.alt = entry_.alt;
    p.media = Workshop::media(name + file_.extension().string());
    std::error_code none;
    if (!fs::equivalent(file_, shop.path(p.media), none)) {
      Staging staging(shop.path(media_folder));
      const std::string copy = name + file_.extension().string();
      std::error_code failed;
      fs::copy_file(file_, staging.file(copy), failed);
      if (failed) throw MachineError("cannot copy " + file_.string() + ": " + failed.message());
      staging.commit();
    }
    return p;
  }

private:
  Entry entry_;
  fs::path file_;
  std::string_view type_;
};

} // namespace

std::unique_ptr<Exhibit> file_exhibit(const Entry& entry, const std::vector<Assignment>& /*all*/) {
  return std::make_unique<FileExhibit>(entry);
}

} // namespace flipbook::app::gallery
