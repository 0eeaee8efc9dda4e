// SPDX-License-Identifier: MIT
// A teaching figure (flipbook figure): SVG in two widths, one for telephones, and PNG, which carries what was run and
// so tells whether it is stale.
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/figures/page.h"
#include "app/figures/particle_pictures.h"
#include "app/figures/spec.h"
#include "app/gallery/exhibit.h"
#include "app/gallery/html.h"
#include "render/chart/rich_text.h"
#include "render/chart/text_check.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

constexpr double narrow_width = 84; // mm

class FigureExhibit final : public Exhibit {
public:
  explicit FigureExhibit(const Entry& entry)
      : entry_(entry), spec_(read_figure(is_path(entry.what) ? path_of(entry) : entry.what, entry.fast)),
        kind_(kind_of(spec_)) {
    if (!entry.width.empty()) spec_.width = parse_width(entry.width);
  }

  [[nodiscard]] std::string name() const override { return file_name(spec_.name); }

  Piece make(const std::string& name, Workshop& shop) override {
    const auto file = [&](const std::string& ending) { return Workshop::media(name + ending); };
    if (!fresh(shop.path(file(".png")), shop.path(file(".svg")), shop.path(file("_narrow.svg")))) draw(name, shop);
    Piece p;
    p.kind = Piece::Kind::figure;
    p.id = name;
    p.title = entry_.title.empty() ? spec_.claim : entry_.title;
    p.text = entry_.text.empty() ? spec_.caption : entry_.text;
    p.rich = true;
    p.alt = entry_.alt.empty() ? "Figure. " + render::plain_text(spec_.claim) + " " + render::plain_text(spec_.caption)
                               : entry_.alt;
    p.media = file(".svg");
    p.narrow = file("_narrow.svg");
    std::vector<std::string> words{"flipbook", "figure", entry_.what, "-o", "figures"};
    if (entry_.fast) words.emplace_back("--fast");
    if (!entry_.width.empty()) words.insert(words.end(), {"--width", entry_.width});
    p.command = shell_command(words);
    p.downloads = {{"SVG", file(".svg")}, {"PNG", file(".png")}};
    for (const fs::directory_entry& e : fs::directory_iterator(shop.path(media_folder))) {
      const std::string data = e.path().filename().string();
      if (data == name + ".csv") p.downloads.emplace_back("Data", Workshop::media(data));
    }
    return p;
  }

private:
  [[nodiscard]] TextEntries provenance() const {
    std::string run;
    for (const Assignment& a : spec_.run) run += a.path + " = " + to_toml(a.value) + "\n";
    return {{"flipbook:version", version()},
            {"flipbook:figure", spec_.name},
            {"Title", render::plain_text(spec_.claim)},
            {"Description", render::plain_text(spec_.caption)},
            {"flipbook:kind", spec_.kind},
            {"flipbook:width", to_toml(Value(spec_.width))},
            {"flipbook:run", run}};
  }

  [[nodiscard]] bool fresh(const fs::path& png, const fs::path& wide, const fs::path& narrow) const {
    std::error_code none;
    if (!fs::exists(png, none) || !fs::exists(wide, none) || !fs::exists(narrow, none)) return false;
    try {
      return read_png_text(png) == provenance();
    } catch (const UserError&) {
      return false;
    }
  }

  void draw(const std::string& name, const Workshop& shop) const {
    shop.say(Workshop::media(name + ".svg"));
    render::check_chart_fonts();
    render::set_draw_threads(1);
    Budget budget(shop.session.threads);
    const Budget::Permit permit(budget);
    Pool pool(budget);
    const std::unique_ptr<FigureBody> body = kind_->compute({pool});
    Workshop::go_on();
    ParticlePictures pictures(shop.session.gl);
    Staging files(shop.path(media_folder));
    const auto drawn = [&](double width, render::Medium medium) { // the page itself has claim and caption
      return draw_figure(spec_, *body, {.width = width, .bare = true}, medium, print_density, pictures);
    };
    files.write(name + ".svg", drawn(spec_.width, render::Medium::svg).file);
    files.write(name + "_narrow.svg", drawn(narrow_width, render::Medium::svg).file);
    files.write(name + ".png", encode_png(drawn(spec_.width, render::Medium::pixels).image, provenance(),
                                          PngEffort::small, print_density));
    const std::vector<FigureTable> tables = body->tables();
    for (const FigureTable& t : tables) files.write(name + (t.part.empty() ? "" : "_" + t.part) + ".csv", t.csv());
    files.commit();
  }

  Entry entry_;
  FigureSpec spec_;
  std::unique_ptr<FigureKind> kind_;
};

} // namespace

std::unique_ptr<Exhibit> figure_exhibit(const Entry& entry, const std::vector<Assignment>& /*all*/) {
  return std::make_unique<FigureExhibit>(entry);
}

} // namespace flipbook::app::gallery
