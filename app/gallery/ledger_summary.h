// SPDX-License-Identifier: MIT
// What a ledger's CSV file (app/session/ledger_file.h) says of a whole run, a row for each variant:
//
//   energy kept                  E(end) / E(start), E = kinetic + potential + elastic
//   transfers: energy            sum of what they changed of E, over E(start)
//   transfers: momentum          |sum of what they changed of p| / (m v), v = sqrt(2 E / m) with the greatest E
//   transfers: angular momentum  |sum of what they changed of L| / max |L|
//
// Transfers are P2G, G2P and the stage between them that extrapolates over faces which touch no liquid ("free faces"):
// FLIP gives back what that took, so that one without the other says nothing. Where it acted a note says so. Without a
// free surface the last two are 0 to rounding for schemes that conserve.
#pragma once

#include "app/gallery/piece.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace flipbook::app::gallery {

/// Empty for a text that is no ledger or has no rows.
[[nodiscard]] Table summarise_ledger(std::istream& csv);

/// "43.2 %", "-0.012 %"; below what single precision leaves of a sum, "rounding (3e-08)"; "-" for what is not finite.
[[nodiscard]] std::string share(double x);

/// The fields of one line of CSV, as RFC 4180 has them; lines do not break within fields.
[[nodiscard]] std::vector<std::string> csv_fields(const std::string& line);

} // namespace flipbook::app::gallery
