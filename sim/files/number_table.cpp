// SPDX-License-Identifier: MIT
#include "sim/files/number_table.h"

#include "sim/files/csv_fields.h"

#include <cmath>

namespace flipbook {

NumberTable read_number_table(const std::string& path) {
  ByteSource file(path);
  std::string_view line;
  if (!file.content_line(line)) file.refuse("the file is empty");
  if (const std::string_view text = trimmed(line); std::string_view("+-.0123456789").find(text.front()) != text.npos)
    file.refuse("the first line must name the columns, for example t,x, not " + shown(text));
  const char separator = csv_separator(line);
  NumberTable table;
  for (CsvFields header(line, separator, file); header.more();) {
    if (table.names.size() == NumberTable::most_columns) file.refuse("more than 64 columns");
    table.names.emplace_back(trimmed(header.next()));
  }
  table.columns.resize(table.names.size());
  while (file.content_line(line)) {
    if (table.columns.front().size() == NumberTable::most_rows) file.refuse("more than 10000 rows");
    std::size_t c = 0;
    for (CsvFields fields(line, separator, file); fields.more(); ++c) {
      const std::string_view field = fields.next();
      if (c >= table.names.size()) continue; // counted, and refused below
      const double value = csv_number(field, table.names[c], file);
      if (!std::isfinite(value))
        file.refuse("column " + shown(table.names[c]) + ": " + shown(field) + " is not finite");
      table.columns[c].push_back(value);
    }
    if (c != table.names.size())
      file.refuse(std::to_string(c) + (c == 1 ? " column" : " columns") + " in a row, and " +
                  std::to_string(table.names.size()) + " in the header");
  }
  if (table.columns.front().empty()) file.refuse("there is no row of numbers");
  return table;
}

} // namespace flipbook
