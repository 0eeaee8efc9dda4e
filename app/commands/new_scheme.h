// SPDX-License-Identifier: MIT
// flipbook new scheme NAME: a header with a transfer in plain scalar code, which works as it is, and its registration.
#pragma once

#include <string>

namespace flipbook::app {

/// Within a source tree (the current folder or one above it has sim/transfer/schemes.h) and without an `output` writes
/// sim/transfer/NAME.h and enters it into the list of schemes; else writes the header alone and says what to enter.
/// Prints the path of the header. Throws UserError for a name that is taken or no identifier, and where something is
/// there already.
void new_scheme(const std::string& name, const std::string& output);

} // namespace flipbook::app
