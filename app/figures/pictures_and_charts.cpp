// SPDX-License-Identifier: MIT
// A filmstrip above charts: what a flow looks like, and what it measures.
#include "app/figures/curves.h"
#include "app/figures/kinds.h"
#include "app/figures/sketch.h"

namespace flipbook::app {

namespace {

class Body final : public FigureBody {
public:
  Body(std::unique_ptr<FigureBody> strip, std::unique_ptr<FigureBody> charts)
      : strip_(std::move(strip)), charts_(std::move(charts)) {}

  double draw(const FigureArea& area) const override {
    const double y = strip_->draw(area) + 12;
    return charts_->draw({area.pen, area.x, y, area.width, area.pictures});
  }
  [[nodiscard]] std::vector<FigureTable> tables() const override {
    std::vector<FigureTable> all = charts_->tables();
    for (FigureTable& t : strip_->tables()) {
      t.part = "pictures";
      all.push_back(std::move(t));
    }
    return all;
  }

private:
  std::unique_ptr<FigureBody> strip_, charts_;
};

class Kind final : public FigureKind {
public:
  void describe(ParameterVisitor& v) override {
    v.choice({.name = "charts", .help = "What stands below the pictures"}, charts_, options);
    v.group("strip", [&] { strip_->describe(v); });
    v.group("case", [&] { case_->describe(v); });
    v.group("curves", [&] { curves_->describe(v); });
  }
  [[nodiscard]] std::unique_ptr<FigureBody> compute(const Lab& lab) const override {
    auto strip = strip_->compute(lab);
    return std::make_unique<Body>(std::move(strip), (charts_ == 0 ? case_ : curves_)->compute(lab));
  }

private:
  static constexpr Option options[] = {{"case", "the panels of a validation case"}, {"curves", "curves over time"}};
  int charts_ = 0;
  std::unique_ptr<FigureKind> strip_ = filmstrip_figure(), case_ = validation_figure(), curves_ = curves_figure();
};

} // namespace

std::unique_ptr<FigureKind> pictures_and_charts_figure() {
  return std::make_unique<Kind>();
}

} // namespace flipbook::app
