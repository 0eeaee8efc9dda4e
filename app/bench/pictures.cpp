// SPDX-License-Identifier: MIT
// The four-pane study from end to end, and the drawing of one large 3D picture.
#include "app/bench/workload.h"
#include "app/commands/outputs.h"
#include "app/commands/variants.h"
#include "app/encode/png.h"
#include "app/encode/process.h"
#include "app/panel/panel.h"
#include "app/session/session.h"
#include "app/validate/experiment.h"
#include "render/renderer.h"
#include "sim/frame/errors.h"
#include "sim/scene/read_scene.h"

#include <algorithm>
#include <filesystem>
#include <sys/resource.h>
#include <unistd.h>

namespace flipbook::app {

namespace {

namespace fs = std::filesystem;

/// A folder for results that nobody keeps.
class ScratchFolder {
public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "flipbook-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw MachineError("cannot make a folder in " + fs::temp_directory_path().string());
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

/// What this program and its children (ffmpeg) have computed so far.
double cpu_seconds(int who) {
  rusage u{};
  getrusage(who, &u);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(u.ru_utime) + seconds(u.ru_stime);
}

/// `flipbook compare dam_break` with what the request changes.
Study four_panes(const BenchRequest& request) {
  Study study = study_of_scene("dam_break");
  std::vector<Assignment> changes = request.changes;
  const int frames = request.frames > 0 ? request.frames : request.small ? 2 : 120;
  changes.push_back(assign("output.frames", static_cast<double>(frames)));
  if (request.small) changes.push_back(assign("grid.cells", std::vector<double>{16, 16}));
  for (Assignment& a : changes) assign(study, std::move(a));
  std::string schemes;
  for (const std::string& s : chosen(request.schemes, {"pic", "flip:0.97", "flip:1", "apic"}))
    schemes += (schemes.empty() ? "" : ",") + s;
  for (Changes& pane : scheme_variants(schemes)) study.variants.push_back({"", std::move(pane), {}});
  return study;
}

void measure_panes(const Workload& w, const std::string& output, const BenchRequest& request, const TakeCase& take) {
  const Study study = four_panes(request);
  const Resolved resolved = resolve(study);
  const std::string toml = to_toml(study);
  CaseResult result{w.name, output == "frames/" ? "PNG" : "video", "", {}};
  for (int repeat = 0; repeat < request.repetitions(); ++repeat) {
    const ScratchFolder folder;
    reset_peak_memory();
    SessionProfile p;
    const SessionOptions options{.threads = request.threads, .gl = request.gl, .quiet = true, .profile = &p};
    const double own = cpu_seconds(RUSAGE_SELF), children = cpu_seconds(RUSAGE_CHILDREN);
    Outputs outputs{video_sinks({folder.file(output)}, resolved, toml), nullptr, nullptr};
    const Summary s = run_session(resolved, toml, Schedule::video(resolved.output.fps, resolved.scale, resolved.frames),
                                  std::move(outputs), options);
    const auto frames = static_cast<double>(s.pictures);
    result.about = grouped_number(frames) + " frames of " + std::to_string(resolved.output.size[0]) + "x" +
                   std::to_string(resolved.output.size[1]) + ", " + std::to_string(s.most_steps) +
                   " steps, drawn with " + s.context;
    if (repeat == 0) continue;
    Profile solvers;
    for (const Profile& v : p.variants) solvers += v;
    for (std::size_t i = 0; i < phase_names.size(); ++i)
      if (const double seconds = solvers.spent[i].wall; seconds > 0)
        result.add(std::string(phase_names[i]), "wall", "ms/frame", 1e3 * seconds / frames);
    const auto wall = [](const Profile& of, Phase phase) { return of.spent[static_cast<std::size_t>(phase)].wall; };
    result.add("draw", "wall", "ms/frame", 1e3 * wall(p.draw, Phase::draw) / frames);
    result.add("encode", "wall", "ms/frame", 1e3 * wall(p.encode, Phase::encode) / frames);
    result.add("run", "wall", "ms/frame", 1e3 * s.seconds / frames);
    result.add("run", "cpu", "ms/frame", 1e3 * (cpu_seconds(RUSAGE_SELF) - own) / frames);
    result.add("run", "cpu of the encoder", "ms/frame", 1e3 * (cpu_seconds(RUSAGE_CHILDREN) - children) / frames);
    result.add("run", "frames", "1/s", frames / s.seconds);
    result.add("run", "particle-steps", "M/s", 1e-6 * static_cast<double>(s.particle_steps) / s.seconds);
    result.add("run", "peak memory", "MiB", peak_memory() / (1 << 20));
  }
  take(result);
}

/// 73^3 cells: 0.32 x 73^3 x 8 particles, a million but for 0.4 %.
const char* const million = R"toml(
dim = 3
grid.size = [1, 1, 1]
grid.cells = [73, 73, 73]
ledger.on = false
[[body]]
shape = "box"
lo = [0, 0, 0]
hi = [0.4, 0.8, 1]
)toml";

/// Spends time on one part of a picture.
template <class Body> void add_part(CaseResult& result, bool counts, const std::string& part, Body&& body) {
  Profile p;
  const double children = cpu_seconds(RUSAGE_CHILDREN);
  {
    const Timed timed(&p, Phase::other);
    body();
  }
  if (!counts) return;
  const Profile::Spent& spent = p.spent[static_cast<std::size_t>(Phase::other)];
  result.add(part, "wall", "ms/frame", 1e3 * spent.wall);
  result.add(part, "cpu", "ms/frame", 1e3 * (spent.cpu + cpu_seconds(RUSAGE_CHILDREN) - children));
}

render::ViewSettings view_of(const std::vector<Assignment>& changes) {
  render::ViewSettings view;
  Mistakes mistakes;
  change_view(view, changes, mistakes);
  mistakes.raise();
  return view;
}

} // namespace

void run_panes(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  if (Process::find("ffmpeg")) measure_panes(w, "film.mp4", request, take);
  measure_panes(w, "frames/", request, take);
}

void run_drawing(const Workload& w, const BenchRequest& request, const TakeCase& take) {
  std::vector<Assignment> changes, view_changes{assign("view.range", std::vector<double>{0, 5})};
  for (const Assignment& a : request.changes) (a.path.starts_with("view.") ? view_changes : changes).push_back(a);
  if (request.small) changes.push_back(assign("grid.cells", std::vector<double>(3, 10)));
  const Scene scene = parse_scene(million, "bench", changes);
  const render::ViewSettings view = view_of(view_changes);
  render::set_draw_threads(1);
  Budget budget(request.threads);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  const auto sim = make_simulation(scene, pool);
  for (int frame = 1; frame <= request.frames; ++frame) advance(*sim, frame / 60.0);
  const int width = request.small ? 480 : 1920, height = request.small ? 270 : 1080;
  const auto context = render::Context::create(request.gl);
  render::Renderer renderer(*context, width, height, make_panel(),
                            [&pool](int chunks, const auto& body) { pool.each(chunks, body); });
  CaseResult result{w.name,
                    "one pane",
                    grouped_number(static_cast<double>(sim->particles())) + " particles, " + std::to_string(width) +
                        "x" + std::to_string(height) + ", drawn with " + std::string(context->name()),
                    {}};
  const auto run = std::make_shared<RunProvenance>();
  for (int repeat = 0; repeat < request.repetitions(); ++repeat) {
    const bool counts = repeat > 0;
    render::Frame frame;
    frame.title = "bench";
    add_part(result, counts, "snapshot", [&] {
      frame.panes = {{sim->title(), sim->snapshot(static_cast<std::uint64_t>(repeat), view.request())}};
    });
    Picture picture{{}, {run, 0, 0, ""}};
    add_part(result, counts, "draw", [&] { picture.image = renderer.draw(frame, view); });
    add_part(result, counts, "encode PNG", [&] { (void)encode_png(picture.image, {}); });
  }
  result.add("run", "peak memory", "MiB", peak_memory() / (1 << 20));
  take(result);
}

} // namespace flipbook::app
