// SPDX-License-Identifier: MIT
// EGL without a surface: Mesa's surfaceless platform, then each device that EGL_EXT_platform_device lists (the way to a
// vendor's driver on a machine without a display).
#include "render/context/backends.h"
#include "sim/frame/errors.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <vector>

namespace flipbook::render {
namespace {

std::string error_text() {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
  return std::string("error ") + text.data();
}

bool has_extension(EGLDisplay display, const char* name) {
  const char* all = eglQueryString(display, EGL_EXTENSIONS);
  std::istringstream words(all == nullptr ? "" : all);
  return std::find(std::istream_iterator<std::string>(words), {}, name) != std::istream_iterator<std::string>();
}

template <class Function> Function function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

struct Candidate {
  std::string what;
  EGLDisplay display;
};

/// Displays that need no window system, in the order in which they are tried.
std::vector<Candidate> candidates() {
  std::vector<Candidate> found;
  const auto get_display = function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (get_display == nullptr) throw MachineError("eglGetPlatformDisplayEXT is missing");
  if (has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    found.push_back({"surfaceless", get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
  const auto query_devices = function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (has_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") && query_devices != nullptr) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint n = 0;
    if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &n) != EGL_TRUE) n = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
      found.push_back({"device " + std::to_string(i), get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
  }
  if (found.empty()) throw MachineError("EGL offers neither a surfaceless platform nor devices");
  return found;
}

class Egl final : public Context {
public:
  explicit Egl(EGLDisplay display) : display_(display) {
    if (display == EGL_NO_DISPLAY) throw MachineError("no display");
    // Displays belong to the process and initialising one again does nothing, so none is ever terminated.
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) throw MachineError("eglInitialize: " + error_text());
    for (const char* needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"})
      if (!has_extension(display, needed)) throw MachineError(std::string("no ") + needed);
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) throw MachineError("no desktop OpenGL");
    static constexpr std::array<EGLint, 7> wanted{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context_ == EGL_NO_CONTEXT) throw MachineError("eglCreateContext (OpenGL 3.3 core): " + error_text());
    try {
      make_current();
    } catch (...) {
      eglDestroyContext(display_, context_);
      throw;
    }
  }
  ~Egl() override {
    if (eglGetCurrentContext() == context_) release();
    eglDestroyContext(display_, context_);
  }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

  void make_current() override {
    eglBindAPI(EGL_OPENGL_API); // per thread
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
      throw MachineError("eglMakeCurrent: " + error_text());
  }
  void release() override {
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  [[nodiscard]] void* load(const char* symbol) const override {
    return reinterpret_cast<void*>(eglGetProcAddress(symbol));
  }
  [[nodiscard]] std::string_view name() const override { return "egl"; }

private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

std::unique_ptr<Context> create_egl() {
  std::string reasons;
  for (const Candidate& c : candidates()) {
    try {
      return std::make_unique<Egl>(c.display);
    } catch (const MachineError& e) {
      reasons += (reasons.empty() ? "" : "; ") + c.what + ": " + e.what();
    }
  }
  throw MachineError(reasons);
}

} // namespace flipbook::render
