// SPDX-License-Identifier: MIT
#include "app/study/memory.h"
#include "app/study/paths.h"
#include "app/study/resolve.h"
#include "app/study/sheet_names.h"
#include "app/study/titles.h"
#include "sim/core/parallel.h"
#include "sim/simulation.h"
#include "tests/unit/message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace flipbook::app {
namespace {

const std::string scene = "[scene]\ngrid.cells = [16, 16]\nduration = 2\n[[scene.body]]\nshape = \"box\"\n"
                          "lo = [0, 0]\nhi = [1, 0.5]\n";
const std::string two = "[[variant]]\ntransfer.scheme = \"flip\"\ntransfer.flip_ratio = 0.97\n"
                        "[[variant]]\ntransfer.scheme = \"apic\"\n";

Resolved resolved(const std::string& text) {
  return resolve(parse_study(text, "s.toml"));
}

/// Line and column in what follows the first line, which stands for the scene.
std::string mistake(const std::string& text) {
  return message_of([&] { (void)resolved("scene = \"dam_break\"\n" + text); });
}

TEST(Study, IsWhatTheFileSays) {
  const Resolved r = resolved("title = \"T\"\ntransfer.kernel = \"cubic\"\ntime.scale = 0.5\nview.theme = \"light\"\n"
                              "[output]\nfps = 20\nsize = [640, 480]\n" +
                              scene + two);
  EXPECT_EQ(r.name, "s");
  EXPECT_EQ(r.title, "T");
  ASSERT_EQ(r.variants.size(), 2U);
  for (const ResolvedVariant& v : r.variants) EXPECT_EQ(v.scene.settings.transfer.kernel, KernelName::cubic);
  EXPECT_EQ(r.variants[0].scene.settings.transfer.title(), "FLIP 0.97");
  EXPECT_EQ(r.variants[1].scene.settings.transfer.title(), "APIC");
  EXPECT_EQ(r.view.theme, render::Theme::light);
  EXPECT_EQ(r.output.size, (std::array{640, 480}));
  EXPECT_EQ(r.frames, 80U) << "2 s simulated = 4 s of video at 20 frames a second";
  EXPECT_DOUBLE_EQ(r.duration, 2);
  EXPECT_DOUBLE_EQ(r.time_of(40), 1);
}

TEST(Study, OfASceneHasOneVariant) {
  EXPECT_EQ(resolve(study_of_scene("dam_break")).variants.size(), 1U);
  EXPECT_EQ(read_study("taylor_green").variants.size(), 1U) << "no study has this name, but a scene";
  EXPECT_EQ(resolve(study_of_scene("taylor_green")).view.colour, [] {
    render::ViewSettings v;
    EXPECT_EQ(set_parameter(v, "view.colour", std::string("vorticity")).message, "");
    return v.colour;
  }()) << "the scene's suggestion";
}

TEST(Study, ShipsReady) {
  for (const std::string& name : list_studies())
    EXPECT_EQ(message_of([&] { (void)resolve(read_study(name)); }), "no error");
  // What a lecture or the gallery shows.
  for (const char* name :
       {"dam_break", "dam_break_3d", "spinning_disc", "blend_slider", "fading_vortices", "sand_runout"}) {
    const Resolved r = resolve(read_study(name));
    const double seconds = static_cast<double>(r.frames) / r.output.fps;
    EXPECT_GE(seconds, 10) << name;
    EXPECT_LE(seconds, 20) << name;
  }
  const Resolved r = resolve(read_study("dam_break"));
  ASSERT_EQ(r.variants.size(), 4U);
  EXPECT_FALSE(r.commands().empty());
  for (const Command& c : r.commands()) EXPECT_EQ(c.variant, 1);
}

TEST(Study, WrittenAsTextReadsBackToItself) {
  for (const std::string& name : list_studies()) {
    const Study a = read_study(name);
    const std::string text = to_toml(a);
    const Study b = parse_study(text, "elsewhere/copy.toml");
    EXPECT_EQ(to_toml(b), text);
    const Resolved ra = resolve(a), rb = resolve(b);
    EXPECT_EQ(ra.title, rb.title);
    EXPECT_EQ(ra.frames, rb.frames);
    ASSERT_EQ(ra.variants.size(), rb.variants.size());
    for (std::size_t i = 0; i < ra.variants.size(); ++i) {
      Settings sa = ra.variants[i].scene.settings, sb = rb.variants[i].scene.settings;
      const auto pa = parameters_of(sa), pb = parameters_of(sb);
      for (std::size_t p = 0; p < pa.size(); ++p) EXPECT_EQ(pa[p].value, pb[p].value) << pa[p].path;
      EXPECT_EQ(ra.variants[i].scene.name, rb.variants[i].scene.name);
      EXPECT_EQ(ra.variants[i].label, rb.variants[i].label);
    }
    const CommandLog ca = ra.commands(), cb = rb.commands();
    ASSERT_EQ(ca.size(), cb.size());
    for (std::size_t i = 0; i < ca.size(); ++i)
      EXPECT_EQ(std::get<SetParameter>(ca[i].action).value, std::get<SetParameter>(cb[i].action).value);
  }
}

TEST(Study, TextHasAFixedOrder) {
  const std::string a = "time.cfl = 0.25\ngrid.cells = [8, 8]\nview.grid = true\n",
                    b = "view.grid = true\ngrid.cells = [8, 8]\ntime.cfl = 1\ntime.dt = 0.1\n";
  Study first = parse_study(a + scene, "s.toml"), second = parse_study(b + scene, "s.toml");
  assign(first, {"time.dt", 0.1, {}});
  assign(second, {"time.cfl", 0.25, {}});
  EXPECT_EQ(to_toml(first), to_toml(second));
}

TEST(Study, ACommandLineOverridesVariants) {
  Study s = parse_study(scene + two, "s.toml");
  assign(s, {"transfer.flip_ratio", 0.5, {}});
  assign(s, {"view.grid", true, {}});
  assign(s, {"output.fps", 10.0, {}});
  const Resolved r = resolve(s);
  EXPECT_EQ(r.variants[0].scene.settings.transfer.title(), "FLIP 0.5");
  EXPECT_TRUE(r.view.grid);
  EXPECT_EQ(r.frames, 20U);
}

TEST(Study, SaysWhereAMistakeIs) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"grid.cell = [8, 8]\n", "s.toml:2:6: unknown parameter \"grid.cell\"; did you mean \"grid.cells\"?"},
      {"[view]\ncolor = \"speed\"\n", "s.toml:3:1: unknown parameter \"view.color\"; did you mean \"view.colour\"?"},
      {"[output]\nfps = 0\n", "s.toml:3:1: output.fps must be a number from 1 to 240 (1/s), not 0"},
      {"[[variant]]\ntransfer.scheme = \"flp\"\n",
       "s.toml:3:10: transfer.scheme must be one of \"pic\", \"flip\", "
       "\"rpic\", \"apic\", \"aflip\", \"asflip\", \"polypic\", \"xpic\", not \"flp\"; did you "
       "mean \"flip\"?"},
      {"[[variant]]\ntransfer.flip_ratio = 2\n",
       "s.toml:3:10: transfer.flip_ratio must be a number from 0 to 1, not 2"},
      {"variant = []\n", "s.toml:2:1: a study has 1 to 12 variants, not 0"},
      {"variant = 3\n",
       "s.toml:2:1: a variant is written as [[variant]]\ns.toml:2:1: a study has 1 to 12 variants, not 0"},
      {"[[variant]]\n[[variant]]\ntime.scale = 2\n",
       "s.toml:3:1: time.scale must be the same for all variants: they share their frames"},
      {two + "[[key]]\nt = 1\ntransfer.flip_ratoi = 1\n",
       "s.toml:9:10: unknown parameter \"transfer.flip_ratoi\"; did you mean \"transfer.flip_ratio\"?"},
      {"transfer.scheme = \"pic\"\n[[key]]\nt = 1\ntransfer.flip_ratio = 1\n",
       "s.toml:5:10: no variant uses transfer.flip_ratio at t = 1"},
      {two + "[[key]]\nt = 1\nvariant = \"apick\"\ntransfer.affine = 1\n",
       "s.toml:10:10: no variant is called \"apick\"; did you mean \"APIC\"?"},
      {two + "[[key]]\nt = 1\nvariant = \"APIC\"\ntransfer.flip_ratio = 1\n",
       "s.toml:10:10: no variant uses transfer.flip_ratio at t = 1"},
      {"[[key]]\nt = 1\ngrid.cells = [8, 8]\n", "s.toml:4:6: grid.cells cannot change during a run"},
      {"[[key]]\nt = 1\ntime.cfl = nan\n", "s.toml:4:6: time.cfl must be a number from 0.01 to 5, not nan"},
      {"[[key]]\nt = 1\npressure.tolerance = 1e-9\n",
       "s.toml:4:10: a pressure.tolerance of 1e-09 cannot be reached in single precision; set precision = \"double\""},
      {"[[key]]\nt = -1\ntime.cfl = 1\n", "s.toml:3:1: \"t\" must be a number from 0 to 1000000, not -1"},
      {"[[key]]\nt = nan\ntime.cfl = 1\n", "s.toml:3:1: \"t\" must be a number from 0 to 1000000, not nan"},
      {"[[key]]\ntime.cfl = 1\n", "s.toml:2:1: a key needs \"t\""},
      {"[[key]]\nt = 1\n", "s.toml:2:1: a key needs a parameter, for example transfer.flip_ratio = 0.5, or a label"},
      {"[[key]]\nt = 1\nover = -1\ntime.cfl = 1\n", "s.toml:4:1: \"over\" must be a number from 0 to 1000000, not -1"},
      {"[[key]]\nt = 1\nease = \"smoth\"\ntime.cfl = 1\n", "s.toml:4:1: there is no ease \"smoth\": it is \"smooth\", "
                                                           "\"linear\" or \"step\"; did you mean \"smooth\"?"},
      {"[[key]]\nt = 2\ntime.cfl = 1\n[[key]]\nt = 1\ntime.cfl = 2\n",
       "s.toml:6:1: keys must be in the order of their times: t = 1 comes after t = 2"},
      {"[output]\nfps = 240\nduration = 100000\n", "the run would have 24000000 frames; at most 1000000 are supported"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(mistake(text), message);
  std::string many;
  for (int i = 0; i < 13; ++i) many += "[[variant]]\nlabel = \"a\"\n";
  EXPECT_EQ(mistake(many), "s.toml:2:3: a study has 1 to 12 variants, not 13; with view.layout = \"sheet\" up to 36");
  EXPECT_EQ(mistake("view.layout = \"sheet\"\n" + many), "no error");
}

