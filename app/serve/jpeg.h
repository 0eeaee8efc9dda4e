// SPDX-License-Identifier: MIT
// Pictures for the way to a browser: JPEG by libjpeg-turbo, which every browser decodes in hardware speed and which
// takes 3 ms for 1280x720, where PNG takes 20 and a video encoder adds frames of delay.
#pragma once

#include "app/serve/flow.h"
#include "render/image.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace flipbook::app::serve {

struct Jpeg {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

class JpegEncoder {
public:
  JpegEncoder(); ///< throws MachineError
  ~JpegEncoder();
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;

  /// Smaller pictures are means of the pixels that they stand for.
  [[nodiscard]] Jpeg encode(const render::Image& image, const PictureGrade& grade);

private:
  void* compressor_;
  render::Image smaller_;
};

/// Each pixel is the mean of those that it covers; sizes are rounded down, to at least one pixel.
void shrink(const render::Image& from, int numerator, int denominator, render::Image& to);

} // namespace flipbook::app::serve
