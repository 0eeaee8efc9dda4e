// SPDX-License-Identifier: MIT
// Lines of CSV, field by field: commas, semicolons or tabs; fields may be in quotes.
#pragma once

#include "sim/files/byte_source.h"

#include <string>
#include <string_view>

namespace flipbook {

/// What parts the fields of a header: what occurs most outside quotes; a comma where nothing does.
[[nodiscard]] char csv_separator(std::string_view header);

/// The fields of one line.
class CsvFields {
public:
  CsvFields(std::string_view line, char separator, const ByteSource& file)
      : p_(line.data()), end_(p_ + line.size()), separator_(separator), file_(file) {}

  [[nodiscard]] bool more() const { return !done_; }
  /// The text of the next field, without its quotes; two quotes in it stay two.
  std::string_view next();

private:
  std::string_view plain();
  std::string_view quoted();
  /// The field [first, last): moves behind the separator.
  std::string_view ends(const char* first, const char* last);

  const char *p_, *end_;
  char separator_;
  const ByteSource& file_;
  bool done_ = false;
};

/// The number that a field is; a UserError names the column otherwise.
[[nodiscard]] double csv_number(std::string_view field, const std::string& column, const ByteSource& file);

} // namespace flipbook
