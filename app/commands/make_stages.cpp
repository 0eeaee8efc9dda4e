// SPDX-License-Identifier: MIT
// What `stages` does: runs to the time, looks at a step, and writes its pages.
#include "app/commands/outputs.h"
#include "app/commands/run_options.h"
#include "app/commands/stages_request.h"
#include "app/commands/variants.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/session/compose.h"
#include "app/stages/page.h"
#include "app/study/memory.h"
#include "app/study/with_mistake.h"
#include "render/chart/chart.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace flipbook::app {

namespace {

namespace fs = std::filesystem;

enum class StagesOutput { pages, sheet, video };

StagesOutput kind_of(const std::string& name) {
  std::error_code none;
  if (name.empty()) throw UserError("-o wants a name");
  if (name.ends_with('/') || fs::is_directory(name, none)) return StagesOutput::pages;
  const std::string kind = fs::path(name).extension().string();
  for (const char* sheet : {".png", ".pdf", ".svg"})
    if (kind == sheet) return StagesOutput::sheet;
  if (find_video_format(kind)) return StagesOutput::video;
  throw UserError("-o " + name + ": a sheet of all stages ends in .png, .pdf or .svg, a video in " +
                  video_extensions() + ", and a folder of pictures in /");
}

/// The steps that --variant names, in the order of the study.
std::vector<RecordedStep> chosen(const Resolved& study, std::vector<RecordedStep> steps, const std::string& wanted) {
  constexpr std::size_t most = 6;
  std::set<std::size_t> kept;
  if (wanted.empty())
    for (std::size_t v = 0; v < steps.size(); ++v) kept.insert(v);
  else
    for (const std::string& name : split_list(wanted, "--variant")) {
      std::vector<std::string> known;
      const std::size_t before = kept.size();
      for (std::size_t v = 0; v < steps.size(); ++v) {
        const std::vector<std::string> names{study.variants[v].label, steps[v].title, steps[v].before->scheme,
                                             std::to_string(v + 1)};
        known.push_back(steps[v].title);
        if (std::find(names.begin(), names.end(), name) != names.end()) kept.insert(v);
      }
      if (kept.size() == before)
        throw UserError("--variant " + name + ": the study has no such variant (1 to " + std::to_string(steps.size()) +
                            ")",
                        {}, nearest_name(name, known));
    }
  if (kept.size() > most)
    throw UserError(std::to_string(kept.size()) + " variants; the stages of at most " + std::to_string(most) +
                    " can be shown together: choose with --variant");
  std::vector<RecordedStep> out;
  for (const std::size_t v : kept) out.push_back(std::move(steps[v]));
  return out;
}

/// Everything that the writers below need.
struct Told {
  const Resolved& resolved;
  const StageBook& book;
  Provenance provenance;

