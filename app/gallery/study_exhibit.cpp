// SPDX-License-Identifier: MIT
// A study as a video, with its poster, subtitles and ledger. It is rendered again where the poster, which carries the
// study, says that another one was rendered, or another version did it.
#include "app/commands/outputs.h"
#include "app/encode/beside.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/encode/webp_pictures.h"
#include "app/gallery/exhibit.h"
#include "app/gallery/html.h"
#include "app/gallery/ledger_summary.h"
#include "app/gallery/studies.h"
#include "app/study/memory.h"
#include "sim/frame/errors.h"
#include "sim/scene/assets.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

bool is_there(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(file, none) && fs::file_size(file, none) > 0;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : between) + w;
  return text;
}

bool keeps_ledger(const Resolved& r) {
  return std::all_of(r.variants.begin(), r.variants.end(), [](const ResolvedVariant& v) {
    return v.scene.settings.preset != Preset::tutorial && v.scene.settings.ledger.on;
  });
}

class StudyExhibit final : public Exhibit {
public:
  StudyExhibit(const Entry& entry, const std::vector<Assignment>& all)
      : entry_(entry), all_(all), study_(study_of(entry, all)), resolved_(resolve(study_)) {
    refuse_too_large(resolved_);
    poster_ = entry.poster >= 0 ? entry.poster : resolved_.duration / 2;
  }

  [[nodiscard]] std::string name() const override { return file_name(study_.name); }

  Piece make(const std::string& name, Workshop& shop) override {
    const auto file = [&](const std::string& ending) { return Workshop::media(name + ending); };
    const std::string toml = to_toml(study_);
    if (!fresh(shop, file, toml)) render(shop, file, toml);
    write_file(shop.path(file(".toml")), to_toml(for_folder(study_, fs::absolute(shop.path(media_folder)).string())));
    return piece(name, shop, file);
  }

  void make_picture(const PictureRequest& request, const fs::path& file, Workshop& shop) override {
    const Study study = with(study_, request.set);
    const Resolved r = resolve(study);
    const std::string toml = to_toml(study);
    shop.say(file.string());
    Outputs outputs;
    if (request.at < 0) {
      outputs.pictures = video_sinks({file.string()}, r, toml);
      (void)run_session(r, toml, Schedule::video(r.output.fps, r.scale, r.frames), std::move(outputs), shop.session);
      return;
    }
    if (file.extension() == ".webp")
      outputs.pictures.push_back(webp_picture(file, video_settings(r, toml)));
    else
      outputs.pictures = still_sinks({file.string()}, r, 1);
    (void)run_session(r, toml, Schedule::stills(r.output.fps, r.scale, {request.at}), std::move(outputs), shop.session);
  }

private:
  using FileOf = std::function<std::string(const std::string& ending)>;

  [[nodiscard]] bool fresh(const Workshop& shop, const FileOf& file, const std::string& toml) const {
    const auto there = [&](const char* ending) { return is_there(shop.path(file(ending))); };
    if (!there(".poster.png") || (shop.ffmpeg && !there(".mp4"))) return false;
    if (keeps_ledger(resolved_) && !there(".csv")) return false;
    if (shop.ffmpeg && !subtitles_of(resolved_).empty() && !there(".vtt")) return false;
    try {
      std::string study, made_by, time;
      for (const auto& [key, value] : read_png_text(shop.path(file(".poster.png")))) {
        if (key == "flipbook:study") study = value;
        if (key == "flipbook:version") made_by = value;
        if (key == "flipbook:time") time = value;
      }
      const Value at = parse_value(time);
      const double* seconds = std::get_if<double>(&at);
      return study == toml && made_by == version() && seconds &&
             std::abs(*seconds - poster_) <= 0.51 * resolved_.scale / resolved_.output.fps;
    } catch (const UserError&) { // a damaged picture
      return false;
    }
  }