TEST(Study, SaysWhatIsWrongWithItsScene) {
  const auto message = [](const std::string& text) { return message_of([&] { (void)parse_study(text, "s.toml"); }); };
  EXPECT_EQ(message("title = \"a\"\n"), "s.toml:1:1: a study needs a scene, for example scene = \"dam_break\"");
  EXPECT_EQ(message("scene = 3\n"), "s.toml:1:1: \"scene\" must be the name of a scene, a path or a table");
  EXPECT_EQ(message("scene = \"dam_brake\"\n"),
            "s.toml:1:1: there is no scene \"dam_brake\"; did you mean \"dam_break\"?");
  EXPECT_EQ(message_of([] { (void)read_study("damm_break"); }),
            "there is no study or scene \"damm_break\"; did you mean \"dam_break\"?");
  EXPECT_EQ(message_of([] { (void)read_study("x/y.toml"); }), "there is no file \"x/y.toml\"");
}

TEST(Study, PlotNamesAreTheColumnsOfTheLedger) {
  Budget budget(1);
  const Budget::Permit permit(budget);
  Pool pool(budget);
  FrameRequest request;
  request.noise = true;
  std::vector<std::string> found;
  for (const char* run : {"dim = 2", "dim = 3\ntime.splitting = \"midpoint\"\nfluid.spacing = 0.5",
                          "solver = \"transfer\"\ntime.dt = 1", "solver = \"mpm\"\nfluid.gravity = [0, 0, 0]"}) {
    const Scene s = parse_scene(run + std::string("\ngrid.cells = [4, 4, 4]\n[[body]]\nshape = \"box\"\nlo = [0, 0]\n"
                                                  "hi = [1, 0.5]\nvelocity = [\"y\", 0]\n"),
                                "s.toml");
    const auto snapshot = make_simulation(s, pool)->snapshot(0, request);
    for (const auto& column : snapshot->history->columns)
      if (std::find(found.begin(), found.end(), column.name) == found.end()) found.push_back(column.name);
  }
  std::vector<std::string> listed = plot_names();
  EXPECT_EQ(std::erase(listed, "lost"), 1U) << "stands for the columns of all stages";
  EXPECT_EQ(std::erase(listed, "difference"), 1U) << "is of two panes, which no simulation knows";
  std::sort(found.begin(), found.end());
  std::sort(listed.begin(), listed.end());
  EXPECT_EQ(found, listed);
}

