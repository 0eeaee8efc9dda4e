// SPDX-License-Identifier: MIT
// A study for several values of one parameter, at several moments: a picture of each, which the page puts behind two
// sliders. All values run side by side from the same particles, in shared steps, and share their colours.
#include "app/commands/outputs.h"
#include "app/commands/variants.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/encode/webp_pictures.h"
#include "app/figures/shots.h"
#include "app/gallery/exhibit.h"
#include "app/gallery/html.h"
#include "app/gallery/studies.h"
#include "app/panel/panel.h"
#include "app/session/compose.h"
#include "app/study/memory.h"
#include "app/study/paths.h"
#include "render/renderer.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

constexpr const char* usual_colour = "speed";

/// Pixels that a pane fills but for its title and the colours above; a domain in space is seen from the side.
std::vector<double> fitting_size(const Scene& scene) {
  constexpr double width = 600, margin = 36, above_and_below = 108;
  const auto& size = scene.settings.grid.size;
  const double height = scene.settings.dim == 3 ? 480 : (width - margin) * size[1] / size[0] + above_and_below;
  return {width, 2 * std::round(std::clamp(height, 240.0, 900.0) / 2)};
}

/// One pane and nothing else: sliders, curves and what is said below belong to the page.
std::vector<Assignment> bare_view(const Study& study) {
  std::vector<Assignment> all;
  const auto add = [&](const std::string& path, Value value, bool always) {
    const auto& said = is_output(path) ? study.output : study.view;
    const bool own = std::any_of(said.begin(), said.end(), [&](const Assignment& a) { return a.path == path; });
    if (always || !own) all.push_back({path, std::move(value), {}});
  };
  add("view.show_panel", false, true);
  add("view.plot_height", 0.0, true);
  add("view.captions", false, true);
  add("view.ledger", std::string("off"), true);
  add("view.colour", std::string(usual_colour), false);
  return all;
}

class ScrubExhibit final : public Exhibit {
public:
  ScrubExhibit(const Entry& entry, const std::vector<Assignment>& all)
      : entry_(entry), all_(all), study_(study_of(entry, all)) {
    if (const Refusal r = check_pane_path(entry.vary); !r.message.empty())
      throw UserError(r.message, entry.where, r.nearest);
    study_ = with(study_, bare_view(study_));
    vary();
    if (!says_size(entry)) assign(study_, {"output.size", fitting_size(resolve(study_).variants.front().scene), {}});
    resolved_ = resolve(study_);
    refuse_unused();
    refuse_too_large(resolved_);
    const double last = resolved_.time_of(resolved_.frames - 1);
    for (int k = 0; k < entry.frames; ++k) times_.push_back(last * k / (entry.frames - 1));
  }

  [[nodiscard]] std::string name() const override {
    return file_name(study_.name + "_" + entry_.vary.substr(entry_.vary.rfind('.') + 1));
  }

  Piece make(const std::string& name, Workshop& shop) override {
    const std::string ending = shop.ffmpeg ? ".webp" : ".png";
    const std::size_t count = entry_.values.size() * times_.size();
    const std::string toml = said();
    if (!fresh(name, ending, count, toml, shop)) draw(name, toml, shop);
    write_file(shop.path(Workshop::media(name + ".toml")),
               to_toml(for_folder(study_, fs::absolute(shop.path(media_folder)).string())));
    return piece(name, ending, count, shop);
  }

private:
  static bool says_size(const Entry& entry) {
    return std::any_of(entry.set.begin(), entry.set.end(), [](const Assignment& a) { return a.path == "output.size"; });
  }

  /// A variant for each value, over the first of the study's that uses the parameter.
  void vary() {
    std::erase_if(study_.keys, [](const Key& k) { return !k.variant.empty() || !k.panes.empty(); }); // of other panes
    study_.overridden = true;
    const auto uses_it = [&](const Variant& v) { return uses(study_, v.parameters, entry_.vary); };
    const auto found = std::find_if(study_.variants.begin(), study_.variants.end(), uses_it);
    std::vector<Changes> base{(found == study_.variants.end() ? study_.variants.begin() : found)->parameters};
    choose_scheme(base, study_, entry_.vary);
    std::erase_if(base.front(), [&](const Assignment& a) { return a.path == entry_.vary; });
    const Study one = study_with_one(base.front());
    study_.variants.clear();
    for (const Value& value : entry_.values) {
      Changes changes = base.front();
      changes.push_back({entry_.vary, value, entry_.where});
      complete_cells(changes.back(), one);
      study_.variants.push_back({"", std::move(changes), entry_.where});
    }
  }

  [[nodiscard]] Study study_with_one(const std::vector<Assignment>& parameters) const {
    Study one = study_;
    one.variants = {{"", parameters, {}}};
    return one;
  }

  void refuse_unused() {
    for (const ResolvedVariant& v : resolved_.variants) {
      Settings settings = v.scene.settings;
      for (const Parameter& p : parameters_of(settings)) {
        if (p.path != entry_.vary) continue;
        if (p.applies) parameter_ = p;
      }
    }
    if (parameter_.path.empty())
      throw UserError(study_.name + " does not use " + entry_.vary + ": choose a scheme or a solver that does",
                      entry_.where);
  }

  /// What was drawn, for the question whether it is stale.
  [[nodiscard]] std::string said() const {
    std::string text = to_toml(study_) + "# moments:";
    for (const double t : times_) text += " " + to_toml(Value(t));
    return text + "\n";
  }

