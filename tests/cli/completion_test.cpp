// SPDX-License-Identifier: MIT
// What shells offer: by asking the program, and by running the script in a real bash.
#include "tests/cli/program.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace flipbook::test {

namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using Words = std::vector<std::string>;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What the program offers for the last of `words`, without the help.
Words offered(Words words) {
  const Folder f;
  words.insert(words.begin(), "complete");
  const Outcome o = run(words, f.path());
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.err, "");
  Words all = lines_of(o.out);
  for (std::string& line : all) line = line.substr(0, line.find('\t'));
  return all;
}

TEST(Completion, OffersCommandsButNotItself) {
  EXPECT_THAT(offered({""}), IsSupersetOf({"render", "compare", "still", "new", "completion", "man"}));
  EXPECT_THAT(offered({"com"}), ElementsAre("compare", "completion"));
  EXPECT_THAT(offered({"--"}), ElementsAre("--help", "--version"));
  EXPECT_THAT(offered({}), Contains("render"));
  EXPECT_THAT(offered({"comapre", ""}), IsEmpty());
}

TEST(Completion, OffersEveryOptionOfEveryCommand) {
  const Folder f;
  for (const std::string& command : offered({""})) {
    std::istringstream help(run({command, "--help"}, f.path()).out);
    const Words options = offered({command, "-"});
    for (std::string line; std::getline(help, line);) {
      const std::size_t at = line.find("--");
      if (line.starts_with("  -")) {
        EXPECT_THAT(options, Contains(line.substr(at, line.find(' ', at) - at))) << command;
      }
    }
  }
}

TEST(Completion, OffersAnOptionAgainOnlyIfItMayBeRepeated) {
  const Words options = offered({"render", "drop", "--dim", "3", "--set", "time.cfl=0.3", "-q", "-"});
  EXPECT_THAT(options, Contains("--set"));
  EXPECT_THAT(options, Not(Contains("--dim")));
  EXPECT_THAT(options, Not(Contains("--quiet")));
}

TEST(Completion, OffersTheValuesOfAnOption) {
  EXPECT_THAT(offered({"render", "drop", "--gl", ""}), ElementsAre("auto", "osmesa", "egl"));
  EXPECT_THAT(offered({"render", "drop", "--gl=o"}), ElementsAre("--gl=osmesa"));
  EXPECT_THAT(offered({"render", "--precision", "d"}), ElementsAre("double"));
  EXPECT_THAT(offered({"render", "drop", "--dim", ""}), ElementsAre("2", "3"));
  EXPECT_THAT(offered({"render", "drop", "--fps", ""}), IsEmpty());
  EXPECT_THAT(offered({"render", "drop", "-o", "x"}), ElementsAre(":files"));
  EXPECT_THAT(offered({"render", "drop", "--particles", ""}), ElementsAre(":folders"));
}

TEST(Completion, OffersArgumentsByTheirPlace) {
  EXPECT_THAT(offered({"render", "dam_break"}), IsSupersetOf({"dam_break", "dam_break_pillar", ":files"}));
  EXPECT_THAT(offered({"compare", "--dim", "3", "dro"}), ElementsAre("drop", "drop_on_sphere", ":files"));
  EXPECT_THAT(offered({"compare", "drop", ""}), IsEmpty());
  EXPECT_THAT(offered({"list", "s"}), ElementsAre("scenes", "studies", "schemes", "shapes"));
  EXPECT_THAT(offered({"new", "s"}), ElementsAre("scene", "study", "scheme"));
  EXPECT_THAT(offered({"new", "study", "x", "--scene", "gr"}), ElementsAre("gresho", ":files"));
  EXPECT_THAT(offered({"man", "ver"}), ElementsAre("verify"));
  EXPECT_THAT(offered({"completion", ""}), ElementsAre("bash", "zsh", "fish"));
}

TEST(Completion, OffersParametersAndTheirValues) {
  EXPECT_THAT(offered({"render", "x", "--set", "transfer.f"}), IsSupersetOf({"transfer.flip_ratio=", ":nospace"}));
  EXPECT_THAT(offered({"render", "x", "--set", "view.col"}), Contains("view.colour="));
  EXPECT_THAT(offered({"render", "x", "--set", "transfer.kernel="}),
              ElementsAre("transfer.kernel=linear", "transfer.kernel=quadratic", "transfer.kernel=cubic"));
  EXPECT_THAT(offered({"render", "x", "--set", "ledger.on=t"}), ElementsAre("ledger.on=true"));
  EXPECT_THAT(offered({"render", "x", "--set", "view.plots=kinetic,t"}),
              ElementsAre("view.plots=kinetic,total", "view.plots=kinetic,transfer_loss", ":nospace"));
  EXPECT_THAT(offered({"compare", "x", "--vary", "transfer.kernel=linear,c"}),
              ElementsAre("transfer.kernel=linear,cubic", ":nospace"));
  EXPECT_THAT(offered({"compare", "x", "--vary", "view."}), ElementsAre(":nospace")) << "the panes share the view";
  EXPECT_THAT(offered({"compare", "x", "--schemes", "pic,fl"}), ElementsAre("pic,flip", ":nospace"));
}

