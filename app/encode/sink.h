// SPDX-License-Identifier: MIT
// Where finished pictures go. A sink is made before the first step is simulated, so that what cannot work is refused
// early, and its files get their final names only in commit(): a run that fails leaves nothing
// behind and nothing replaced.
#pragma once

#include "app/encode/provenance.h"
#include "render/image.h"

#include <cstdint>
#include <filesystem>

namespace flipbook::app {

/// One picture with what it shows.
struct Picture {
  render::Image image;
  Provenance provenance;
};

class Sink {
public:
  virtual ~Sink() = default; ///< without commit(): removes what was written
  virtual void write(const Picture& picture) = 0;
  virtual void finish() = 0;                                    ///< the last picture was written: makes the files whole
  virtual void commit() = 0;                                    ///< gives them their names, replacing what was there
  [[nodiscard]] virtual std::filesystem::path path() const = 0; ///< of the file or folder, as the user named it
  [[nodiscard]] virtual bool
  computes() const = 0; ///< does write() compute here (and need a permit), or only hand over?
};

} // namespace flipbook::app
