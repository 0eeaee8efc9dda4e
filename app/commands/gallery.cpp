// SPDX-License-Identifier: MIT
// flipbook gallery FOLDER: a page of studies, figures and sliders, rendered where something is missing or stale.
#include "app/commands/command.h"
#include "app/commands/run_options.h"
#include "app/commands/variants.h"
#include "app/encode/process.h"
#include "app/encode/staging.h"
#include "app/gallery/exhibit.h"
#include "app/gallery/page.h"
#include "app/session/failure.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

class Gallery final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"FOLDER", Argument::Kind::folder}, folder_, "Where the page (index.html) and its files go");
    v.positionals({"STUDY", Argument::Kind::study}, studies_, "Studies or scenes, by name or path: a video of each");
    v.texts("--scrub", scrubs_, "STUDY:PATH=V,V,...",
            "Pictures of a study for each value of a parameter, behind a slider");
    v.text("--figures", figures_, "NAME,...", "Teaching figures (flipbook figure --list)");
    v.text("--from", from_, {"FILE.toml", Argument::Kind::file},
           "What to show; assets/gallery.toml documents every key, and is shown where nothing is named");
    v.text("--title", title_, "TEXT", "Above the page");
    v.texts("--set", sets_, {"PATH=VALUE", Argument::Kind::assignment}, "Give a parameter of all studies a value");
    v.flag("--inline", inline_, "Put every file into the page: one file to send");
    v.flag("--pictures", pictures_, "Make the pictures that entries ask for with [entry.picture] instead of the page");
    options_.describe_machine(v);
    v.flag("-q,--quiet", quiet_, "Print nothing but the paths of the results");
  }

  int run() override {
    const gallery::Spec spec = wanted();
    std::vector<std::unique_ptr<gallery::Exhibit>> exhibits; // mistakes come before the work
    for (const gallery::Entry& e : spec.entries) exhibits.push_back(gallery::make_exhibit(e, spec.all));
    gallery::Workshop shop{.folder = folder_, .session = options_.session_options(), .ffmpeg = true};
    shop.session.quiet = quiet_;
    if (pictures_) return make_pictures(spec, exhibits, shop);
    refuse_stranger();
    shop.ffmpeg = Process::find("ffmpeg").has_value();
    if (!shop.ffmpeg) shop.say("warning: no ffmpeg in PATH: pictures stand for the videos (apt install ffmpeg)");
    catch_signals(); // so that nothing half-made is left
    gallery::PageText page{spec.title, spec.intro, {}};
    std::set<std::string> names;
    for (const auto& exhibit : exhibits) page.pieces.push_back(exhibit->make(unique(exhibit->name(), names), shop));
    write_file(index(), gallery::page_html(page, folder_, inline_));
    std::cout << index().string() << '\n';
    return 0;
  }

private:
  [[nodiscard]] fs::path index() const { return fs::path(folder_) / "index.html"; }

  [[nodiscard]] gallery::Spec wanted() const {
    const bool none = studies_.empty() && scrubs_.empty() && figures_.empty() && from_.empty();
    gallery::Spec spec;
    if (!from_.empty()) spec = gallery::read_spec(from_);
    if (none) spec = own();
    if (!title_.empty()) spec.title = title_;
    for (const std::string& text : sets_) spec.all.push_back(parse_assignment(text, "--set"));
    const auto add = [&](const std::string& kind, const std::string& what) {
      gallery::Entry entry;
      entry.kind = kind;
      entry.what = what;
      spec.entries.push_back(std::move(entry));
    };
    for (const std::string& study : studies_) add("study", study);
    for (const std::string& text : scrubs_) spec.entries.push_back(gallery::parse_scrub(text));
    if (!figures_.empty())
      for (const std::string& name : split_list(figures_, "--figures")) add("figure", name);
    return spec;
  }

  /// What comes with the program.
  static gallery::Spec own() {
    const auto file = find_asset_file("", "gallery.toml");
    if (!file) throw UserError("name studies, --scrub, --figures or --from");
    return gallery::read_spec(*file);
  }

  /// A page that somebody wrote is not replaced.
  void refuse_stranger() const {
    std::ifstream in(index(), std::ios::binary);
    if (!in) return;
    std::string head(4096, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    if (!head.empty() && head.find(gallery::page_mark) == std::string::npos)
      throw UserError(index().string() + " is in the way: it is no page of flipbook gallery; choose another folder");
  }

  static std::string unique(const std::string& name, std::set<std::string>& taken) {
    std::string free = name;
    for (int n = 2; !taken.insert(free).second; ++n) free = name + "_" + std::to_string(n);
    return free;
  }

  int make_pictures(const gallery::Spec& spec, const std::vector<std::unique_ptr<gallery::Exhibit>>& exhibits,
                    gallery::Workshop& shop) const {
    std::size_t made = 0;
    for (std::size_t i = 0; i < exhibits.size(); ++i) {
      const auto& request = spec.entries[i].picture;
      if (!request) continue;
      const fs::path file = fs::path(folder_) / request->file;
      exhibits[i]->make_picture(*request, file, shop);
      std::cout << file.string() << std::endl;
      ++made;
    }
    if (made == 0) throw UserError("--pictures: no entry asks for one ([entry.picture] and file = \"NAME.webp\")");
    return 0;
  }

  std::string folder_, figures_, from_, title_;
  std::vector<std::string> studies_, scrubs_, sets_;
  bool inline_ = false, pictures_ = false, quiet_ = false;
  RunOptions options_;
};

} // namespace

std::unique_ptr<Command> make_gallery() {
  return std::make_unique<Gallery>();
}

} // namespace flipbook::app
