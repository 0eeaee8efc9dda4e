// SPDX-License-Identifier: MIT
// The list of back ends, in the order in which they are tried.
#include "render/context/backends.h"
#include "sim/frame/errors.h"

#include <array>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FLIPBOOK_LEAK_CHECK
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define FLIPBOOK_LEAK_CHECK
#endif
#ifdef FLIPBOOK_LEAK_CHECK
/// Mesa keeps a few tables until the process ends; a leak of our own has no Mesa frame in its stack.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:_dri.so\n";
}
#endif

namespace flipbook::render {

#ifndef FLIPBOOK_OSMESA
std::unique_ptr<Context> create_osmesa() {
  throw MachineError("this build was configured without OSMesa");
}
#endif
#ifndef FLIPBOOK_EGL
std::unique_ptr<Context> create_egl() {
  throw MachineError("this build was configured without EGL");
}
#endif

namespace {

struct Entry {
  Backend backend;
  std::string_view name;
  std::unique_ptr<Context> (*create)();
};

constexpr std::array<Entry, 2> entries{{
    {Backend::osmesa, "osmesa", create_osmesa},
    {Backend::egl, "egl", create_egl},
}};

} // namespace

std::unique_ptr<Context> Context::create(Backend backend) {
  std::string reasons;
  for (const Entry& e : entries) {
    if (backend != Backend::automatic && backend != e.backend) continue;
    try {
      return e.create();
    } catch (const MachineError& error) {
      reasons += std::string(reasons.empty() ? "" : "; ") + std::string(e.name) + " (" + error.what() + ")";
    }
  }
  throw MachineError("no OpenGL context without a display; tried " + reasons);
}

void set_draw_threads(int threads) {
  // The software rasteriser reads it when the first context of the process is made; 0 draws in the calling thread.
  setenv("LP_NUM_THREADS", std::to_string(threads <= 1 ? 0 : threads).c_str(), 0);
}

} // namespace flipbook::render