/// Half of 16 x 16 cells is wet: 128 cells with 4 particles each, in two variants.
TEST(Study, SaysHowMuchMemoryItNeeds) {
  const Resolved r = resolved(scene + two);
  const Need need = memory_need(r);
  EXPECT_EQ(need.cells, 512);
  EXPECT_NEAR(need.particles, 1024, 1);
  EXPECT_EQ(message_of([&] { refuse_too_large(r, need.bytes); }), "no error");
  const std::string message = message_of([&] { refuse_too_large(r, need.bytes / 2); });
  EXPECT_NE(message.find("0.000512 million cells and 0.00102 million particles"), std::string::npos) << message;
  EXPECT_NE(message.find("this machine has"), std::string::npos) << message;
}

// === Titles

TitledPane pane(const std::string& text, const std::string& label = "") {
  Settings s = parse_scene(text + "\n[[body]]\nshape = \"box\"\nlo = [0, 0]\nhi = [1, 1]\n", "t.toml").settings;
  return {label, s.transfer.title(), parameters_of(s)};
}

TEST(Titles, NameTheSolverAndWhatDiffers) {
  using Titles = std::vector<std::string>;
  const auto titles = [](const std::vector<TitledPane>& panes) { return pane_titles(panes); };
  const std::string flip = "transfer.scheme = \"flip\"\ntransfer.flip_ratio = 0.97";
  EXPECT_EQ(titles({pane(flip), pane("transfer.scheme = \"pic\"")}), (Titles{"FLIP 0.97", "PIC"}));
  EXPECT_EQ(titles({pane(flip), pane("transfer.kernel = \"quadratic\"")}),
            (Titles{"FLIP 0.97, linear", "APIC, quadratic"}));
  EXPECT_EQ(titles({pane("grid.cells = [32, 32]"), pane("grid.cells = [64, 64]")}),
            (Titles{"APIC, 32 × 32 cells", "APIC, 64 × 64 cells"}));
  EXPECT_EQ(titles({pane("time.cfl = 0.25"), pane("")}), (Titles{"APIC, CFL 0.25", "APIC, CFL 0.5"}));
  EXPECT_EQ(titles({pane("time.dt = 0.01"), pane("")}), (Titles{"APIC, dt ≤ 0.01 s", "APIC"}));
  EXPECT_EQ(titles({pane("time.splitting = \"midpoint\""), pane("precision = \"double\"")}),
            (Titles{"APIC, single precision, midpoint splitting", "APIC, double precision, lie splitting"}));
  EXPECT_EQ(titles({pane("fluid.spacing = 0.5"), pane("")}), (Titles{"APIC, spacing 0.5", "APIC, spacing 0"}));
  EXPECT_EQ(titles({pane("fluid.density = 700"), pane("")}),
            (Titles{"APIC, density 700 kg/m^3", "APIC, density 1000 kg/m^3"}));
  EXPECT_EQ(titles({pane("time.cfl = 0.25", "small steps"), pane("")}), (Titles{"small steps", "APIC, CFL 0.5"}));
  EXPECT_EQ(titles({pane("transfer.scheme = \"rpic\"\ntransfer.form = \"skew\""), pane("transfer.scheme = \"rpic\"")}),
            (Titles{"RPIC skew", "RPIC"}));
  const std::string aflip = "transfer.scheme = \"aflip\"\n";
  EXPECT_EQ(titles({pane(aflip + "transfer.affine = 0.5"), pane(aflip)}),
            (Titles{"AFLIP 1, affine 0.5", "AFLIP 1, affine 1"}));
  EXPECT_EQ(titles({pane("")}), (Titles{"APIC"}));
}

