// SPDX-License-Identifier: MIT
#include "render/views/ledger_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace flipbook::render {
namespace {

using gui::Align;
using gui::Type;
using Claim = LedgerTable::Claim;

// In points, with small type.
constexpr float symbol_height = 15, index_drop = 3, unit_height = 13, row_height = 14, rule = 5, after = 6,
                line_height = 14;
constexpr float mark_room = 13, column_gap = 8, label_gap = 4;

/// A type and the measures that go with it.
struct Face {
  const gui::Fonts& fonts;
  Type type;
  [[nodiscard]] float width(std::string_view text) const { return fonts.width(type, text); }
  /// Pixels, in whole ones.
  [[nodiscard]] float points(float p) const { return std::round(p * fonts.size(type) / 11); }
};

struct Widths {
  float label = 0;
  std::vector<float> columns;
  [[nodiscard]] float sum() const { return std::accumulate(columns.begin(), columns.end(), label); }
};

/// Independent of the numbers.
Widths widths_of(const Face& face, const LedgerText& text) {
  Widths w{face.width("since the start"), {}};
  for (const std::string& row : text.rows) w.label = std::max(w.label, face.width(row));
  w.label = std::ceil(w.label + face.points(label_gap));
  for (const LedgerColumn& c : text.columns) {
    const float symbol = face.width(c.symbol) + face.width(c.index);
    const float head = std::max({symbol, &c == text.columns.data() ? 0 : face.width(c.unit), face.width("MJ/m")});
    const float cell = face.width(widest_cell) + face.points(mark_room);
    w.columns.push_back(std::ceil(std::max(head, cell) + face.points(column_gap)));
  }
  return w;
}

float height_of(const Face& face, std::size_t rows, std::size_t lines) {
  return face.points(symbol_height) + face.points(unit_height) + static_cast<float>(rows) * face.points(row_height) +
         2 * face.points(rule) + face.points(after) + static_cast<float>(lines) * face.points(line_height);
}

/// For a sentence of usual length; a longer one takes room from the notes.
std::size_t sentence_lines(const Face& face, float width) {
  const float usual = face.width("Kinetic energy lost: transfers 00.0 %, projection 00.0 %, walls 0.0 %, elsewhere 0.");
  return static_cast<std::size_t>(std::ceil(1.1F * usual / width));
}

/// What the notes of any pane need, up to `enough`; where that is too little, the last line says so.
std::size_t most_note_lines(const Face& face, float width, std::span<const std::vector<std::string>> notes,
                            std::size_t enough) {
  std::size_t most = 0;
  for (const std::vector<std::string>& own : notes) {
    std::size_t lines = 0;
    for (const std::string& note : own) lines += face.fonts.wrap(face.type, note, width, enough).size();
    most = std::max(most, lines);
  }
  return std::min(most, enough);
}

/// A tick or a cross left of a number; shapes, so that they differ in more than colour.
void draw_mark(gui::Ink& ink, gui::Point at, float size, Claim claim, const Palette& palette) {
  const float r = 0.2F * size, t = 0.1F * size;
  if (claim == Claim::holds)
    ink.polyline(std::array{gui::Point{at.x - r, at.y + 0.1F * r}, gui::Point{at.x - 0.25F * r, at.y + 0.8F * r},
                            gui::Point{at.x + r, at.y - 0.8F * r}},
                 palette.holds, t);
  if (claim != Claim::fails) return;
  ink.line({at.x - r, at.y - r}, {at.x + r, at.y + r}, palette.fails, 1.3F * t);
  ink.line({at.x - r, at.y + r}, {at.x + r, at.y - r}, palette.fails, 1.3F * t);
}

class Table {
public:
  Table(gui::Ink& ink, const Face& face, const Rect& box, const LedgerText& text, const Palette& palette)
      : ink_(ink), face_(face), text_(text), palette_(palette), widths_(widths_of(face, text)), left_(box.x), y_(box.y),
        width_(std::min(box.w, widths_.sum())) {}

  /// Returns where the table ends.
  float draw(bool before) {
    draw_heads();
    draw_rule();
    for (std::size_t i = before ? 0 : 1; i < text_.rows.size(); ++i) {
      if (i + 1 == text_.rows.size()) draw_rule();
      draw_row(i);
    }
    return y_;
  }

private:
  /// That many points further down; returns them in pixels.
  float down(float p) {
    const float h = face_.points(p);
    y_ += h;
    return h;
  }

  void draw_rule() {
    const float y = y_ + std::round(face_.points(rule) / 2) + ink_.hair() / 2;
    ink_.line({left_, y}, {left_ + width_, y}, palette_.line, ink_.hair());
    down(rule);
  }

  void draw_heads() {
    const float line = face_.fonts.size(face_.type), drop = face_.points(index_drop);
    const float unit_y = y_ + face_.points(symbol_height);
    ink_.text({left_, y_, widths_.label, line}, face_.type, palette_.muted, text_.title);
    float right = left_ + widths_.label;
    for (std::size_t c = 0; c < text_.columns.size(); ++c) {
      const LedgerColumn& column = text_.columns[c];
      right += widths_.columns[c];
      const float index = face_.width(column.index), symbol = face_.width(column.symbol);
      ink_.text({right - index, y_ + drop, index + 1, line}, face_.type, palette_.text, column.index);
      ink_.text({right - index - symbol - 1, y_, symbol + 1, line}, face_.type, palette_.text, column.symbol,
                Align::right);
      // The first may begin above the labels.
      const float room = widths_.columns[c] + (c == 0 ? widths_.label : -ink_.pt(2));
      ink_.text({right - room, unit_y, room, face_.points(unit_height)}, face_.type, palette_.muted, column.unit,
                Align::right);
    }
    down(symbol_height);
    down(unit_height);
  }

