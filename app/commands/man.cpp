// SPDX-License-Identifier: MIT
// flipbook man [COMMAND]: the manual page of the program, or of one command, in the man(7) macros; from the same table
// and options as --help.
#include "app/commands/command.h"
#include "app/commands/option_list.h"
#include "app/encode/provenance.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <sstream>

namespace flipbook::app {

namespace {

struct Item {
  const char *term, *text;
};

constexpr std::array<Item, 5> exit_codes{
    {{"0", "All went well."},
     {"1", "A check failed (verify)."},
     {"2", "The command line, a study, a scene or another file of the user's is wrong; one line says where."},
     {"3", "The machine cannot do it: no ffmpeg, no OpenGL, a full disk, no permission, too little memory."},
     {"4", "A particle stopped being finite."}}};

constexpr std::array<Item, 5> files{
    {{"PREFIX/share/flipbook/", "The folder of scenes, studies and templates, beside the installed program."},
     {"scenes/NAME.toml", "A scene: a liquid at its start. scenes/annotated.toml documents every key."},
     {"studies/NAME.toml", "A study: variants of a scene, a timeline, the view. studies/annotated.toml documents "
                           "every key."},
     {"templates/scene.toml, templates/study.toml, templates/scheme.h.in", "What flipbook new starts from."},
     {"out/", "Where results go without -o, in the current folder."}}};

constexpr std::array<Item, 4> variables{
    {{"FLIPBOOK_ASSETS", "A folder with scenes, studies and templates of one's own; searched first."},
     {"FLIPBOOK_FONTS", "The folder with DejaVuSans.ttf and its relatives, instead of the usual ones."},
     {"FLIPBOOK_SHADERS", "A folder of shaders to use instead of those in the program."},
     {"PATH", "Where ffmpeg is looked for, which encodes videos."}}};

/// In lines of at most 80 characters, as readers of the source and linters like it.
std::string wrapped(const std::string& text) {
  constexpr std::size_t longest = 76; // hyphens will take two
  std::string out, line, word;
  std::istringstream words(text);
  while (words >> word) {
    if (!line.empty() && line.size() + 1 + word.size() > longest) out += line + "\n", line.clear();
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line;
}

/// Text as roff takes it: a hyphen that can be typed, no line that is taken for a macro.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}
std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

void section(const std::string& title) {
  std::cout << ".SH " << title << '\n';
}
void paragraph(const std::string& text) {
  std::cout << roff(wrapped(text)) << '\n';
}
void item(const std::string& term, const std::string& text) {
  std::cout << ".TP\n" << term << '\n' << roff(wrapped(text)) << '\n';
}
template <std::size_t n> void items(const std::string& title, const std::array<Item, n>& all) {
  section(title);
  for (const Item& i : all) item(bold(i.term), i.text);
}

/// "Text" and "Text." as a sentence.
std::string sentence(std::string text) {
  if (!text.empty() && text.find_last_of(".!?") != text.size() - 1) text += '.';
  return text;
}

/// The command lines below the word "Examples:".
std::vector<std::string> example_lines(const CommandEntry& c) {
  std::vector<std::string> lines;
  std::istringstream text(c.examples);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("  ")) lines.push_back(line.substr(2));
  return lines;
}

void examples(const std::vector<std::string>& lines) {
  section("EXAMPLES");
  std::cout << ".EX\n";
  for (const std::string& line : lines) std::cout << roff(line) << '\n';
  std::cout << ".EE\n";
}

void header(const std::string& name) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return 'a' <= c && c <= 'z' ? char(c - 32) : c; });
  std::cout << ".\\\" Made by \"flipbook man\"; the text is that of --help.\n"
            << ".TH \"" << roff(title) << "\" 1 \"\" \"flipbook " << version() << "\" \"User Commands\"\n.nh\n.ad l\n";
}

std::string synopsis(const CommandEntry& c, const std::vector<OptionInfo>& options) {
  std::string line = bold("flipbook " + c.name);
  for (const OptionInfo& o : options)
    if (o.by_place())
      line += (o.required ? " " + italic(o.value.name) : " [" + italic(o.value.name) + "]") + (o.repeated ? "..." : "");
  return line + " [" + italic("OPTIONS") + "]";
}

void list_options(const std::vector<OptionInfo>& options) {
  for (const OptionInfo& o : options) {
    std::string term;
    for (const std::string& name : o.names) term += (term.empty() ? "" : ", ") + bold(name);
    if (o.by_place())
      term = italic(o.value.name);
    else if (!o.is_flag())
      term += " " + italic(o.value.name);
    item(term, sentence(o.help));
  }
}

void page_of(const CommandEntry& c) {
  const std::vector<OptionInfo> options = options_of(c);
  header("flipbook-" + c.name);
  section("NAME");
  paragraph("flipbook-" + c.name + " - " + c.summary);
  section("SYNOPSIS");
  std::cout << synopsis(c, options) << '\n';
  section("OPTIONS");
  list_options(options);
  items("EXIT STATUS", exit_codes);
  examples(example_lines(c));
  section("SEE ALSO");
  std::cout << ".BR flipbook (1)\n";
}

void page_of_program() {
  header("flipbook");
  section("NAME");
  paragraph(std::string("flipbook - ") + program_summary);
  section("SYNOPSIS");
  std::cout << bold("flipbook") << ' ' << italic("COMMAND") << " [" << italic("OPTIONS") << "]\n.br\n"
            << bold("flipbook") << ' ' << bold("--help") << " | " << bold("--version") << '\n';
  section("DESCRIPTION");
  paragraph("Runs PIC, FLIP, RPIC, APIC and what lies between them from the same particles and with the same time "
            "steps, and draws them side by side as a video or as pictures. A study, one TOML file, says what to run; "
            "the options of a command change it for once. The pictures do not depend on the number of threads, and "
            "each carries the study that it was made from.");
  section("OPTIONS");
  item(bold("-h") + ", " + bold("--help"), "The commands in short; behind a command: its options.");
  item(bold("--version"), "Version and instruction set in use.");
  section("COMMANDS");
  std::vector<std::string> lines;
  for (const CommandEntry& c : commands()) {
    std::vector<OptionInfo> options = options_of(c);
    options.pop_back(); // --help, which is said above
    std::cout << ".SS \"" << roff(c.name) << "\"\n" << synopsis(c, options) << "\n.PP\n";
    paragraph(sentence(c.summary));
    list_options(options);
    for (const std::string& line : example_lines(c)) lines.push_back(line);
  }
  items("EXIT STATUS", exit_codes);
  items("ENVIRONMENT", variables);
  items("FILES", files);
  examples(lines);
}

class Man final : public Command {
public:
  void options(OptionVisitor& v) override {
    std::vector<std::string> names;
    for (const CommandEntry& c : commands()) names.push_back(c.name);
    v.positional({"COMMAND", Argument::Kind::choice, names}, command_, "A command; all of them if not given", false);
  }

  int run() override {
    if (command_.empty()) return page_of_program(), 0;
    std::vector<std::string> names;
    for (const CommandEntry& c : commands()) {
      if (c.name == command_) return page_of(c), 0;
      names.push_back(c.name);
    }
    throw UserError("there is no command \"" + command_ + "\"", {}, nearest_name(command_, names));
  }

private:
  std::string command_;
};

} // namespace

std::unique_ptr<Command> make_man() {
  return std::make_unique<Man>();
}

} // namespace flipbook::app
