// SPDX-License-Identifier: MIT
// An OpenGL 3.3 core context without a window. Contexts are tried in order; every reason for a failure is kept.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace flipbook::render {

enum class Backend { automatic, osmesa, egl };

class Context {
public:
  virtual ~Context() = default;
  virtual void make_current() = 0;
  virtual void release() = 0; ///< before another thread takes it
  [[nodiscard]] virtual void* load(const char* symbol) const = 0;
  [[nodiscard]] virtual std::string_view name() const = 0; ///< "osmesa" or "egl"

  /// Makes a context and makes it current. Throws MachineError that names each back end tried and why it failed (also
  /// those this build was configured without).
  [[nodiscard]] static std::unique_ptr<Context> create(Backend backend);
};

/// How many threads the software rasteriser draws with (1: the calling thread, no other). Call it before the first
/// context of the process is made, and before other threads run (it sets an environment variable, LP_NUM_THREADS,
/// unless the user has set it).
void set_draw_threads(int threads);

} // namespace flipbook::render