  [[nodiscard]] static std::string file(const std::string& name, std::size_t at, const std::string& ending) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "_%04zu", at);
    return Workshop::media(name + number.data() + ending);
  }

  [[nodiscard]] static bool fresh(const std::string& name, const std::string& ending, std::size_t count,
                                  const std::string& toml, const Workshop& shop) {
    std::error_code none;
    for (std::size_t i = 0; i < count; ++i)
      if (!fs::exists(shop.path(file(name, i, ending)), none)) return false;
    try {
      for (const auto& [key, value] : read_png_text(shop.path(Workshop::media(name + ".poster.png"))))
        if ((key == "flipbook:study" && value != toml) || (key == "flipbook:version" && value != version()))
          return false;
      return true;
    } catch (const UserError&) {
      return false;
    }
  }

  void draw(const std::string& name, const std::string& toml, const Workshop& shop) const {
    shop.say(Workshop::media(name + "_*"));
    render::set_draw_threads(1);
    Budget budget(shop.session.threads);
    const Budget::Permit permit(budget);
    Pool pool(budget);
    const Shots shots = take_shots(resolved_, times_, {pool, [](std::size_t, std::size_t) { Workshop::go_on(); }});
    const render::ViewSettings view = with_shared_range(resolved_.view, shots);
    const auto run = std::make_shared<RunProvenance>(RunProvenance{toml, "", ""});
    const auto context = render::Context::create(shop.session.gl);
    const render::Workers workers = [&pool](int chunks, const auto& body) { pool.each(chunks, body); };
    render::Renderer renderer(*context, resolved_.output.size[0], resolved_.output.size[1], make_panel(), workers);
    const std::unique_ptr<Sink> frames = sink(name, shop);
    Staging posters(shop.path(media_folder));
    for (std::size_t v = 0; v < shots.at.size(); ++v)
      for (std::size_t k = 0; k < times_.size(); ++k) {
        Workshop::go_on();
        render::Frame frame;
        frame.time = times_[k];
        frame.duration = resolved_.duration;
        frame.panes = {{shots.titles[v], shots.at[v][k]}};
        Picture picture{renderer.draw(frame, view), {run, v * times_.size() + k, times_[k], shots.titles[v]}};
        if (v == 0 && k == times_.size() / 2)
          posters.write(name + ".poster.png",
                        encode_png(picture.image, text_entries(picture.provenance), PngEffort::small));
        frames->write(picture);
      }
    frames->finish();
    frames->commit();
    posters.commit(); // last: it says that all the others are there
  }

  [[nodiscard]] std::unique_ptr<Sink> sink(const std::string& name, const Workshop& shop) const {
    const fs::path folder = shop.path(media_folder);
    if (shop.ffmpeg) return webp_pictures(folder, name + "_", video_settings(resolved_, ""));
    return png_files(
        folder, [name](const Provenance& p) { return fs::path(file(name, p.frame, ".png")).filename().string(); },
        folder);
  }

  [[nodiscard]] Piece piece(const std::string& name, const std::string& ending, std::size_t count,
                            const Workshop& shop) const {
    Piece p;
    p.kind = Piece::Kind::scrubber;
    p.id = name;
    p.title = entry_.title.empty() ? resolved_.title : entry_.title;
    p.text = entry_.text;
    p.width = resolved_.output.size[0];
    p.height = resolved_.output.size[1];
    p.poster = Workshop::media(name + ".poster.png");
    p.media = file(name, times_.size() / 2, ending);
    p.study = to_toml(study_);
    p.downloads = {{"Study", Workshop::media(name + ".toml")}};
    p.command = command();
    Scrubber& s = p.scrubber;
    s.parameter = entry_.vary;
    s.help = parameter_.help;
    s.unit = parameter_.unit;
    s.titles = titles_of(resolved_);
    s.times = times_;
    s.seconds = static_cast<double>(resolved_.frames) / resolved_.output.fps;
    for (const Value& v : entry_.values) s.values.push_back(plain(v));
    for (std::size_t i = 0; i < count; ++i) s.files.push_back(file(name, i, ending));
    s.width = p.width;
    s.height = p.height;
    p.alt = entry_.alt.empty() ? p.title + ". One picture for each value of " + entry_.vary + " and each moment."
                               : entry_.alt;
    if (!shop.ffmpeg) p.note = "These pictures are PNG and load slowly: there was no ffmpeg when the page was made.";
    return p;
  }

  /// The same values side by side.
  [[nodiscard]] std::string command() const {
    std::vector<std::string> words{"flipbook", "compare",
                                   is_path(entry_.what) ? fs::path(entry_.what).filename().string() : entry_.what};
    for (const auto* set : {&all_, &entry_.set})
      for (const std::string& w : set_options(*set)) words.push_back(w);
    std::string values;
    for (const Value& v : entry_.values) values += (values.empty() ? "" : ",") + plain(v);
    words.insert(words.end(), {"--vary", entry_.vary + "=" + values});
    return shell_command(words);
  }

  Entry entry_;
  std::vector<Assignment> all_;
  Study study_;
  Resolved resolved_;
  Parameter parameter_;
  std::vector<double> times_;
};

} // namespace

std::unique_ptr<Exhibit> scrub_exhibit(const Entry& entry, const std::vector<Assignment>& all) {
  return std::make_unique<ScrubExhibit>(entry, all);
}

} // namespace flipbook::app::gallery