  void draw_row(std::size_t i) {
    const bool held = i == 0 || i + 1 == text_.rows.size();
    const float h = face_.points(row_height);
    ink_.text({left_, y_, widths_.label, h}, face_.type, held ? palette_.text : palette_.muted, text_.rows[i]);
    float right = left_ + widths_.label;
    for (std::size_t c = 0; c < text_.columns.size(); ++c) {
      right += widths_.columns[c];
      draw_cell(text_.columns[c].cells[i], {right - widths_.columns[c], y_, widths_.columns[c], h});
    }
    y_ += h;
  }

  void draw_cell(const LedgerCell& cell, const Rect& box) {
    const bool fails = cell.claim == Claim::fails;
    const float width = face_.width(cell.text), mark = face_.points(mark_room);
    if (fails)
      ink_.fill({box.right() - width - mark - ink_.pt(2), box.y, width + mark + ink_.pt(4), box.h},
                palette_.fails.alpha(0.16), ink_.pt(3));
    const float number = std::min(width + 1, box.w - mark);
    ink_.text({box.right() - number, box.y, number, box.h}, face_.type,
              fails          ? palette_.fails
              : cell.nothing ? palette_.muted
                             : palette_.text,
              cell.text, Align::right);
    draw_mark(ink_, {box.right() - width - mark / 2, box.middle_y()}, ink_.fonts().size(face_.type), cell.claim,
              palette_);
  }

  gui::Ink& ink_;
  const Face& face_;
  const LedgerText& text_;
  const Palette& palette_;
  Widths widths_;
  float left_, y_, width_;
};

/// The words below a table, from y downwards.
class Words {
public:
  Words(gui::Ink& ink, const Face& face, const Rect& box, float y)
      : ink_(ink), face_(face), box_(box), y_(y), height_(face.points(line_height)) {}

  void say(std::string_view text, Colour colour) { draw(face_.fonts.wrap(face_.type, text, box_.w, room()), colour); }

  /// Whole notes while there is room; the last that fits says how many do not.
  void list(std::span<const std::string> notes, Colour colour) {
    for (std::size_t i = 0; i < notes.size(); ++i) {
      const std::size_t left = notes.size() - i - 1;
      std::vector<std::string> lines = face_.fonts.wrap(face_.type, notes[i], box_.w, 100);
      const bool last = lines.size() > room() || (left > 0 && lines.size() + 1 > room());
      if (last) {
        const std::string more = left > 0 ? " (and " + std::to_string(left) + " more)" : "";
        lines = face_.fonts.wrap(face_.type, notes[i], box_.w - face_.width(more), room());
        if (!lines.empty()) lines.back() += more;
      }
      draw(lines, colour);
      if (last) return;
    }
  }

private:
  /// How many more lines.
  [[nodiscard]] std::size_t room() const {
    return static_cast<std::size_t>(std::max(0.F, std::floor((box_.bottom() - y_ + 0.5F) / height_)));
  }
  void draw(const std::vector<std::string>& lines, Colour colour) {
    for (const std::string& line : lines) {
      ink_.text({box_.x, y_, box_.w, height_}, face_.type, colour, line);
      y_ += height_;
    }
  }

  gui::Ink& ink_;
  const Face& face_;
  const Rect& box_;
  float y_, height_;
};

} // namespace

std::vector<LedgerForm> ledger_forms(const Frame& frame, LedgerView view, const gui::Fonts& fonts,
                                     std::span<const std::vector<std::string>> notes) {
  std::vector<LedgerForm> forms;
  if (view == LedgerView::off) return forms;
  constexpr std::array<float, ledger_column_sets> worth{1, 0.93F, 0.88F, 0.75F, 0.45F};
  for (int set = 0; set < ledger_column_sets; ++set)
    for (const Type type : {Type::body, Type::small})
      for (const bool before : {true, false}) {
        const Face face{fonts, type};
        LedgerForm form{type, static_cast<LedgerColumns>(set), before};
        form.worth = worth[static_cast<std::size_t>(set)] * (before ? 1 : 0.94F) * (type == Type::body ? 1 : 0.88F);
        std::size_t rows = 0;
        for (const Pane& p : frame.panes) {
          if (!p.snapshot->ledger) continue;
          const LedgerText text = ledger_text(*p.snapshot, view, form.columns);
          form.width = std::max(form.width, widths_of(face, text).sum());
          rows = std::max(rows, text.rows.size() - (before ? 0 : 1));
        }
        if (rows == 0) return {};
        form.height = height_of(
            face, rows, sentence_lines(face, form.width) + most_note_lines(face, form.width, notes, before ? 5 : 2));
        forms.push_back(form);
      }
  return forms;
}

void draw_ledger(gui::Ink& ink, const Rect& box, const Snapshot& s, LedgerView view, const LedgerForm& form,
                 std::span<const std::string> notes, const Palette& palette) {
  const Face face{ink.fonts(), form.type};
  if (!s.ledger) return Words(ink, face, box, box.y).say("This solver keeps no ledger.", palette.muted);
  const LedgerText text = ledger_text(s, view, form.columns);
  const float end = Table(ink, face, box, text, palette).draw(form.before);
  Words words(ink, face, box, end + face.points(after));
  words.say(text.sentence, palette.text);
  words.list(notes, palette.muted);
}

} // namespace flipbook::render
