// SPDX-License-Identifier: MIT
#include "sim/files/numbers.h"
#include "sim/files/particle_formats.h"
#include "sim/files/row_store.h"

#include <algorithm>
#include <cstring>

namespace flipbook {
namespace {

/// One line of a CSV file, field by field.
class Fields {
public:
  Fields(std::string_view line, char separator, const ByteSource& file)
      : p_(line.data()), end_(p_ + line.size()), separator_(separator), file_(file) {}

  [[nodiscard]] bool more() const { return !done_; }
  /// The text of the next field, without its quotes; two quotes in it stay two.
  std::string_view next() {
    while (p_ != end_ && *p_ == ' ') ++p_;
    return p_ != end_ && *p_ == '"' ? quoted() : plain();
  }

private:
  std::string_view plain() {
    const void* stop = p_ == end_ ? nullptr : std::memchr(p_, separator_, static_cast<std::size_t>(end_ - p_));
    return ends(p_, stop ? static_cast<const char*>(stop) : end_);
  }

  std::string_view quoted() {
    const char* first = ++p_;
    const auto quote = [&] { return std::find(p_, end_, '"'); };
    for (p_ = quote(); p_ != end_ && p_ + 1 != end_ && p_[1] == '"'; p_ = quote()) p_ += 2;
    if (p_ == end_) file_.refuse("a quote is not closed in this line");
    const char* last = p_++;
    while (p_ != end_ && *p_ == ' ') ++p_;
    if (p_ != end_ && *p_ != separator_) file_.refuse("text after a closing quote");
    (void)ends(p_, p_);
    return {first, static_cast<std::size_t>(last - first)};
  }

  /// The field [first, last): moves behind the separator.
  std::string_view ends(const char* first, const char* last) {
    done_ = last == end_;
    p_ = done_ ? end_ : last + 1;
    return {first, static_cast<std::size_t>(last - first)};
  }

  const char *p_, *end_;
  char separator_;
  const ByteSource& file_;
  bool done_ = false;
};

/// What occurs most outside quotes; a comma where nothing does.
char separator_of(std::string_view header) {
  std::array<std::size_t, 3> count{};
  constexpr std::string_view known = ",;\t";
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (const std::size_t i = known.find(c); !quoted && i != std::string_view::npos) ++count[i];
  }
  return known[static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin())];
}

double number(std::string_view field, const std::string& name, const ByteSource& file) {
  const std::string_view text = trimmed(field);
  const char *p = text.data(), *end = p + text.size();
  double value = 0;
  if (text.empty() || !read_number(p, end, value) || p != end)
    file.refuse("column " + shown(name) + ": expected a number, not " + shown(text));
  return value;
}

} // namespace

ParticleRows read_csv(ByteSource& file, bool ids) {
  std::string_view line;
  if (!file.content_line(line)) file.refuse("the file is empty");
  if (const std::string_view text = trimmed(line); std::string_view("+-.0123456789").find(text.front()) != text.npos)
    file.refuse("the first line must name the columns, for example x,y,z,vx,vy,vz, not " + shown(text));
  const char separator = separator_of(line);
  std::vector<std::string> names;
  for (Fields header(line, separator, file); header.more();) names.emplace_back(trimmed(header.next()));
  const RowColumns columns = find_columns(names, true, ids, "the header", file);
  const std::vector<int> slot = columns.slots(names.size());

  RowStore rows(file);
  if (columns.ids()) rows.keep_ids();
  Row row{};
  while (file.content_line(line)) {
    if (rows.size() == 0) rows.reserve(file.left() / (line.size() + 1) + 1); // rows are much alike in length
    std::size_t c = 0;
    for (Fields fields(line, separator, file); fields.more(); ++c) {
      const std::string_view field = fields.next();
      if (c < slot.size() && slot[c] >= 0) row[static_cast<std::size_t>(slot[c])] = number(field, names[c], file);
    }
    if (c != names.size())
      file.refuse(std::to_string(c) + (c == 1 ? " column" : " columns") + " in a row, and " +
                  std::to_string(names.size()) + " in the header");
    rows.add(row);
  }
  return rows.take(columns.planar());
}

} // namespace flipbook
