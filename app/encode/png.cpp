// SPDX-License-Identifier: MIT
#include "app/encode/png.h"

#include "app/encode/png_chunks.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <libdeflate.h>
#include <memory>
#include <new>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

/// The rows as PNG wants them compressed: a byte that says "no filter", then RGB.
std::unique_ptr<std::uint8_t[]> scanlines(const render::Image& image, std::size_t bytes) {
  auto rows = std::make_unique_for_overwrite<std::uint8_t[]>(bytes + 1); // for the last alpha
  const auto width = static_cast<std::size_t>(image.width);
  const std::uint8_t* from = image.rgba.data();
  std::uint8_t* to = rows.get();
  for (int j = 0; j < image.height; ++j) {
    *to++ = 0;
    for (std::size_t i = 0; i < width; ++i) std::memcpy(to + 3 * i, from + 4 * i, 4); // the next one covers the alpha
    to += 3 * width;
    from += 4 * width;
  }
  return rows;
}

/// Gives its files their names on commit.
class PngFiles : public Sink {
public:
  PngFiles(const fs::path& folder, PictureName name, fs::path shown)
      : staging_(folder), name_(std::move(name)), shown_(std::move(shown)) {}

  void write(const Picture& p) override {
    staging_.write(name_(p.provenance), encode_png(p.image, text_entries(p.provenance)));
  }
  void finish() override {}
  void commit() override { staging_.commit(); }
  [[nodiscard]] fs::path path() const override { return shown_; }
  [[nodiscard]] bool computes() const override { return true; }

private:
  Staging staging_;
  PictureName name_;
  fs::path shown_;
};

std::string frame_name(const Provenance& p) {
  char text[32];
  std::snprintf(text, sizeof text, "frame_%06llu.png", static_cast<unsigned long long>(p.frame));
  return text;
}

bool is_ours(const fs::path& file) {
  try {
    const TextEntries text = read_png_text(file);
    return std::any_of(text.begin(), text.end(), [](const auto& entry) { return entry.first == "flipbook:frame"; });
  } catch (const UserError&) {
    return false;
  }
}

/// The frames of one run. Those of an earlier, longer run in the same folder would be taken for its end: they go.
class PngSequence final : public PngFiles {
public:
  explicit PngSequence(const fs::path& folder) : PngFiles(folder, frame_name, folder) {}

  void write(const Picture& p) override {
    PngFiles::write(p);
    next_.frame = p.provenance.frame + 1;
  }
  void commit() override {
    PngFiles::commit();
    for (; is_ours(path() / frame_name(next_)); ++next_.frame) fs::remove(path() / frame_name(next_));
  }

private:
  Provenance next_;
};

} // namespace

std::vector<std::uint8_t> encode_png(const render::Image& image, const TextEntries& text, PngEffort effort,
                                     double density) {
  // Measured on frames of 1280x720: without a filter at level 1, 10 to 21 ms; at level 6, 21 to 31 ms for 5 % less;
  // with a filter chosen for each row, 50 to 68 ms and no smaller.
  const int level = effort == PngEffort::fast ? 1 : 12;
  const std::size_t bytes = static_cast<std::size_t>(image.height) * (1 + 3 * static_cast<std::size_t>(image.width));
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  const auto rows = scanlines(image, bytes);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), bytes);
  const auto pixels = std::make_unique_for_overwrite<std::uint8_t[]>(bound);
  const std::size_t size = libdeflate_zlib_compress(compressor.get(), rows.get(), bytes, pixels.get(), bound);
  return png_file(image.width, image.height, {pixels.get(), size}, text, density);
}

std::unique_ptr<Sink> png_sequence(const fs::path& folder) {
  return std::make_unique<PngSequence>(folder);
}

std::unique_ptr<Sink> png_files(const fs::path& folder, PictureName name, const fs::path& shown) {
  return std::make_unique<PngFiles>(folder, std::move(name), shown);
}

} // namespace flipbook::app