  void render(const Workshop& shop, const FileOf& file, const std::string& toml) const {
    shop.say(file(shop.ffmpeg ? ".mp4" : ".poster.png"));
    Outputs outputs;
    const std::string video = shop.path(file(".mp4")).string();
    if (shop.ffmpeg) outputs.pictures = video_sinks({video}, without_extras(), toml);
    outputs.pictures.push_back(poster_file(shop.path(file(".poster.png")), poster_));
    if (const std::vector<Cue> cues = subtitles_of(resolved_); shop.ffmpeg && !cues.empty())
      outputs.pictures.push_back(text_file(shop.path(file(".vtt")), to_vtt(cues)));
    if (keeps_ledger(resolved_))
      outputs.ledger = std::make_unique<LedgerFile>(shop.path(file(".csv")), "the gallery's ledger", resolved_);
    (void)run_session(resolved_, toml, Schedule::video(resolved_.output.fps, resolved_.scale, resolved_.frames),
                      std::move(outputs), shop.session);
  }

  /// The poster and the subtitles that the study may ask for have names here already.
  [[nodiscard]] Resolved without_extras() const {
    Resolved r = resolved_;
    r.output.poster = -1;
    r.output.subtitles = false;
    return r;
  }

  [[nodiscard]] Piece piece(const std::string& name, const Workshop& shop, const FileOf& file) const {
    Piece p;
    p.kind = shop.ffmpeg ? Piece::Kind::video : Piece::Kind::picture;
    p.id = name;
    p.title = entry_.title.empty() ? resolved_.title : entry_.title;
    p.text = entry_.text;
    p.width = resolved_.output.size[0];
    p.height = resolved_.output.size[1];
    p.poster = file(".poster.png");
    p.media = shop.ffmpeg ? file(".mp4") : p.poster;
    if (is_there(shop.path(file(".vtt"))) && shop.ffmpeg) p.subtitles = file(".vtt"), p.cues = subtitles_of(resolved_);
    p.alt = entry_.alt.empty() ? described() : entry_.alt;
    p.study = to_toml(study_);
    p.parameters = parameters_table(study_, resolved_);
    p.downloads = {{"Study", file(".toml")}};
    std::vector<std::string> words = command(name);
    if (keeps_ledger(resolved_)) {
      std::ifstream csv(shop.path(file(".csv")));
      p.kept = summarise_ledger(csv);
      p.downloads.emplace_back("Ledger", file(".csv"));
      words.insert(words.end(), {"--ledger", name + ".csv"});
    }
    p.command = shell_command(words);
    if (!shop.ffmpeg) p.note = "This is one picture of a video: there was no ffmpeg when the page was made.";
    return p;
  }

  /// That makes the same video, from the study's name or from the file beside the video.
  [[nodiscard]] std::vector<std::string> command(const std::string& name) const {
    std::vector<std::string> words{"flipbook", entry_.schemes.empty() || is_path(entry_.what) ? "render" : "compare"};
    if (is_path(entry_.what)) {
      words.push_back(name + ".toml");
    } else {
      words.push_back(entry_.what);
      if (!entry_.schemes.empty()) words.insert(words.end(), {"--schemes", entry_.schemes});
      for (const auto* set : {&all_, &entry_.set})
        for (const std::string& w : set_options(*set)) words.push_back(w);
    }
    words.insert(words.end(), {"-o", name + ".mp4"});
    return words;
  }

  /// For who does not see the picture.
  [[nodiscard]] std::string described() const {
    const std::vector<std::string> titles = titles_of(resolved_);
    std::string text = entry_.title.empty() ? resolved_.title : entry_.title;
    text += titles.size() == 1 ? ". One pane: " : ". " + std::to_string(titles.size()) + " panes side by side: ";
    text += joined(titles, ", ");
    render::ViewSettings view = resolved_.view;
    for (const Parameter& p : parameters_of(view))
      if (p.path == "view.colour") text += ". Particles are coloured by " + plain(p.value);
    return text + ", over " + to_toml(Value(std::round(resolved_.duration * 100) / 100)) + " s.";
  }

  Entry entry_;
  std::vector<Assignment> all_;
  Study study_;
  Resolved resolved_;
  double poster_;
};

} // namespace

std::unique_ptr<Exhibit> study_exhibit(const Entry& entry, const std::vector<Assignment>& all) {
  return std::make_unique<StudyExhibit>(entry, all);
}

} // namespace flipbook::app::gallery
