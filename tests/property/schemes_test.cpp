// SPDX-License-Identifier: MIT
#include "tests/property/cases.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace flipbook {
namespace {

TransferSettings with(std::string_view scheme) {
  TransferSettings t;
  const SchemeRequest r = parse_scheme(scheme);
  t.scheme = r.scheme;
  if (r.number) {
    const auto refusal = set_parameter(t, r.number->first.substr(std::string("transfer.").size()), r.number->second);
    EXPECT_EQ(refusal.message, "");
  }
  return t;
}

Parameter parameter(TransferSettings& t, const std::string& path) {
  const auto all = parameters_of(t);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [&](const auto& p) { return p.path == path; }), 1) << path;
  return *std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.path == path; });
}

TEST(Schemes, TitlesNameTheSchemeAndWhatDistinguishesIt) {
  EXPECT_EQ(with("pic").title(), "PIC");
  EXPECT_EQ(with("flip").title(), "FLIP 1");
  EXPECT_EQ(with("flip:0.97").title(), "FLIP 0.97");
  EXPECT_EQ(with("rpic").title(), "RPIC");
  EXPECT_EQ(with("apic").title(), "APIC");
  EXPECT_EQ(with("apic:0.5").title(), "APIC 0.5");
  EXPECT_EQ(with("aflip:0.99").title(), "AFLIP 0.99");
  EXPECT_EQ(with("polypic").title(), "PolyPIC");
  EXPECT_EQ(with("xpic").title(), "XPIC 5");
  EXPECT_EQ(with("xpic:2").title(), "XPIC 2");
  auto t = with("rpic");
  EXPECT_EQ(set_parameter(t, "form", std::string("skew")).message, "");
  EXPECT_EQ(t.title(), "RPIC skew");
  EXPECT_EQ(TransferSettings().title(), "APIC");
  EXPECT_EQ(with("flip").name(), "flip");
}

TEST(Schemes, EachIsItsCornerOfTheFamily) {
  EXPECT_EQ(with("pic").corner().mode, AffineMode::none);
  EXPECT_EQ(with("pic").corner().flip_ratio, 0);
  EXPECT_EQ(with("flip:0.97").corner().mode, AffineMode::none);
  EXPECT_EQ(with("flip:0.97").corner().flip_ratio, 0.97);
  EXPECT_EQ(with("rpic:0.25").corner().mode, AffineMode::rigid);
  EXPECT_EQ(with("rpic:0.25").corner().affine, 0.25);
  EXPECT_EQ(with("rpic:0.25").corner().flip_ratio, 0);
  EXPECT_EQ(with("apic:0.5").corner().mode, AffineMode::full);
  EXPECT_EQ(with("apic:0.5").corner().affine, 0.5);
  EXPECT_FALSE(with("apic").corner().skew);
  EXPECT_EQ(with("aflip:0.99").corner().mode, AffineMode::full);
  EXPECT_EQ(with("aflip:0.99").corner().flip_ratio, 0.99);
  EXPECT_EQ(with("aflip:0.99").corner().affine, 1);
  EXPECT_EQ(with("polypic:0.5").corner().mode, AffineMode::polynomial);
  EXPECT_EQ(with("polypic:0.5").corner().affine, 0.5);
  EXPECT_EQ(with("xpic:3").corner().mode, AffineMode::none);
  EXPECT_EQ(with("xpic:3").corner().order, 3);
}

TEST(Schemes, ASharedPathBelongsToTheSchemeInUse) {
  auto t = with("flip:0.9");
  EXPECT_EQ(scheme_of<Flip>(t).flip_ratio, 0.9);
  EXPECT_EQ(scheme_of<Aflip>(t).flip_ratio, 1);
  EXPECT_TRUE(parameter(t, "flip_ratio").applies);
  EXPECT_FALSE(parameter(t, "affine").applies);

  t.scheme = scheme_index<Aflip>;
  EXPECT_TRUE(parameter(t, "flip_ratio").applies);
  EXPECT_TRUE(parameter(t, "affine").applies);
  EXPECT_FALSE(parameter(t, "form").applies);
  EXPECT_EQ(set_parameter(t, "flip_ratio", 0.5).message, "");
  EXPECT_EQ(scheme_of<Flip>(t).flip_ratio, 0.9);
  EXPECT_EQ(scheme_of<Aflip>(t).flip_ratio, 0.5);

  t.scheme = scheme_index<Pic>; // has neither: shown is the first scheme's
  EXPECT_FALSE(parameter(t, "flip_ratio").applies);
  EXPECT_EQ(std::get<double>(parameter(t, "flip_ratio").value), 0.9);
}

TEST(Schemes, SwitchingIsByName) {
  TransferSettings t;
  EXPECT_EQ(set_parameter(t, "scheme", std::string("rpic")).message, "");
  EXPECT_EQ(t.scheme, scheme_index<Rpic>);
  EXPECT_EQ(set_parameter(t, "kernel", std::string("cubic")).message, "");
  EXPECT_EQ(t.kernel, KernelName::cubic);
  EXPECT_EQ(set_parameter(t, "scheme", std::string("apci")).nearest, "apic");
  EXPECT_NE(set_parameter(t, "flip_ratio", 1.5).message, "");
}

TEST(Schemes, TextIsReadWithoutRegardToCase) {
  EXPECT_EQ(parse_scheme("FLIP").scheme, scheme_index<Flip>);
  EXPECT_FALSE(parse_scheme("FLIP").number);
  const auto r = parse_scheme("Apic:0.5");
  EXPECT_EQ(r.scheme, scheme_index<Apic>);
  ASSERT_TRUE(r.number);
  EXPECT_EQ(r.number->first, "transfer.affine");
  EXPECT_EQ(r.number->second, 0.5);
}

TEST(Schemes, WrongTextIsRefusedWithAHint) {
  const auto message = [](const char* text) -> std::string {
    try {
      (void)parse_scheme(text);
    } catch (const UserError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(message("flop"), testing::HasSubstr("\"flip\""));
  EXPECT_THAT(message(""), testing::HasSubstr("unknown scheme"));
  EXPECT_THAT(message("pic:0.5"), testing::HasSubstr("PIC has no parameter"));
  EXPECT_THAT(message("flip:"), testing::HasSubstr("not a number"));
  EXPECT_THAT(message("flip:0.5x"), testing::HasSubstr("\"0.5x\" is not a number"));
  EXPECT_THAT(message("flip:1.5"), testing::HasSubstr("transfer.flip_ratio must be between 0 and 1"));
  EXPECT_THAT(message("flip:nan"), testing::HasSubstr("between"));
}

TEST(Schemes, InfosFollowTheList) {
  const auto infos = scheme_infos();
  ASSERT_EQ(infos.size(), std::tuple_size_v<Schemes>);
  EXPECT_EQ(infos[static_cast<std::size_t>(scheme_index<Flip>)].name, "flip");
  EXPECT_FALSE(infos[static_cast<std::size_t>(scheme_index<Pic>)].first);
  EXPECT_EQ(infos[static_cast<std::size_t>(scheme_index<Rpic>)].first->path, "transfer.affine");
  for (const SchemeInfo& i : infos) EXPECT_FALSE(i.summary.empty());
}

} // namespace
} // namespace flipbook
