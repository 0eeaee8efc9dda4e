// SPDX-License-Identifier: MIT
// flipbook figure: teaching figures, computed and drawn; PNG, SVG and PDF of a physical size, and their data.
#include "app/commands/command.h"
#include "app/commands/progress_line.h"
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/figures/contact_sheet.h"
#include "app/figures/page.h"
#include "app/figures/particle_pictures.h"
#include "render/chart/text_check.h"
#include "render/context/context.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace flipbook::app {

namespace {

struct Format {
  const char* name;
  render::Medium medium;
};
constexpr std::array<Format, 3> formats{
    {{"png", render::Medium::pixels}, {"svg", render::Medium::svg}, {"pdf", render::Medium::pdf}}};

class FigureCommand final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positionals({"NAME", Argument::Kind::choice, list_figures()}, names_,
                  "Which figures, by name or by the path of a TOML file; flipbook figure --list tells of each");
    v.flag("--all", all_, "All figures");
    v.flag("--list", list_, "List the figures and what they claim, and draw none");
    v.text("--width", width_, "84mm|column|text",
           "How wide they are on paper, instead of what each says: in mm, cm or in; column is 84 mm, text 174 mm");
    v.text("--formats", formats_, "png,svg,pdf", "Only these");
    v.flag("--bare", bare_, "Without the claim above and the caption below, for a text that has them");
    v.flag("--fast", fast_, "Few cells and short times, for a first look");
    v.text("--contact-sheet", sheet_, {"X.png", Argument::Kind::file}, "Also one picture of all of them");
    v.text("--threads", threads_, "N", "How many threads compute; the results do not depend on it");
    v.text("-o,--output", output_, {"FOLDER", Argument::Kind::folder}, "Where the files go (out/figures if not given)");
  }

  int run() override {
    if (list_) return list();
    const std::vector<FigureSpec> specs = chosen();
    std::vector<std::unique_ptr<FigureKind>> kinds;
    for (const FigureSpec& s : specs) kinds.push_back(kind_of(s)); // mistakes come before the work
    const std::vector<Format> wanted = wanted_formats();
    const double width = width_.empty() ? 0 : parse_width(width_);
    if (!sheet_.empty() && !sheet_.ends_with(".png")) throw UserError("--contact-sheet " + sheet_ + ": a name in .png");
    render::check_chart_fonts();
    render::set_draw_threads(1);
    Budget budget(parse_threads(threads_));
    const Budget::Permit permit(budget);
    Pool pool(budget);
    ParticlePictures pictures;
    ContactSheet contact;
    for (std::size_t i = 0; i < specs.size(); ++i) {
      const std::unique_ptr<FigureBody> body = computed(specs[i], *kinds[i], pool);
      const FigureLook look{.width = width > 0 ? width : specs[i].width, .bare = bare_};
      write(specs[i], *body, look, wanted, pictures);
      if (!sheet_.empty()) contact.add(specs[i], *body, pictures);
    }
    if (!sheet_.empty()) write_sheet(contact);
    return 0;
  }

private:
  static int list() {
    std::size_t longest = 0;
    const std::vector<std::string> names = list_figures();
    for (const std::string& n : names) longest = std::max(longest, n.size());
    for (const std::string& n : names)
      std::cout << n << std::string(longest + 2 - n.size(), ' ') << render::plain_text(read_figure(n, false).claim)
                << '\n';
    return 0;
  }

  [[nodiscard]] std::vector<FigureSpec> chosen() const {
    if (all_ && !names_.empty()) throw UserError("give figures or --all, not both");
    if (!all_ && names_.empty()) throw UserError("figure needs a name or --all (flipbook figure --list)");
    std::vector<FigureSpec> specs;
    for (const std::string& name : all_ ? list_figures() : names_) specs.push_back(read_figure(name, fast_));
    return specs;
  }

  [[nodiscard]] std::vector<Format> wanted_formats() const {
    if (formats_.empty()) return {formats.begin(), formats.end()};
    std::vector<Format> wanted;
    for (const std::string& name : split_list(formats_, "--formats")) {
      const auto at = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return name == f.name; });
      if (at == formats.end()) throw UserError("--formats " + name + ": png, svg or pdf");
      wanted.push_back(*at);
    }
    return wanted;
  }

  static std::unique_ptr<FigureBody> computed(const FigureSpec& spec, const FigureKind& kind, Pool& pool) {
    const ProgressLine line(spec.name);
    return kind.compute({pool, [&](std::size_t done, std::size_t of) { line.show(done, of); }});
  }

  void write(const FigureSpec& spec, const FigureBody& body, const FigureLook& look, const std::vector<Format>& wanted,
             ParticlePictures& pictures) const {
    const std::filesystem::path folder = output_.empty() ? "out/figures" : output_;
    Staging files(folder);
    std::vector<std::string> conflicts;
    for (const Format& f : wanted) {
      const DrawnFigure drawn = draw_figure(spec, body, look, f.medium, print_density, pictures);
      const std::string name = spec.name + "." + f.name;
      if (f.medium == render::Medium::pixels)
        files.write(name, encode_png(drawn.image, provenance(spec), PngEffort::small, print_density));
      else
        files.write(name, drawn.file);
      conflicts = text_conflicts(drawn.texts,
                                 {0, 0, static_cast<float>(drawn.sheet.width), static_cast<float>(drawn.sheet.height)});
    }
    for (const FigureTable& t : body.tables())
      files.write(spec.name + (t.part.empty() ? "" : "_" + t.part) + ".csv", t.csv());
    files.commit();
    std::cout << (folder / spec.name).string() << ": " << render::plain_text(spec.claim) << std::endl;
    for (const std::string& c : conflicts) std::cerr << "flipbook: warning: " << spec.name << ": " << c << '\n';
  }

  static TextEntries provenance(const FigureSpec& spec) {
    std::string run;
    for (const Assignment& a : spec.run) run += a.path + " = " + to_toml(a.value) + "\n";
    return {{"flipbook:version", version()},
            {"flipbook:figure", spec.name},
            {"Title", render::plain_text(spec.claim)},
            {"Description", render::plain_text(spec.caption)},
            {"flipbook:kind", spec.kind},
            {"flipbook:run", run}};
  }

  void write_sheet(const ContactSheet& contact) const {
    const std::filesystem::path file = sheet_;
    Staging staged(file.has_parent_path() ? file.parent_path() : ".");
    staged.write(file.filename().string(),
                 encode_png(contact.image(), {{"flipbook:version", version()}}, PngEffort::small));
    staged.commit();
    std::cout << sheet_ << std::endl;
  }

  std::vector<std::string> names_;
  std::string width_, formats_, sheet_, threads_, output_;
  bool all_ = false, list_ = false, bare_ = false, fast_ = false;
};

} // namespace

std::unique_ptr<Command> make_figure() {
  return std::make_unique<FigureCommand>();
}

} // namespace flipbook::app
