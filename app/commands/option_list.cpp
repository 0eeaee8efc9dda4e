// SPDX-License-Identifier: MIT
#include "app/commands/option_list.h"

#include <sstream>

namespace flipbook::app {

namespace {

class Recorder final : public OptionVisitor {
public:
  std::vector<OptionInfo> found;

  void positional(const Argument& what, std::string& /*x*/, const std::string& help, bool required) override {
    found.push_back({.names = {}, .value = what, .help = help, .required = required});
  }
  void positionals(const Argument& what, std::vector<std::string>& /*x*/, const std::string& help) override {
    found.push_back({.names = {}, .value = what, .help = help, .repeated = true});
  }
  void text(const std::string& names, std::string& /*x*/, const Argument& value, const std::string& help) override {
    found.push_back({.names = split(names), .value = value, .help = help});
  }
  void texts(const std::string& names, std::vector<std::string>& /*x*/, const Argument& value,
             const std::string& help) override {
    found.push_back({.names = split(names), .value = value, .help = help, .repeated = true});
  }
  void flag(const std::string& names, bool& /*x*/, const std::string& help) override {
    found.push_back({.names = split(names), .value = "", .help = help});
  }

private:
  static std::vector<std::string> split(const std::string& names) {
    std::vector<std::string> all;
    std::istringstream text(names);
    for (std::string name; std::getline(text, name, ',');) all.push_back(name);
    return all;
  }
};

} // namespace

Argument one_of(std::vector<std::string> choices) {
  std::string name;
  for (const std::string& c : choices) name += (name.empty() ? "" : "|") + c;
  return {std::move(name), Argument::Kind::choice, std::move(choices)};
}

std::vector<OptionInfo> options_of(const CommandEntry& entry) {
  Recorder recorder;
  entry.make()->options(recorder);
  recorder.found.push_back({.names = {"-h", "--help"}, .value = "", .help = help_of_help});
  return std::move(recorder.found);
}

} // namespace flipbook::app
