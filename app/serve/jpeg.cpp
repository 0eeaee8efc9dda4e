// SPDX-License-Identifier: MIT
#include "app/serve/jpeg.h"

#include "sim/frame/errors.h"

#include <algorithm>
#include <string>
#include <turbojpeg.h>

namespace flipbook::app::serve {

JpegEncoder::JpegEncoder() : compressor_(tjInitCompress()) {
  if (!compressor_) throw MachineError("libjpeg-turbo does not start");
}

JpegEncoder::~JpegEncoder() {
  tjDestroy(compressor_);
}

Jpeg JpegEncoder::encode(const render::Image& image, const PictureGrade& grade) {
  const render::Image* from = &image;
  if (grade.numerator != grade.denominator) {
    shrink(image, grade.numerator, grade.denominator, smaller_);
    from = &smaller_;
  }
  const int chroma = grade.quality >= 85 ? TJSAMP_444 : TJSAMP_420; // coloured text blurs in 4:2:0
  Jpeg jpeg{from->width, from->height, {}};
  jpeg.bytes.resize(tjBufSize(from->width, from->height, chroma));
  unsigned char* to = jpeg.bytes.data();
  unsigned long size = jpeg.bytes.size();
  if (tjCompress2(compressor_, from->rgba.data(), from->width, 0, from->height, TJPF_RGBX, &to, &size, chroma,
                  grade.quality, TJFLAG_FASTDCT | TJFLAG_NOREALLOC) != 0)
    throw MachineError(std::string("cannot code a picture: ") + tjGetErrorStr2(compressor_));
  jpeg.bytes.resize(size);
  return jpeg;
}

void shrink(const render::Image& from, int numerator, int denominator, render::Image& to) {
  to.width = std::max(1, from.width * numerator / denominator);
  to.height = std::max(1, from.height * numerator / denominator);
  to.rgba.resize(static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height) * 4);
  // Pixel i covers from i s to (i + 1) s: at least one pixel of the other, which may be one that its neighbour has too.
  const auto first = [](int i, int n, int m) { return static_cast<int>(static_cast<std::int64_t>(i) * m / n); };
  const auto last = [](int i, int n, int m) {
    return static_cast<int>((static_cast<std::int64_t>(i + 1) * m + n - 1) / n);
  };
  std::uint8_t* out = to.rgba.data();
  for (int j = 0; j < to.height; ++j)
    for (int i = 0; i < to.width; ++i, out += 4) {
      unsigned sum[3] = {0, 0, 0}, count = 0;
      for (int y = first(j, to.height, from.height); y < last(j, to.height, from.height); ++y)
        for (int x = first(i, to.width, from.width); x < last(i, to.width, from.width); ++x, ++count) {
          const std::size_t at =
              4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(from.width) + static_cast<std::size_t>(x));
          for (std::size_t c = 0; c < 3; ++c) sum[c] += from.rgba[at + c];
        }
      for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
      out[3] = 255;
    }
}

} // namespace flipbook::app::serve
