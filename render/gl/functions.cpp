// SPDX-License-Identifier: MIT
#include "render/gl/functions.h"

#include "render/context/context.h"
#include "sim/frame/errors.h"

namespace flipbook::render::gl {

Functions::Functions(const Context& context) {
  std::string missing;
#define FLIPBOOK_GL_LOAD(TYPE, NAME)                                                                                   \
  NAME = reinterpret_cast<PFNGL##TYPE##PROC>(context.load("gl" #NAME));                                                \
  if (NAME == nullptr) missing += " gl" #NAME;
  FLIPBOOK_GL_FUNCTIONS(FLIPBOOK_GL_LOAD)
#undef FLIPBOOK_GL_LOAD
  if (!missing.empty()) throw MachineError("the " + std::string(context.name()) + " context lacks" + missing);
}

} // namespace flipbook::render::gl
