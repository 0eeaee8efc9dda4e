// SPDX-License-Identifier: MIT
#include "app/encode/beside.h"

#include "app/encode/png.h"
#include "app/encode/staging.h"

#include <cmath>
#include <optional>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

class PosterFile final : public Sink {
public:
  PosterFile(const fs::path& file, double time) : path_(file), staging_(file.parent_path()), time_(time) {}

  void write(const Picture& p) override {
    const auto away = [this](const Picture& q) { return std::abs(q.provenance.time - time_); };
    if (!nearest_ || away(p) < away(*nearest_)) nearest_ = p;
  }
  void finish() override {
    if (nearest_)
      staging_.write(path_.filename().string(),
                     encode_png(nearest_->image, text_entries(nearest_->provenance), PngEffort::small));
    nearest_.reset();
  }
  void commit() override { staging_.commit(); }
  [[nodiscard]] fs::path path() const override { return path_; }
  [[nodiscard]] bool computes() const override { return false; } // but for one picture at the end

private:
  fs::path path_;
  Staging staging_;
  double time_;
  std::optional<Picture> nearest_;
};

class TextFile final : public Sink {
public:
  TextFile(const fs::path& file, const std::string& text) : path_(file), staging_(file.parent_path()) {
    staging_.write(path_.filename().string(), text);
  }
  void write(const Picture& /*p*/) override {}
  void finish() override {}
  void commit() override { staging_.commit(); }
  [[nodiscard]] fs::path path() const override { return path_; }
  [[nodiscard]] bool computes() const override { return false; }

private:
  fs::path path_;
  Staging staging_;
};

} // namespace

fs::path beside(const fs::path& video, const std::string& ending) {
  fs::path file = video;
  return file.replace_extension() += ending;
}

std::unique_ptr<Sink> poster_file(const fs::path& file, double time) {
  return std::make_unique<PosterFile>(file, time);
}

std::unique_ptr<Sink> text_file(const fs::path& file, const std::string& text) {
  return std::make_unique<TextFile>(file, text);
}

} // namespace flipbook::app