  [[nodiscard]] TextEntries entries(const std::string& stage) const {
    TextEntries all = text_entries(provenance);
    all.emplace_back("flipbook:stage", stage);
    return all;
  }
  [[nodiscard]] std::string label(std::size_t k) const {
    return std::to_string(k + 1) + "/" + std::to_string(book.pages()) + " " + book.stage(k).name;
  }
  [[nodiscard]] render::Image page(std::size_t k) const {
    return book.page(k, resolved.output.size[0], resolved.output.size[1]);
  }
};

/// "drop_0.4s_3_forces.png"
std::string page_name(const Told& told, std::size_t k) {
  std::string stage = told.book.stage(k).name;
  std::transform(stage.begin(), stage.end(), stage.begin(), [](char c) {
    return c == ' ' ? '_' : 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  std::string number = std::to_string(k + 1);
  if (told.book.pages() > 9 && k < 9) number.insert(0, "0");
  return told.resolved.name + "_" + to_toml(Value(told.provenance.time)) + "s_" + number + "_" + stage + ".png";
}

void write_pages(const Told& told, const std::string& folder) {
  Staging staged{fs::path(folder)};
  for (std::size_t k = 0; k < told.book.pages(); ++k)
    staged.write(page_name(told, k), encode_png(told.page(k), told.entries(told.label(k)), PngEffort::small));
  staged.commit();
}

void write_sheet(const Told& told, const fs::path& file) {
  constexpr double larger = 1.5, points = 174 * 72 / 25.4; // pixels of a sheet for those of a page; 174 mm of paper
  const std::string kind = file.extension().string();
  const render::Medium medium = kind == ".pdf"   ? render::Medium::pdf
                                : kind == ".svg" ? render::Medium::svg
                                                 : render::Medium::pixels;
  const StageBook::Sheet sheet = told.book.sheet(
      medium, medium == render::Medium::pixels ? std::round(larger * told.resolved.output.size[0]) : points);
  Staging staged(file.has_parent_path() ? file.parent_path() : ".");
  if (medium == render::Medium::pixels)
    staged.write(file.filename().string(), encode_png(sheet.image, told.entries("all"), PngEffort::small));
  else
    staged.write(file.filename().string(), sheet.file);
  staged.commit();
}

render::Image mixed(const render::Image& a, const render::Image& b, double share) {
  render::Image out = a;
  for (std::size_t i = 0; i < out.rgba.size(); ++i)
    out.rgba[i] = static_cast<std::uint8_t>((1 - share) * a.rgba[i] + share * b.rgba[i] + 0.5);
  return out;
}

/// Each stage is held, then fades into the next.
void write_video(const Told& told, Sink& sink, const StagesRequest& request) {
  const double fps = told.resolved.output.fps;
  const auto hold = static_cast<std::size_t>(std::max(1.0, std::round(request.hold * fps)));
  const auto fade = static_cast<std::size_t>(std::round(request.fade * fps));
  Picture picture{told.page(0), told.provenance};
  for (std::size_t k = 0; k < told.book.pages(); ++k) {
    for (std::size_t i = 0; i < hold; ++i) sink.write(picture);
    if (k + 1 == told.book.pages()) break;
    const render::Image from = std::move(picture.image), to = told.page(k + 1);
    for (std::size_t i = 1; i <= fade; ++i) {
      picture.image = mixed(from, to, static_cast<double>(i) / static_cast<double>(fade + 1));
      sink.write(picture);
    }
    picture.image = to;
  }
  sink.finish();
  sink.commit();
}

/// A variant for each scheme instead of the study's own.
void use_schemes(Study& study, const std::string& schemes) {
  if (schemes.empty()) return;
  const std::vector<Changes> panes = scheme_variants(schemes);
  refuse_overlap(study, panes);
  study.variants.clear();
  for (const Changes& c : panes) study.variants.push_back({"", c, {}});
  study.overridden = true;
}

/// Before the work.
void refuse_what_cannot_be_shown(const Resolved& resolved, const StagesRequest& request) {
  for (const ResolvedVariant& v : resolved.variants)
    if (v.scene.settings.dim == 3) throw UserError("the stages of a step are drawn in 2D: give --dim 2");
  if (!request.window.empty()) (void)parse_window(request.window, resolved.variants.front().scene.settings);
  refuse_too_large(resolved);
  render::check_chart_fonts();
}

/// In the order of their names; `videos` are opened already.
void write_all(const Told& told, const std::vector<std::string>& names,
               const std::vector<std::unique_ptr<Sink>>& videos, const StagesRequest& request) {
  auto video = videos.begin();
  for (const std::string& name : names) {
    switch (kind_of(name)) {
    case StagesOutput::pages: write_pages(told, name); break;
    case StagesOutput::sheet: write_sheet(told, name); break;
    case StagesOutput::video: write_video(told, **video++, request); break;
    }
    std::cout << name << '\n';
  }
}

} // namespace

int RunOptions::make_stages(Study study, const StagesRequest& request) const {
  const std::vector<std::string> names =
      outputs_.empty() ? std::vector<std::string>{"out/" + study.name + "_stages.png"} : outputs_;
  for (const std::string& name : names) (void)kind_of(name);
  use_schemes(study, request.schemes);
  std::optional<museum::Choice> mistake;
  if (!mistake_.empty()) mistake = museum::parse_choice(mistake_);
  const Resolved resolved = resolve(mistake ? with_mistake(study, *mistake) : study);
  refuse_what_cannot_be_shown(resolved, request);
  const std::string toml = (mistake ? mistake_header(*mistake) : "") + to_toml(study);
  std::vector<std::unique_ptr<Sink>> videos; // what cannot be written is refused before the work
  for (const std::string& name : names)
    if (kind_of(name) == StagesOutput::video)
      videos.push_back(
          video_file(*find_video_format(fs::path(name).extension().string()), name, video_settings(resolved, toml)));
  Budget budget(session_options().threads);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  std::vector<RecordedStep> steps = chosen(resolved, record_steps(resolved, request.at, {pool}), request.variant);
  Provenance provenance{app::describe_run(resolved, toml), steps.front().before->frame, request.at, ""};
  for (const RecordedStep& s : steps) provenance.variants += (provenance.variants.empty() ? "" : "\n") + s.title;
  const StageBook book(resolved.title, std::move(steps), request.window, resolved.view.theme);
  write_all({resolved, book, std::move(provenance)}, names, videos, request);
  return 0;
}

} // namespace flipbook::app
