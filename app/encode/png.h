// SPDX-License-Identifier: MIT
// PNG pictures with text inside. Pixels go through libdeflate without a filter; the text stands before them in iTXt
// chunks (UTF-8, uncompressed, so that any tool shows it).
#pragma once

#include "app/encode/provenance.h"
#include "app/encode/sink.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace flipbook::app {

/// A picture that is made once may take its time to become small.
enum class PngEffort { fast, small };

/// The bytes of a PNG file (RGB: a frame is opaque). Deterministic. `density`: pixels of an inch that it is meant for;
/// 0: it does not say.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const render::Image& image, const TextEntries& text,
                                                   PngEffort effort = PngEffort::fast, double density = 0);

/// The text chunks of a PNG file (tEXt and uncompressed iTXt). Throws UserError for what is not a PNG or is damaged.
[[nodiscard]] TextEntries read_png_text(const std::filesystem::path& file);

/// The name of a picture's file inside the folder.
using PictureName = std::function<std::string(const Provenance&)>;

/// Writes each picture as one file: "frame_000123.png". On commit the frames of an earlier, longer run are removed.
[[nodiscard]] std::unique_ptr<Sink> png_sequence(const std::filesystem::path& folder);
/// The same with names of the caller's choice; `shown` is what path() returns.
[[nodiscard]] std::unique_ptr<Sink> png_files(const std::filesystem::path& folder, PictureName name,
                                              const std::filesystem::path& shown);

} // namespace flipbook::app
