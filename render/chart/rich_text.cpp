// SPDX-License-Identifier: MIT
#include "render/chart/rich_text.h"

#include <algorithm>
#include <cstddef>

namespace flipbook::render {

namespace {

using Script = TextRun::Script;

/// The bytes of the character at `i`.
std::size_t length_at(const std::string& text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t n = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  return std::min(n, text.size() - i);
}

/// Latin letters, and Greek ones (U+0370 to U+03FF). Capitals of Greek stand upright, as in "Δt".
bool is_italic(const std::string& c) {
  if (c.size() == 1) return (c[0] >= 'a' && c[0] <= 'z') || (c[0] >= 'A' && c[0] <= 'Z');
  const auto first = static_cast<unsigned char>(c[0]), second = static_cast<unsigned char>(c[1]);
  if (c.size() == 2 && first == 0xce) return second >= 0xb1; // α to ο
  if (c.size() == 2 && first == 0xcf) return second <= 0x8f; // π to ω
  return c.size() == 3 && first == 0xe1;                     // Latin letters with marks: ṽ
}

class Reader {
public:
  explicit Reader(const std::string& text) : text_(text) {}

  std::vector<TextRun> read() {
    bool math = false;
    for (std::size_t i = 0; i < text_.size();) {
      const std::string c = text_.substr(i, length_at(text_, i));
      i += c.size();
      if (c == "$") {
        if (i < text_.size() && text_[i] == '$')
          add("$", false), ++i;
        else
          math = !math;
      } else if (math) {
        i = formula(c, i);
      } else {
        add(c, false);
      }
    }
    return std::move(runs_);
  }

private:
  /// Takes a character of a formula; returns where the next one is.
  std::size_t formula(const std::string& c, std::size_t next) {
    if (c == "*") return bold_ = !bold_, next;
    if (c == "}" && grouped_) return grouped_ = false, script_ = Script::base, next;
    if (c == "_" || c == "^") {
      script_ = c == "_" ? Script::below : Script::above;
      joined_ = false;
      grouped_ = next < text_.size() && text_[next] == '{';
      return grouped_ ? next + 1 : next;
    }
    add(c, !bold_ && is_italic(c));
    if (!grouped_) script_ = Script::base; // an index of one character
    return next;
  }

  void add(const std::string& c, bool italic) {
    if (!runs_.empty() && joined_) {
      TextRun& last = runs_.back();
      if (last.italic == italic && last.bold == bold_ && last.script == script_) {
        last.text += c;
        return;
      }
    }
    runs_.push_back({c, italic, bold_, script_});
    joined_ = true;
  }

  const std::string& text_;
  std::vector<TextRun> runs_;
  Script script_ = Script::base;
  bool bold_ = false, grouped_ = false, joined_ = false;
};

} // namespace

std::vector<TextRun> rich_text(const std::string& text) {
  return Reader(text).read();
}

std::string plain_text(const std::string& text) {
  std::string plain;
  Script last = Script::base;
  for (const TextRun& run : rich_text(text)) {
    if (run.script != Script::base && run.script != last) plain += run.script == Script::below ? "_" : "^";
    plain += run.text;
    last = run.script;
  }
  return plain;
}

std::vector<std::string> text_words(const std::string& text) {
  std::vector<std::string> words(1);
  bool math = false;
  for (const char c : text) {
    if (c == '$') math = !math;
    if (c == ' ' && !math)
      words.emplace_back();
    else
      words.back() += c;
  }
  std::erase(words, std::string());
  return words;
}

TextLine lay_out(std::vector<TextRun> runs, const std::function<double(const TextRun&)>& advance) {
  TextLine line;
  double base = 0; // where the text on the base line ended: indices begin there
  Script last = Script::base;
  for (TextRun& run : runs) {
    const double wide = advance(run);
    const bool stacked = run.script != Script::base && last != Script::base && run.script != last;
    const double x = stacked ? base : line.width;
    if (run.script == Script::base || last == Script::base) base = run.script == Script::base ? x + wide : x;
    line.above |= run.script == Script::above;
    line.below |= run.script == Script::below;
    line.width = std::max(line.width, x + wide);
    last = run.script;
    line.runs.push_back({std::move(run), x});
  }
  return line;
}

} // namespace flipbook::render
