// SPDX-License-Identifier: MIT
#include "app/gallery/page.h"

#include "app/encode/provenance.h"
#include "app/gallery/html.h"
#include "app/gallery/page_files.h"
#include "render/chart/rich_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace flipbook::app::gallery {

namespace fs = std::filesystem;

namespace {

std::string_view page_file(std::string_view name) {
  for (const PageFile& f : page_files())
    if (f.name == name) return f.text;
  throw std::logic_error("the page has no " + std::string(name));
}

/// JSON that may stand inside a script element: no "<" is in it.
std::string json_text(const nlohmann::json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

std::string decimals(double x, int n) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", n, x);
  return text.data();
}

/// What a figure says, with its mathematics.
std::string rich_html(const std::string& text) {
  std::string html;
  for (const render::TextRun& run : render::rich_text(text)) {
    std::string part = escape(run.text);
    if (run.bold) part = "<strong>" + part + "</strong>";
    if (run.italic) part = "<i>" + part + "</i>";
    if (run.script == render::TextRun::Script::below) part = "<sub>" + part + "</sub>";
    if (run.script == render::TextRun::Script::above) part = "<sup>" + part + "</sup>";
    html += part;
  }
  return html;
}

std::string title(const Piece& p) {
  return p.rich ? rich_html(p.title) : escape(p.title);
}

/// Makes the parts of the page that hold files: by name, or whole.
class Writer {
public:
  Writer(const fs::path& folder, bool inlined) : folder_(folder), inlined_(inlined) {}

  [[nodiscard]] std::string piece(const Piece& p) const {
    return fill(page_file("piece.html"),
                {{"ID", escape(p.id)},
                 {"KIND", kind(p)},
                 {"TITLE", title(p)},
                 {"MEDIA", media(p)},
                 {"TEXT", p.rich ? "<p class=\"text\">" + rich_html(p.text) + "</p>\n" : paragraphs(p.text, "text")},
                 {"NOTE", paragraphs(p.note, "note")},
                 {"MOMENTS", moments(p)},
                 {"COMMAND", command(p)},
                 {"TABLES", table(p.kept, p.id) + table(p.parameters, p.id)},
                 {"STUDY", study(p)},
                 {"DOWNLOADS", downloads(p)}});
  }

  [[nodiscard]] static std::string paragraphs(const std::string& text, const std::string& name) {
    std::string html;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find("\n\n", begin), text.size());
      const std::string one = text.substr(begin, end - begin);
      if (one.find_first_not_of(" \n") != std::string::npos)
        html += "<p class=\"" + name + "\">" + escape(one) + "</p>\n";
      begin = end + 2;
    }
    return html;
  }

