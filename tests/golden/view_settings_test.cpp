// SPDX-License-Identifier: MIT
#include "render/views/colour_by.h"
#include "tests/golden/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flipbook::test {
namespace {

using testing::Contains;

TEST(ViewSettings, OfferEveryQuantityAndMap) {
  render::ViewSettings view;
  for (const Parameter& p : parameters_of(view)) {
    for (const auto& q : render::colour_quantities()) {
      if (p.path == "view.colour") {
        EXPECT_THAT(p.options, Contains(std::string(q.name)));
      }
    }
    for (const auto& m : render::colour_maps()) {
      if (p.path == "view.map") {
        EXPECT_THAT(p.options, Contains(std::string(m.name)));
      }
    }
    EXPECT_FALSE(p.help.empty()) << p.path;
  }
}

TEST(ViewSettings, RequestWhatTheyDraw) {
  EXPECT_THAT(render::ViewSettings{}.request().channels, testing::ElementsAre("speed"));
  EXPECT_FALSE(render::ViewSettings{}.request().faces);
  EXPECT_THAT(view_with({"view.colour=vorticity"}).request().channels, testing::ElementsAre("vorticity"));
  EXPECT_TRUE(view_with({"view.arrows=true"}).request().faces);
  EXPECT_TRUE(view_with({"view.colour=id"}).request().channels.empty());
  EXPECT_FALSE(render::ViewSettings{}.request().noise);
  EXPECT_TRUE(view_with({"view.plots=kinetic,noise"}).request().noise);
  EXPECT_FALSE(view_with({"view.plots=noise", "view.plot_height=0"}).request().noise) << "it costs a transfer";
}

TEST(ViewSettings, RefuseWithTheNearestName) {
  render::ViewSettings view;
  EXPECT_EQ(set_parameter(view, "view.colour", Value(std::string("vorticty"))).nearest, "vorticity");
  EXPECT_EQ(set_parameter(view, "view.colur", Value(std::string("speed"))).nearest, "view.colour");
}

} // namespace
} // namespace flipbook::test
