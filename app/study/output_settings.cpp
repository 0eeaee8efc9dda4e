// SPDX-License-Identifier: MIT
#include "app/study/output_settings.h"

#include <algorithm>
#include <filesystem>

namespace flipbook::app {

void OutputSettings::describe(ParameterVisitor& v) {
  v.group("output", [&] {
    v.real({.name = "fps", .help = "Frames in one second of video", .unit = "1/s", .min = 1, .max = 240}, fps);
    v.integers({.name = "size", .help = "Width and height of a picture in pixels", .min = 64, .max = 7680}, size);
    v.real(
        {.name = "duration", .help = "Simulated time; 0: what the scene suggests", .unit = "s", .min = 0, .max = 1e6},
        duration);
    v.integer({.name = "frames", .help = "Number of frames; 0: as many as the duration needs", .min = 0, .max = 1e6},
              frames);
    v.integer({.name = "crf",
               .help = "Quality of a video: 0 best (.mp4: without loss), 18 good, 51 worst",
               .min = 0,
               .max = 51},
              crf);
    v.integer(
        {.name = "animation_width", .help = "Greatest width of an animation (.gif, .webp)", .min = 16, .max = 7680},
        animation_width);
    v.real({.name = "animation_fps",
            .help = "Most frames in a second of an animation (.gif, .webp); 100/n suits GIF",
            .unit = "1/s",
            .min = 1,
            .max = 100},
           animation_fps);
    v.real({.name = "poster",
            .help = "Simulated time whose picture is written beside a video as NAME.poster.png; negative: none",
            .unit = "s",
            .min = -1,
            .max = 1e6},
           poster);
    v.flag({.name = "subtitles", .help = "Write what the keys do beside a video as NAME.vtt"}, subtitles);
    v.choice({.name = "particle_format", .help = "Format of the files of particles (--particles)"}, particle_format,
             particle_format_options());
    v.text({.name = "ledger", .help = "CSV file for the ledger of a video (render, compare); empty: none"}, ledger);
  });
}

Refusal check_output(const OutputSettings& output) {
  if (output.ledger.empty()) return {};
  const std::filesystem::path file(output.ledger);
  const bool leaves = std::any_of(file.begin(), file.end(), [](const auto& part) { return part == ".."; });
  if (file.is_absolute() || leaves || file.extension() != ".csv")
    return {"output.ledger: \"" + output.ledger +
                "\": it is a name that ends in .csv, below the folder where the program runs; --ledger takes any",
            ""};
  return {};
}

} // namespace flipbook::app