private:
  static std::string kind(const Piece& p) {
    constexpr std::array<const char*, 4> names{"video", "picture", "figure", "scrubber"};
    return names[static_cast<std::size_t>(p.kind)];
  }

  [[nodiscard]] std::string source(const std::string& file) const {
    return inlined_ ? data_uri(folder_ / file) : address(file);
  }

  static std::string size(const Piece& p) {
    if (p.width <= 0 || p.height <= 0) return "";
    return " width=\"" + std::to_string(p.width) + "\" height=\"" + std::to_string(p.height) + "\"";
  }

  [[nodiscard]] std::string media(const Piece& p) const {
    const std::vector<std::pair<std::string_view, std::string>> marks{
        {"ID", escape(p.id)},
        {"ALT", escape(p.alt)},
        {"SIZE", size(p)},
        {"SOURCE", source(p.media)},
        {"NARROW", p.narrow.empty() ? "" : source(p.narrow)},
        {"TYPE", std::string(media_type(p.media))},
        {"POSTER", p.poster.empty() ? "" : " poster=\"" + source(p.poster) + "\""},
        {"TRACK", track(p)},
        {"DATA", p.kind == Piece::Kind::scrubber ? scrubber_data(p.scrubber) : ""},
        {"TICKS", ticks(p.scrubber)},
        {"LAST_VALUE", std::to_string(std::max<std::size_t>(p.scrubber.values.size(), 1) - 1)},
        {"LAST_MOMENT", std::to_string(std::max<std::size_t>(p.scrubber.times.size(), 1) - 1)},
        {"FIRST_MOMENT", std::to_string(p.scrubber.times.size() / 2)},
        {"PARAMETER", escape(p.scrubber.parameter)},
        {"HELP", escape(p.scrubber.help)}};
    return fill(page_file(kind(p) + ".html"), marks);
  }

  /// As a data address: browsers load no subtitles from a disk.
  [[nodiscard]] std::string track(const Piece& p) const {
    if (p.subtitles.empty()) return "";
    return "<track kind=\"captions\" srclang=\"en\" label=\"What changes\" src=\"" + data_uri(folder_ / p.subtitles) +
           "\">";
  }

  [[nodiscard]] std::string scrubber_data(const Scrubber& s) const {
    nlohmann::json files = nlohmann::json::array();
    for (const std::string& f : s.files) files.push_back(source(f));
    return json_text({{"values", s.values},
                      {"titles", s.titles},
                      {"times", s.times},
                      {"seconds", s.seconds},
                      {"unit", s.unit},
                      {"files", files}});
  }

  static std::string ticks(const Scrubber& s) {
    std::string html;
    for (const std::string& v : s.values) html += "<span>" + escape(v) + "</span>";
    return html;
  }

  static std::string moments(const Piece& p) {
    if (p.cues.empty()) return "";
    std::string html = "<h3>What changes</h3>\n<ol class=\"moments\">\n";
    for (const Cue& cue : p.cues) {
      std::string lines;
      for (const std::string& line : cue.lines) lines += (lines.empty() ? "" : "; ") + line;
      html += "<li><button type=\"button\" data-seek=\"" + decimals(cue.from, 3) + "\">" + decimals(cue.from, 1) +
              " s</button> <span>" + escape(lines) + "</span></li>\n";
    }
    return html + "</ol>\n";
  }

  static std::string command(const Piece& p) {
    if (p.command.empty()) return "";
    return fill(page_file("command.html"), {{"ID", escape(p.id)}, {"COMMAND", escape(p.command)}});
  }

  static std::string study(const Piece& p) {
    if (p.study.empty()) return "";
    return "<details><summary>The whole study</summary><pre tabindex=\"0\">" + escape(p.study) + "</pre></details>\n";
  }

  [[nodiscard]] std::string downloads(const Piece& p) const {
    std::string html;
    for (const auto& [what, file] : p.downloads) {
      const std::string name = fs::path(file).filename().string();
      html += "<li><a href=\"" + source(file) + "\" download=\"" + escape(name) + "\">" + escape(what) + " <span>" +
              escape(name) + "</span></a></li>\n";
    }
    return html.empty() ? "" : "<ul class=\"downloads\">\n" + html + "</ul>\n";
  }

  static std::string table(const Table& t, const std::string& id) {
    if (t.empty()) return "";
    std::string head, body;
    for (const std::string& h : t.head) head += h.empty() ? "<td></td>" : "<th scope=\"col\">" + escape(h) + "</th>";
    for (const auto& row : t.rows) {
      body += "<tr><th scope=\"row\">" + escape(row.front()) + "</th>";
      const bool shared = row.size() == 2 && t.head.size() > 2;
      if (shared)
        body +=
            "<td class=\"shared\" colspan=\"" + std::to_string(t.head.size() - 1) + "\">" + escape(row[1]) + "</td>";
      for (std::size_t i = 1; i < row.size() && !shared; ++i) body += "<td>" + escape(row[i]) + "</td>";
      body += "</tr>\n";
    }
    return fill(page_file("table.html"), {{"CAPTION", escape(t.caption)},
                                          {"LABEL", escape(t.caption + " of " + id)},
                                          {"HEAD", head},
                                          {"BODY", body},
                                          {"NOTE", paragraphs(t.note, "below")}});
  }

  const fs::path& folder_;
  bool inlined_;
};

std::string contents(const std::vector<Piece>& pieces) {
  if (pieces.size() < 2) return "";
  std::string html = "<nav aria-label=\"Contents\"><ol>\n";
  for (const Piece& p : pieces) html += "<li><a href=\"#" + escape(p.id) + "\">" + title(p) + "</a></li>\n";
  return html + "</ol></nav>\n";
}

} // namespace

std::string page_html(const PageText& text, const fs::path& folder, bool inlined) {
  const Writer writer(folder, inlined);
  std::string pieces;
  for (const Piece& p : text.pieces) pieces += writer.piece(p);
  std::string script;
  for (const char* name : {"videos.js", "scrubber.js", "copy.js"})
    script += "<script>\n" + std::string(page_file(name)) + "</script>\n";
  return fill(page_file("page.html"), {{"VERSION", escape(version())},
                                       {"TITLE", escape(text.title)},
                                       {"INTRO", Writer::paragraphs(text.intro, "intro")},
                                       {"STYLE", std::string(page_file("page.css"))},
                                       {"CONTENTS", contents(text.pieces)},
                                       {"PIECES", pieces},
                                       {"SCRIPT", script}});
}

} // namespace flipbook::app::gallery
