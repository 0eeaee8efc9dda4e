// SPDX-License-Identifier: MIT
#include "app/commands/complete.h"

#include "app/commands/option_list.h"
#include "app/study/paths.h"
#include "sim/frame/errors.h"
#include "sim/museum/museum.h"
#include "sim/scene/assets.h"
#include "sim/scene/toml_reader.h"
#include "sim/transfer/schemes.h"

#include <algorithm>
#include <ostream>

namespace flipbook::app {

namespace {

using Words = std::vector<std::string>;

/// Collects what fits the word, or the part of it that is being typed.
class Collector {
public:
  explicit Collector(std::string word) : word_(std::move(word)) {}

  Offer offer;

  /// From here on only what stands behind `length` characters is completed.
  void skip(std::size_t length) {
    fixed_ += word_.substr(0, length);
    word_.erase(0, length);
  }
  /// The part behind the last comma.
  void skip_to_last_entry() {
    const std::size_t comma = word_.rfind(',');
    if (comma != std::string::npos) skip(comma + 1);
    offer.unfinished = true;
  }
  [[nodiscard]] bool fits(const std::string& text) const { return text.starts_with(word_); }
  void add(const std::string& text, const std::string& help = "") {
    if (fits(text)) offer.entries.push_back({fixed_ + text, help});
  }
  [[nodiscard]] const std::string& word() const { return word_; }

private:
  std::string fixed_, word_;
};

/// The line of help that a scene or study carries; none if the file cannot be read, which is no moment for a message.
std::string line_of_help(const char* folder, const std::string& name, const char* key) {
  try {
    const auto path = find_asset(folder, name);
    const Node table = path ? parse_toml(read_text_file(*path), *path) : Node{};
    const Node* line = table.find(key);
    return line && line->type == Node::Type::text ? line->text : "";
  } catch (const UserError&) {
    return "";
  }
}

void add_assets(Collector& all, const char* folder, const char* key) {
  for (const std::string& name : list_assets(folder))
    if (all.fits(name)) all.add(name, line_of_help(folder, name, key)); // a file is only read for a line that is shown
}

void add_values(Collector& all, const Parameter& p) {
  Words values = p.options;
  if (p.kind == Kind::flag) values = {"true", "false"};
  if (p.path == "view.plots" || p.path == "view.log") values = plot_names();
  for (std::size_t i = 0; i < values.size(); ++i) all.add(values[i], i < p.option_help.size() ? p.option_help[i] : "");
}

/// path=value, or path=value,value,... where `several`.
void add_assignments(Collector& all, bool several) {
  const std::size_t equals = all.word().find('=');
  const std::string path = all.word().substr(0, equals);
  for (const Parameter& p : known_parameters()) {
    if (several && !check_pane_path(p.path).message.empty()) continue;
    if (equals == std::string::npos) {
      all.offer.unfinished = true;
      all.add(p.path + "=", p.help);
    } else if (p.path == path) {
      all.skip(equals + 1);
      if (several || p.kind == Kind::names) all.skip_to_last_entry();
      return add_values(all, p);
    }
  }
}

void add_schemes(Collector& all) {
  all.skip_to_last_entry();
  for (const SchemeInfo& s : scheme_infos()) all.add(std::string(s.name), std::string(s.summary));
}

void add_values(Collector& all, const Argument& value) {
  using enum Argument::Kind;
  switch (value.kind) {
  case other: return;
  case choice:
    for (const std::string& c : value.choices) all.add(c);
    return;
  case file: all.offer.paths = Offer::Paths::files; return;
  case folder: all.offer.paths = Offer::Paths::folders; return;
  case study: add_assets(all, "studies", "title"); [[fallthrough]];
  case scene:
    add_assets(all, "scenes", "summary");
    all.offer.paths = Offer::Paths::files;
    return;
  case assignment: return add_assignments(all, false);
  case variation: return add_assignments(all, true);
  case schemes: return add_schemes(all);
  case mistake:
    for (const museum::Exhibit& e : museum::exhibits()) all.add(std::string(e.name), std::string(e.wrong));
    return all.add("mystery:1", "One of them, which is not told");
  }
}

const OptionInfo* find_option(const std::vector<OptionInfo>& options, const std::string& name) {
  const auto at = std::find_if(options.begin(), options.end(), [&](const OptionInfo& o) {
    return std::find(o.names.begin(), o.names.end(), name) != o.names.end();
  });
  return at == options.end() ? nullptr : &*at;
}

/// What the words between the command and the one being typed leave open.
struct Given {
  const OptionInfo* waiting = nullptr; ///< an option that lacks its value
  std::size_t places = 0;              ///< arguments by their place so far
  std::vector<const OptionInfo*> options;
};

Given read_given(const std::vector<OptionInfo>& options, const Words& words) {
  Given given;
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (given.waiting) {
      given.waiting = nullptr;
    } else if (words[i].size() > 1 && words[i][0] == '-') {
      const std::size_t equals = words[i].find('=');
      const OptionInfo* o = find_option(options, words[i].substr(0, equals));
      given.options.push_back(o);
      if (o && !o->is_flag() && equals == std::string::npos) given.waiting = o;
    } else {
      ++given.places;
    }
  }
  return given;
}

void add_option_names(Collector& all, const std::vector<OptionInfo>& options, const Given& given) {
  const auto again = [&](const OptionInfo& o) {
    return !o.repeated && std::find(given.options.begin(), given.options.end(), &o) != given.options.end();
  };
  for (const OptionInfo& o : options)
    if (!o.by_place() && !again(o)) all.add(o.names.back(), o.help);
}

void add_place(Collector& all, const std::vector<OptionInfo>& options, std::size_t place) {
  for (const OptionInfo& o : options)
    if (o.by_place() && (place-- == 0 || o.repeated)) return add_values(all, o.value);
}

void complete_command(Collector& all, const CommandEntry& entry, const Words& words) {
  const std::vector<OptionInfo> options = options_of(entry);
  const Given given = read_given(options, words);
  if (given.waiting) return add_values(all, given.waiting->value);
  if (!all.word().starts_with("-")) return add_place(all, options, given.places);
  const std::size_t equals = all.word().find('=');
  const OptionInfo* o = equals == std::string::npos ? nullptr : find_option(options, all.word().substr(0, equals));
  if (!o || o->is_flag()) return add_option_names(all, options, given);
  all.skip(equals + 1);
  add_values(all, o->value);
}

/// Names that are both a study and a scene are offered once: the study, as the commands prefer it.
void drop_repeated(std::vector<Offer::Entry>& entries) {
  std::vector<Offer::Entry> once;
  for (Offer::Entry& e : entries)
    if (std::none_of(once.begin(), once.end(), [&](const Offer::Entry& o) { return o.text == e.text; }))
      once.push_back(std::move(e));
  entries = std::move(once);
}

} // namespace

Offer complete(const std::vector<std::string>& words) {
  Collector all(words.empty() ? "" : words.back());
  if (words.size() < 2) {
    for (const CommandEntry& c : commands()) all.add(c.name, c.summary);
    if (all.word().starts_with("-")) {
      all.add("--help", "Print the commands and end");
      all.add("--version", "Print version and instruction set in use and end");
    }
    return all.offer;
  }
  for (const CommandEntry& c : commands())
    if (c.name == words.front()) complete_command(all, c, words);
  drop_repeated(all.offer.entries);
  return all.offer;
}

void print_offer(std::ostream& out, const Offer& offer) {
  for (const Offer::Entry& e : offer.entries) {
    std::string help = e.help; // a summary may have several lines
    std::replace_if(
        help.begin(), help.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    out << e.text << (help.empty() ? "" : "\t") << help << '\n';
  }
  if (offer.paths == Offer::Paths::files) out << ":files\n";
  if (offer.paths == Offer::Paths::folders) out << ":folders\n";
  if (offer.unfinished) out << ":nospace\n";
}

} // namespace flipbook::app
