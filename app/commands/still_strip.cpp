// SPDX-License-Identifier: MIT
// What `still` does with --rows and --cols: a filmstrip of a physical size.
#include "app/commands/axis.h"
#include "app/commands/run_options.h"
#include "app/commands/strip_request.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "app/figures/page.h"
#include "app/figures/particle_pictures.h"
#include "app/figures/shots.h"
#include "app/figures/strip.h"
#include "app/study/memory.h"
#include "app/validate/figure.h"
#include "render/compose/sheet_settings.h"
#include "render/context/context.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace flipbook::app {

namespace {

struct Body final : FigureBody {
  Strip strip;
  double draw(const FigureArea& area) const override { return draw_strip(area, strip); }
  [[nodiscard]] std::vector<FigureTable> tables() const override { return {}; }
};

/// The variants that the axes ask for, row by row; the study's own where no axis changes anything.
std::vector<Variant> variants_of(const Study& study, const Axis& rows, const Axis& columns) {
  const std::vector<Changes> all = panes_of(study, rows, columns);
  if (all.size() == 1 && all.front().empty()) return study.variants;
  std::vector<Variant> variants;
  for (const Changes& c : all) variants.push_back({"", c, {}});
  return variants;
}

/// Light, and with one colour scale for all pictures.
render::ViewSettings view_of(const Resolved& resolved, const Shots& shots) {
  render::ViewSettings view = resolved.view;
  view.theme = render::Theme::light;
  return with_shared_range(view, shots);
}

/// Puts variants and times where the rows and columns are.
Strip strip_of(const Resolved& resolved, Shots shots, const Axis& rows, const Axis& columns) {
  Strip strip{
      .rows = rows.labels, .columns = columns.labels, .shots = {}, .view = view_of(resolved, shots), .window = {}};
  const Snapshot& first = *shots.at.front().front();
  strip.window = {{first.lo[0], first.lo[1]}, {first.hi[0], first.hi[1]}};
  strip.walls = !first.periodic[0] && !first.periodic[1];
  const std::size_t times = shots.at.front().size();
  if (!rows.times.empty()) { // columns are the variants
    if (columns.empty()) strip.columns = shots.titles;
    for (std::size_t t = 0; t < times; ++t) {
      strip.shots.emplace_back();
      for (const auto& variant : shots.at) strip.shots.back().push_back(variant[t]);
    }
    return strip;
  }
  if (rows.empty()) strip.rows = columns.times.empty() ? std::vector<std::string>{""} : shots.titles;
  if (columns.empty()) strip.columns = {""};
  if (!columns.times.empty()) {
    strip.shots = std::move(shots.at);
    return strip;
  }
  for (std::size_t v = 0; v < shots.at.size(); ++v) { // both change the study, and there is one time
    if (v % strip.columns.size() == 0) strip.shots.emplace_back();
    strip.shots.back().push_back(shots.at[v].front());
  }
  return strip;
}

render::Medium medium_of(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".pdf" ? render::Medium::pdf : extension == ".svg" ? render::Medium::svg : render::Medium::pixels;
}

} // namespace

int RunOptions::make_strip(Study study, const StripRequest& request) const {
  const Axis rows = parse_axis(request.rows, "--rows", study), columns = parse_axis(request.columns, "--cols", study);
  if (!rows.times.empty() && !columns.times.empty()) throw UserError("--rows and --cols cannot both be times");
  std::vector<double> times = rows.times.empty() ? columns.times : rows.times;
  if (!times.empty() && !request.at.empty()) throw UserError("--at has no place beside times in --rows or --cols");
  if (times.empty()) times = request.at;
  if (times.size() != 1 && rows.times.empty() && columns.times.empty())
    throw UserError("a filmstrip needs times: --cols t=0.2,0.4, or one with --at");
  if (!mistake_.empty()) throw UserError("--with-mistake: a filmstrip shows none; use still without --rows and --cols");
  std::vector<std::filesystem::path> files(outputs_.begin(), outputs_.end());
  if (files.empty()) files.emplace_back("out/" + study.name + ".png");
  for (std::filesystem::path& f : files) {
    if (f.filename().empty()) f /= study.name + ".png";
    const std::string extension = f.extension().string();
    if (extension != ".png" && extension != ".pdf" && extension != ".svg")
      throw UserError("-o " + f.string() + ": a filmstrip is a .png, .pdf or .svg");
  }
  study.variants = variants_of(study, rows, columns);
  study.overridden = true;
  if (study.variants.size() > render::most_panes) // its study shows as many in no other way
    study.view.push_back({"view.layout", std::string("sheet"), {}});
  const Resolved resolved = resolve(study);
  refuse_too_large(resolved);
  const SessionOptions session = session_options();
  render::set_draw_threads(1);
  Budget budget(session.threads);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  Body body;
  body.strip = strip_of(resolved, take_shots(resolved, times, {pool}), rows, columns);
  FigureSpec spec;
  spec.claim = resolved.title;
  ParticlePictures pictures(session.gl, [&pool](int chunks, const auto& work) { pool.each(chunks, work); });
  for (const std::filesystem::path& f : files) {
    const DrawnFigure drawn = draw_figure(spec, body, {.width = request.width}, medium_of(f), print_density, pictures);
    Staging staged(f.has_parent_path() ? f.parent_path() : ".");
    if (drawn.file.empty())
      staged.write(f.filename().string(),
                   encode_png(drawn.image, {{"flipbook:version", version()}, {"flipbook:study", to_toml(study)}},
                              PngEffort::small, print_density));
    else
      staged.write(f.filename().string(), drawn.file);
    staged.commit();
    std::cout << f.string() << '\n';
  }
  return 0;
}

} // namespace flipbook::app
