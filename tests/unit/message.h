// SPDX-License-Identifier: MIT
#pragma once

#include "sim/frame/errors.h"

#include <string>

namespace flipbook {

/// What the UserError says that `body` throws; "no error" if it throws none.
template <class Body> std::string message_of(Body&& body) {
  try {
    body();
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

} // namespace flipbook
