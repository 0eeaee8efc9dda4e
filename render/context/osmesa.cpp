// SPDX-License-Identifier: MIT
// Mesa's off-screen library: no server, no device file, no configuration. Mesa 25.1 removed it.
#include "render/context/backends.h"
#include "sim/frame/errors.h"

// osmesa.h includes gl.h unless this is defined; glcorearb.h has the same types for the core profile.
#define __gl_h_
#include <GL/glcorearb.h>
#ifndef GLAPIENTRY
#define GLAPIENTRY APIENTRY
#endif
#include <GL/osmesa.h>

#include <array>

namespace flipbook::render {
namespace {

class OsMesa final : public Context {
public:
  OsMesa() {
    // A forward-compatible context is refused, a plain core one is not.
    static constexpr std::array<int, 13> wanted{OSMESA_FORMAT,
                                                OSMESA_RGBA,
                                                OSMESA_DEPTH_BITS,
                                                0,
                                                OSMESA_PROFILE,
                                                OSMESA_CORE_PROFILE,
                                                OSMESA_CONTEXT_MAJOR_VERSION,
                                                3,
                                                OSMESA_CONTEXT_MINOR_VERSION,
                                                3,
                                                0,
                                                0,
                                                0};
    context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (context_ == nullptr) throw MachineError("OSMesaCreateContextAttribs refused an OpenGL 3.3 core context");
    try {
      make_current();
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }
  ~OsMesa() override { OSMesaDestroyContext(context_); }
  OsMesa(const OsMesa&) = delete;
  OsMesa& operator=(const OsMesa&) = delete;

  void make_current() override {
    if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE)
      throw MachineError("OSMesaMakeCurrent failed");
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  [[nodiscard]] void* load(const char* symbol) const override {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(symbol));
  }
  [[nodiscard]] std::string_view name() const override { return "osmesa"; }

private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> buffer_{}; ///< required, never drawn to: pictures are made in framebuffer objects
};

} // namespace

std::unique_ptr<Context> create_osmesa() {
  return std::make_unique<OsMesa>();
}

} // namespace flipbook::render
