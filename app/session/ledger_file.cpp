// SPDX-License-Identifier: MIT
#include "app/session/ledger_file.h"

#include "app/study/titles.h"
#include "sim/frame/errors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>

namespace flipbook::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view first_columns = "variant,frame,substep,t (";

/// As RFC 4180 asks for: quoted where it holds what would end it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string digits(double x) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 17).ptr};
}

/// A file that is there must be a table of an earlier run, or empty.
void refuse_stranger(const fs::path& file, const std::string& said) {
  std::error_code none;
  if (!fs::exists(file, none)) return;
  std::ifstream text(file, std::ios::binary);
  std::string line;
  if (fs::is_regular_file(file, none) &&
      (fs::file_size(file, none) == 0 || (std::getline(text, line) && line.starts_with(first_columns))))
    return;
  throw UserError(said + ": \"" + file.string() + "\" is in the way: it is no ledger; choose another name");
}

/// Before anything is computed, where the settings say it.
void refuse_without_ledger(const Resolved& r, const std::string& said) {
  for (std::size_t i = 0; i < r.variants.size(); ++i) {
    const Settings& s = r.variants[i].scene.settings;
    const std::string which = r.variants.size() > 1 ? "variant " + std::to_string(i + 1) : "the run";
    if (s.preset == Preset::tutorial)
      throw UserError(said + ": " + which + " keeps no ledger: preset = \"tutorial\" runs the notes' algorithm");
    if (!s.ledger.on) throw UserError(said + ": " + which + " keeps no ledger: ledger.on = false");
  }
}

fs::path checked(fs::path file, const std::string& said, const Resolved& resolved) {
  if (file.extension() != ".csv")
    throw UserError(said + " " + file.string() + ": the ledger is a table; its name ends in .csv");
  refuse_without_ledger(resolved, said);
  refuse_stranger(file, said);
  return file;
}

} // namespace

LedgerFile::LedgerFile(fs::path file, const std::string& said, const Resolved& resolved)
    : file_(checked(std::move(file), said, resolved)), said_(said), resolved_(resolved), staging_(file_.parent_path()) {
  staging_.append(file_.filename().string(), ""); // what cannot be written is told now
}

const LedgerTable& LedgerFile::table(const Snapshot& s, std::size_t variant) const {
  if (!s.ledger)
    throw UserError(said_ + ": variant " + std::to_string(variant + 1) + " keeps no ledger: " + s.solver + " has none");
  return *s.ledger;
}

void LedgerFile::begin(std::span<const std::shared_ptr<const Snapshot>> variants) {
  std::vector<TitledPane> panes;
  for (std::size_t i = 0; i < variants.size(); ++i)
    panes.push_back({resolved_.variants[i].label, variants[i]->title, variants[i]->parameters});
  for (const std::string& title : pane_titles(panes)) titles_.push_back(field(title));
  steps_.assign(variants.size(), 0);

  std::map<std::string, std::vector<std::string>, std::less<>> units; // more than one where 2D stands beside 3D
  for (std::size_t i = 0; i < variants.size(); ++i)
    for (const LedgerTable::Quantity& q : table(*variants[i], i).quantities) {
      if (std::find(columns_.begin(), columns_.end(), q.name) == columns_.end()) columns_.push_back(q.name);
      std::vector<std::string>& known = units[q.name];
      if (std::find(known.begin(), known.end(), q.unit) == known.end()) known.push_back(q.unit);
    }
  std::string clock = variants.front()->time_unit;
  for (const auto& v : variants)
    if (v->time_unit != clock) clock = "s or trips";
  std::string head = std::string(first_columns) + clock + "),stage";
  for (const std::string& name : columns_) {
    std::string unit;
    for (const std::string& u : units[name]) unit += (unit.empty() ? "" : " or ") + u;
    head += "," + field(name + " (" + unit + ")");
  }
  staging_.append(file_.filename().string(), head + "\n");
}

void LedgerFile::write(const Stop& stop, std::span<const std::shared_ptr<const Snapshot>> variants) {
  const bool first = titles_.empty();
  if (first) begin(variants);
  std::string text;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const LedgerTable& l = table(*variants[v], v);
    const auto row = [&](const LedgerTable::Account& a, const std::string& stage, const double* numbers) {
      text += titles_[v] + "," + std::to_string(stop.frame) + "," + std::to_string(a.step - steps_[v]) + "," +
              digits(a.time) + "," + stage;
      for (const std::string& column : columns_) {
        const auto q =
            std::find_if(l.quantities.begin(), l.quantities.end(), [&](auto& x) { return x.name == column; });
        text += ",";
        if (q != l.quantities.end() && q->defined) text += digits(numbers[q - l.quantities.begin()]);
      }
      text += "\n";
    };
    if (first) {
      std::vector<double> start;
      for (const LedgerTable::Quantity& q : l.quantities) start.push_back(q.start);
      row({0, 0, {}, {}}, "particles", start.data());
    }
    for (const LedgerTable::Account& a : l.accounts) {
      if (a.step == 0) continue; // the start, which the first row is
      row(a, "particles", a.held.data());
      for (std::size_t s = 0; s < l.stages.size(); ++s) row(a, l.stages[s].name, a.changes.data() + l.at(s, 0));
    }
    steps_[v] = variants[v]->steps;
  }
  staging_.append(file_.filename().string(), text);
}

} // namespace flipbook::app