TEST(Completion, FindsOnesOwnScenesAndIgnoresBrokenOnes) {
  const Folder f;
  std::filesystem::create_directories(f.path() / "scenes");
  (void)f.write("scenes/zebra.toml", "summary = \"two\\nlines\"\n");
  (void)f.write("scenes/zen.toml", "summary = \n");
  const Outcome o = run({"complete", "render", "ze"}, f.path(), {.environment = {{"FLIPBOOK_ASSETS", f.path()}}});
  EXPECT_EQ(o.out, "zebra\ttwo lines\nzen\n:files\n");
  EXPECT_EQ(o.err, "");
}

// === The script, in a real bash

/// What bash would offer: `words` as bash splits them at '=' and ':' too, `line` as it was typed.
Words bash_offers(const Folder& f, const std::string& words, const std::string& line) {
  (void)f.write("completion.bash", run({"completion", "bash"}, f.path()).out);
  const std::string script = "source ./completion.bash || exit 9\n"
                             "complete -p flipbook >/dev/null || exit 8\n"
                             "COMP_WORDS=(" FLIPBOOK_BINARY_DIR "/flipbook " +
                             words +
                             ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\nCOMP_LINE='" FLIPBOOK_BINARY_DIR "/flipbook " +
                             line + "'\nCOMP_POINT=${#COMP_LINE}\n_flipbook\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const Outcome o = run_other({"bash", "--norc", "-c", script}, f.path());
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.err, "");
  return lines_of(o.out);
}

TEST(Bash, CompletesWordsItselfSplits) {
  const Folder f;
  EXPECT_THAT(bash_offers(f, "comp", "comp"), ElementsAre("compare", "completion"));
  EXPECT_THAT(bash_offers(f, "render drop --gl ''", "render drop --gl "), ElementsAre("auto", "osmesa", "egl"));
  EXPECT_THAT(bash_offers(f, "render drop --gl = os", "render drop --gl=os"), ElementsAre("osmesa"));
  EXPECT_THAT(bash_offers(f, "render x --set transfer.scheme = fl", "render x --set transfer.scheme=fl"),
              ElementsAre("flip"));
  EXPECT_THAT(bash_offers(f, "render x --set transfer.scheme =", "render x --set transfer.scheme="),
              IsSupersetOf({"pic", "apic"}));
  EXPECT_THAT(bash_offers(f, "compare x --schemes flip : 0.97,ap", "compare x --schemes flip:0.97,ap"),
              ElementsAre("0.97,apic"));
  EXPECT_THAT(bash_offers(f, "render x --fps ''", "render x --fps "), ElementsAre(""));
  EXPECT_THAT(bash_offers(f, "render x  --set  time.cf", "render x  --set  time.cf"), ElementsAre("time.cfl="));
}

TEST(Bash, OffersFilesBesideNames) {
  const Folder f;
  (void)f.write("drop_of_mine.toml", "");
  (void)f.write("drop.mp4", "");
  (void)f.write("my study.toml", "");
  std::filesystem::create_directory(f.path() / "my_folder");
  EXPECT_THAT(bash_offers(f, "render drop", "render drop"), ElementsAre("drop", "drop_on_sphere", "drop_of_mine.toml"));
  EXPECT_THAT(bash_offers(f, "render my", "render my"), ::testing::UnorderedElementsAre("my study.toml", "my_folder"));
  EXPECT_THAT(bash_offers(f, "render x -o drop.", "render x -o drop."), ElementsAre("drop.mp4"));
  EXPECT_THAT(bash_offers(f, "render x --particles my", "render x --particles my"), ElementsAre("my_folder"));
}

TEST(Bash, AllScriptsAreWellFormed) {
  const Folder f;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    (void)f.write("script", run({"completion", shell}, f.path()).out);
    EXPECT_THAT(read_file(f.path() / "script"), HasSubstr(" complete ")) << shell;
    const Outcome o = run_other({shell, "-n", "script"}, f.path());
    if (o.code == 122) continue; // that shell is not installed
    EXPECT_EQ(o.code, 0) << shell << ": " << o.err;
  }
}

} // namespace

} // namespace flipbook::test