TEST(MarginNames, SayWhatDiffersFromRowToRowAndFromColumnToColumn) {
  using Names = std::vector<std::string>;
  std::vector<TitledPane> panes;
  for (const char* ratio : {"0", "0.5", "1"})
    for (const char* kernel : {"linear", "quadratic"})
      panes.push_back(pane(std::string("transfer.scheme = \"flip\"\ntransfer.flip_ratio = ") + ratio +
                           "\ntransfer.kernel = \"" + kernel + "\""));
  EXPECT_EQ(margin_names(panes, 2).rows, (Names{"FLIP 0", "FLIP 0.5", "FLIP 1"}));
  EXPECT_EQ(margin_names(panes, 2).columns, (Names{"linear", "quadratic"}));
  EXPECT_EQ(margin_names(panes, 3).rows, Names{}) << "the ratio differs along both";
  panes[3].label = "mine";
  EXPECT_EQ(margin_names(panes, 2).rows, Names{}) << "a label says something else";
}

TEST(MarginNames, PartASchemeFromItsNumber) {
  using Names = std::vector<std::string>;
  std::vector<TitledPane> panes;
  for (const char* scheme : {"pic", "flip", "aflip"})
    for (const char* ratio : {"0.5", "0.95"})
      panes.push_back(pane(std::string("transfer.scheme = \"") + scheme + "\"\ntransfer.flip_ratio = " + ratio +
                           "\ntime.cfl = " + (ratio[2] == '5' ? "0.5" : "0.25")));
  const MarginNames names = margin_names(panes, 2);
  EXPECT_EQ(names.rows, (Names{"PIC", "FLIP", "AFLIP"}));
  EXPECT_EQ(names.columns, (Names{"flip ratio 0.5, CFL 0.5", "flip ratio 0.95, CFL 0.25"}));
}

TEST(MarginNames, OfOneRowOrOneColumnStandAlone) {
  const std::vector<TitledPane> panes{pane("transfer.scheme = \"pic\""), pane("")};
  EXPECT_EQ(margin_names(panes, 2).rows.size(), 0U);
  EXPECT_EQ(margin_names(panes, 2).columns, (std::vector<std::string>{"PIC", "APIC"}));
  EXPECT_EQ(margin_names(panes, 1).rows, (std::vector<std::string>{"PIC", "APIC"}));
  EXPECT_EQ(margin_names(panes, 1).columns.size(), 0U);
}

} // namespace
} // namespace flipbook::app
