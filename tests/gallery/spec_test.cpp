// SPDX-License-Identifier: MIT
// The gallery's TOML and what the command line says in its place.
#include "app/gallery/exhibit.h"
#include "app/gallery/spec.h"
#include "sim/frame/errors.h"
#include "sim/scene/toml_reader.h"
#include "tests/unit/message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::app::gallery {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string mistakes(const std::string& text) {
  return message_of([&] { (void)parse_spec(text, "g.toml"); });
}

TEST(GallerySpec, ReadsEveryKindOfEntry) {
  const Spec spec =
      parse_spec("title = \"T\"\nintro = \"I\"\nall.output.crf = 30\n"
                 "[[entry]]\nstudy = \"dam_break\"\nposter = 1\nset = { grid.cells = [16, 16] }\n"
                 "[entry.picture]\nfile = \"x.webp\"\nat = 0.5\n"
                 "[[entry]]\nscrub = \"drop\"\nvary = \"transfer.flip_ratio\"\nvalues = [0, 1]\nframes = 5\n"
                 "[[entry]]\nfigure = \"kernels\"\nfast = true\n"
                 "[[entry]]\nfile = \"a/b.png\"\nalt = \"a picture\"\n",
                 "folder/g.toml");
  ASSERT_EQ(spec.entries.size(), 4U);
  EXPECT_EQ(spec.title, "T");
  EXPECT_EQ(spec.all.at(0).path, "output.crf");
  EXPECT_EQ(spec.entries[0].kind, "study");
  EXPECT_EQ(spec.entries[0].set.at(0).path, "grid.cells");
  EXPECT_EQ(spec.entries[0].picture->file, "x.webp");
  EXPECT_EQ(spec.entries[1].values.size(), 2U);
  EXPECT_EQ(spec.entries[1].frames, 5);
  EXPECT_TRUE(spec.entries[2].fast);
  EXPECT_EQ(path_of(spec.entries[3]), "folder/a/b.png") << "relative to the file that says it";
}

TEST(GallerySpec, NamesPlaceAndNearestName) {
  EXPECT_THAT(mistakes("[[entry]]\nstuddy = \"dam_break\"\n"), AllOf(HasSubstr("g.toml:2"), HasSubstr("\"study\"")));
  EXPECT_THAT(mistakes("[[entry]]\ntitle = \"x\"\n"), HasSubstr("an entry needs a study, scrub, figure or file"));
  EXPECT_THAT(mistakes("[[entry]]\nstudy = \"a\"\nfigure = \"b\"\n"), HasSubstr("g.toml:3"));
  EXPECT_THAT(mistakes("title = \"x\"\n"), HasSubstr("[[entry]]"));
  EXPECT_THAT(mistakes("[[entry]]\nscrub = \"drop\"\n"), HasSubstr("vary"));
  EXPECT_THAT(mistakes("[[entry]]\nscrub = \"drop\"\nvary = \"a\"\nvalues = [1]\n"), HasSubstr("2 to 12"));
  EXPECT_THAT(mistakes("[[entry]]\nscrub = \"drop\"\nvary = \"a\"\nvalues = [1, 2]\nframes = 100000\n"),
              HasSubstr("frames"));
  EXPECT_THAT(mistakes("[[entry]]\nstudy = \"a\"\n[entry.picture]\nfile = \"../x.webp\"\n"),
              HasSubstr("without folders"));
  EXPECT_THAT(mistakes("[[entry]]\nstudy = \"a\"\nset = 3\n"), HasSubstr("set"));
  EXPECT_THAT(mistakes("entry = 3\n"), HasSubstr("entry"));
}

TEST(GallerySpec, ReadsScrubsOfTheCommandLine) {
  const Entry e = parse_scrub("dam_break:transfer.kernel=linear,cubic");
  EXPECT_EQ(e.what, "dam_break");
  EXPECT_EQ(e.vary, "transfer.kernel");
  EXPECT_EQ(e.values, (std::vector<Value>{std::string("linear"), std::string("cubic")}));
  EXPECT_EQ(parse_scrub("a/b:c.toml:time.cfl=1,2").what, "a/b:c.toml");
  for (const char* wrong :
       {"dam_break", "dam_break:x", "dam_break=1,2", ":x=1,2", "dam_break:=1,2", "d:x=1", "d:x=1,,2"})
    EXPECT_THROW((void)parse_scrub(wrong), UserError) << wrong;
}

TEST(GallerySpec, FileNamesAreTame) {
  EXPECT_EQ(file_name("dam_break-2"), "dam_break-2");
  EXPECT_EQ(file_name("../../etc/passwd"), "etc_passwd");
  EXPECT_EQ(file_name("Caf\u00e9 \"x\""), "Caf_x");
  EXPECT_EQ(file_name("\u2603"), "entry");
  EXPECT_LE(file_name(std::string(500, 'a')).size(), 60U);
}

/// The one that comes with the program: it can be read, and every key of an entry is in it.
TEST(GallerySpec, TheOwnGalleryDocumentsEveryKey) {
  const std::string file = std::string(FLIPBOOK_SOURCE_DIR) + "/assets/gallery.toml";
  const std::string text = read_text_file(file);
  const Spec spec = read_spec(file);
  for (const Entry& e : spec.entries) EXPECT_NO_THROW((void)make_exhibit(e, spec.all)) << e.what;
  for (const char* key : {"title", "intro", "[all]", "study", "scrub", "figure", "file", "schemes", "text", "poster",
                          "alt", "set", "[entry.picture]", "at", "vary", "values", "frames", "fast", "width"})
    EXPECT_THAT(text, HasSubstr(key));
}

} // namespace
} // namespace flipbook::app::gallery
