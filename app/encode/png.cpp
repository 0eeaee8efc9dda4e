// SPDX-License-Identifier: MIT
#include "app/encode/png.h"

#include "app/encode/png_chunks.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <libdeflate.h>
#include <mutex>
#include <new>

namespace {

unsigned char* deflate_whole(unsigned char* data, int size, int* out_size, int level) {
  libdeflate_compressor* c = libdeflate_alloc_compressor(level);
  if (!c) return nullptr;
  const auto n = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(c, n);
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (out) *out_size = static_cast<int>(libdeflate_zlib_compress(c, data, n, out, bound));
  libdeflate_free_compressor(c);
  return out;
}

} // namespace

#define STBIW_ZLIB_COMPRESS deflate_whole
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

std::vector<std::uint8_t> drop_alpha(const render::Image& image) {
  const std::size_t pixels = image.rgba.size() / 4;
  std::vector<std::uint8_t> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) rgb[3 * i + c] = image.rgba[4 * i + c];
  return rgb;
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

std::vector<std::uint8_t> encode_png(const render::Image& image, const TextEntries& text) {
  // stb keeps its settings in globals, and several threads encode. Measured on frames of 1280x720: without a filter at
  // level 1, 10 to 21 ms; at level 6, 21 to 31 ms for 5 % less; with stb's own choice of a filter for each row, 50 to
  // 68 ms and no smaller.
  static std::once_flag once;
  std::call_once(once, [] {
    stbi_write_force_png_filter = 0;
    stbi_write_png_compression_level = 1;
  });
  const std::vector<std::uint8_t> rgb = drop_alpha(image);
  int size = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> png(
      stbi_write_png_to_mem(rgb.data(), 3 * image.width, image.width, image.height, 3, &size), &std::free);
  if (!png) throw std::bad_alloc();
  return insert_text({png.get(), static_cast<std::size_t>(size)}, text);
}

std::unique_ptr<Sink> png_sequence(const fs::path& folder) {
  return std::make_unique<PngSequence>(folder);
}

std::unique_ptr<Sink> png_files(const fs::path& folder, PictureName name, const fs::path& shown) {
  return std::make_unique<PngFiles>(folder, std::move(name), shown);
}

} // namespace flipbook::app
