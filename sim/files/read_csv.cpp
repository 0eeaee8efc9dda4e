// SPDX-License-Identifier: MIT
#include "sim/files/csv_fields.h"
#include "sim/files/particle_formats.h"
#include "sim/files/row_store.h"

namespace flipbook {
ParticleRows read_csv(ByteSource& file, bool ids) {
  std::string_view line;
  if (!file.content_line(line)) file.refuse("the file is empty");
  if (const std::string_view text = trimmed(line); std::string_view("+-.0123456789").find(text.front()) != text.npos)
    file.refuse("the first line must name the columns, for example x,y,z,vx,vy,vz, not " + shown(text));
  const char separator = csv_separator(line);
  std::vector<std::string> names;
  for (CsvFields header(line, separator, file); header.more();) names.emplace_back(trimmed(header.next()));
  const RowColumns columns = find_columns(names, true, ids, "the header", file);
  const std::vector<int> slot = columns.slots(names.size());

  RowStore rows(file);
  if (columns.ids()) rows.keep_ids();
  Row row{};
  while (file.content_line(line)) {
    if (rows.size() == 0) rows.reserve(file.left() / (line.size() + 1) + 1); // rows are much alike in length
    std::size_t c = 0;
    for (CsvFields fields(line, separator, file); fields.more(); ++c) {
      const std::string_view field = fields.next();
      if (c < slot.size() && slot[c] >= 0) row[static_cast<std::size_t>(slot[c])] = csv_number(field, names[c], file);
    }
    if (c != names.size())
      file.refuse(std::to_string(c) + (c == 1 ? " column" : " columns") + " in a row, and " +
                  std::to_string(names.size()) + " in the header");
    rows.add(row);
  }
  return rows.take(columns.planar());
}

} // namespace flipbook
