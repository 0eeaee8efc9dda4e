// SPDX-License-Identifier: MIT
// flipbook info PICTURE.png: the provenance that every picture carries, or the study in it, ready to be run again.
#include "app/commands/command.h"
#include "app/encode/png.h"
#include "app/encode/staging.h"
#include "sim/frame/errors.h"

#include <iostream>
#include <sstream>

namespace flipbook::app {

namespace {

constexpr std::string_view prefix = "flipbook:", study_key = "flipbook:study";

class Info final : public Command {
public:
  void options(OptionVisitor& v) override {
    v.positional({"PICTURE", Argument::Kind::file}, picture_, "A PNG picture made by this program");
    v.flag("--study", study_only_, "Write the study as TOML, to standard output or the file given with -o");
    v.text("-o,--output", output_, {"FILE", Argument::Kind::file}, "Where --study goes");
  }

  int run() override {
    if (!output_.empty() && !study_only_) throw UserError("-o belongs to --study");
    const TextEntries entries = read_png_text(picture_);
    if (study_only_)
      write_study(entries);
    else
      print(entries);
    return 0;
  }

private:
  [[noreturn]] void nothing_found() const {
    throw UserError("no flipbook provenance in this picture", {picture_, 0, 0});
  }

  void write_study(const TextEntries& entries) const {
    for (const auto& [key, text] : entries) {
      if (key != study_key) continue;
      if (output_.empty())
        std::cout << text;
      else
        write_file(output_, text);
      return;
    }
    nothing_found();
  }

  /// One line for each short entry; several lines are indented below their name.
  void print(const TextEntries& entries) const {
    bool any = false;
    for (const auto& [key, text] : entries) {
      if (!key.starts_with(prefix)) continue;
      any = true;
      std::string name = key.substr(prefix.size()) + ":";
      if (text.find('\n') == std::string::npos) {
        name.resize(10, ' ');
        std::cout << name << text << '\n';
        continue;
      }
      std::cout << name << '\n';
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) std::cout << (line.empty() ? "" : "  ") << line << '\n';
    }
    if (!any) nothing_found();
  }

  std::string picture_, output_;
  bool study_only_ = false;
};

} // namespace

std::unique_ptr<Command> make_info() {
  return std::make_unique<Info>();
}

} // namespace flipbook::app
