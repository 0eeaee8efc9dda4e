// SPDX-License-Identifier: MIT
// Snapshots as text. Each field is its name, then its value; a list is its length, then its entries; numbers have the
// shortest digits that read back exactly, texts are quoted. One listing of the fields serves writing and reading:
//
//   flipbook-snapshot 1
//   title "FLIP 0.97"
//   time 0.4
//   x 4 0.125 0.125 0.375 0.125
//   ...
#include "sim/frame/snapshot.h"

#include "sim/frame/text_archive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string_view>
#include <utility>

namespace flipbook {
namespace {

constexpr std::string_view magic = "flipbook-snapshot 1";

template <class Archive> void fields(Archive& a, Parameter& p) {
  a.field("path", p.path);
  a.enumeration("kind", p.kind, static_cast<int>(Kind::names));
  a.value("value", p.value, p.kind);
  a.field("help", p.help);
  a.field("unit", p.unit);
  a.field("min", p.min);
  a.field("max", p.max);
  a.field("options", p.options);
  a.field("option_help", p.option_help);
  a.enumeration("level", p.level, static_cast<int>(Level::expert));
  a.enumeration("effect", p.effect, static_cast<int>(Effect::restart));
  a.field("applies", p.applies);
  a.field("at_min", p.at_min);
  a.field("at_max", p.at_max);
}

template <class Archive> void fields(Archive& a, Channel& c) {
  a.field("name", c.name);
  a.field("unit", c.unit);
  a.field("lo", c.lo);
  a.field("hi", c.hi);
  a.field("diverging", c.diverging);
  a.field("values", c.values);
}

template <class Archive> void fields(Archive& a, LatticeData& l) {
  a.field("name", l.name);
  a.field("n", l.n);
  a.field("origin", l.origin);
  a.field("dx", l.dx);
  a.field("values", l.values);
}

/// Solids that share a surface are written with a copy each; when read, each has its own.
template <class Archive> void fields(Archive& a, Solid& s) {
  TriangleMesh mesh = s.surface ? *s.surface : TriangleMesh{};
  a.field("rotation", s.pose.rotation);
  a.field("shift", s.pose.shift);
  a.field("vertices", mesh.vertices);
  a.field("triangles", mesh.triangles);
  a.field("outline", mesh.outline);
  s.surface = std::make_shared<TriangleMesh>(std::move(mesh));
}

template <class Archive> void fields(Archive& a, History::Column& c) {
  a.field("name", c.name);
  a.field("unit", c.unit);
  a.field("y", c.y);
}

template <class Archive> void fields(Archive& a, LedgerTable::Quantity& q) {
  a.field("name", q.name);
  a.field("label", q.label);
  a.field("unit", q.unit);
  a.field("start", q.start);
  a.field("now", q.now);
  a.field("defined", q.defined);
}

template <class Archive> void fields(Archive& a, LedgerTable::Stage& stage) {
  a.field("name", stage.name);
  a.field("label", stage.label);
}

template <class Archive> void fields(Archive& a, LedgerTable::Account& account) {
  a.field("step", account.step);
  a.field("time", account.time);
  a.field("held", account.held);
  a.field("changes", account.changes);
}

template <class Archive> void fields(Archive& a, TrailPoints& t) {
  a.field("time", t.time);
  a.field("ids", t.id);
  a.field("places", t.x);
}

template <class Archive, class T> void each(Archive& a, std::string_view name, std::vector<T>& list) {
  a.length(name, list);
  for (T& x : list) fields(a, x);
}

template <class Archive> void fields(Archive& a, LedgerTable& l) {
  each(a, "quantities", l.quantities);
  each(a, "stages", l.stages);
  a.field("step", l.step);
  a.field("total", l.total);
  std::vector<std::uint8_t> claims;
  for (const LedgerTable::Claim c : l.claims) claims.push_back(static_cast<std::uint8_t>(c));
  a.field("claims", claims);
  l.claims.clear();
  for (const std::uint8_t c : claims) l.claims.push_back(static_cast<LedgerTable::Claim>(c));
  a.field("energy_in", l.energy_in);
  a.field("step_in", l.step_in);
  each(a, "accounts", l.accounts);
}

/// What a snapshot points to, where there is any.
struct Parts {
  History history;
  LedgerTable ledger;
  std::vector<TrailPoints> trails;
  bool has_history = false, has_ledger = false;
};

template <class Archive> void fields(Archive& a, Snapshot& s, Parts& parts) {
  a.field("title", s.title);
  a.field("scheme", s.scheme);
  a.field("kernel", s.kernel);
  a.field("solver", s.solver);
  each(a, "parameters", s.parameters);
  a.field("notes", s.notes);
  a.field("frame", s.frame);
  a.field("time", s.time);
  a.field("steps", s.steps);
  a.field("dt", s.dt);
  a.field("pressure_iterations", s.pressure_iterations);
  a.field("pressure_residual", s.pressure_residual);
  a.field("dim", s.dim);
  a.field("lo", s.lo);
  a.field("hi", s.hi);
  a.field("cells", s.cells);
  a.field("dx", s.dx);
  a.field("periodic", s.periodic);
  a.field("up", s.up);
  a.field("particle_spacing", s.particle_spacing);
  a.field("x", s.x);
  a.field("v", s.v);
  a.field("id", s.id);
  each(a, "channels", s.channels);
  each(a, "lattices", s.lattices);
  each(a, "solids", s.solids);
  a.field("history", parts.has_history);
  if (parts.has_history) {
    a.field("t", parts.history.t);
    each(a, "columns", parts.history.columns);
  }
  a.optional("ledger", parts.has_ledger);
  if (parts.has_ledger) fields(a, parts.ledger);
  bool warned = !s.warnings.empty();
  a.optional("warnings", warned);
  if (warned) a.field("lines", s.warnings);
  bool marked = !s.watermark.empty();
  a.optional("watermark", marked);
  if (marked) a.field("text", s.watermark);
  bool counts = s.time_unit != "s";
  a.optional("time_unit", counts);
  if (counts) a.field("unit", s.time_unit);
  bool trailing = !parts.trails.empty();
  a.optional("trails", trailing);
  if (trailing) each(a, "rows", parts.trails);
}

using Require = std::function<void(bool, const std::string&)>;

void check(const LedgerTable& l, const Require& require) {
  const std::size_t quantities = l.quantities.size(), entries = l.stages.size() * quantities;
  require(l.step.size() == entries && l.total.size() == entries && l.claims.size() == entries,
          "the ledger must hold a change and a claim for each stage and quantity");
  require(std::all_of(l.claims.begin(), l.claims.end(), [](auto c) { return c <= LedgerTable::Claim::fails; }),
          "a claim of the ledger is 0, 1 or 2");
  for (const LedgerTable::Account& a : l.accounts)
    require(a.held.size() == quantities && a.changes.size() == entries,
            "an account of the ledger must hold a number for each quantity, and one for each stage and quantity");
}

/// What drawing relies on: every array has the length that the others imply.
void check(const Snapshot& s, const std::string& path) {
  const Require require = [&path](bool holds, const std::string& message) {
    if (!holds) throw UserError(message, Location{path});
  };
  if (s.ledger) check(*s.ledger, require);
  require(s.dim == 2 || s.dim == 3, "dim must be 2 or 3");
  require(s.dx > 0, "dx must be positive");
  const std::size_t numbers = s.particles() * static_cast<std::size_t>(s.dim);
  require(s.x.size() == numbers, "x must hold " + std::to_string(numbers) + " numbers, one per particle and axis");
  require(s.v.size() == numbers, "v must hold " + std::to_string(numbers) + " numbers, one per particle and axis");
  for (const Channel& c : s.channels)
    require(c.values.size() == s.particles(), "channel \"" + c.name + "\" must hold a number for each particle");
  for (const LatticeData& l : s.lattices) {
    std::size_t samples = 1;
    for (const int n : l.n) {
      require(n >= 1 && n <= 1 << 20, "lattice \"" + l.name + "\" has an impossible size");
      samples *= static_cast<std::size_t>(n);
    }
    require(l.dx > 0 && std::isfinite(l.dx), "lattice \"" + l.name + "\" must have a positive dx");
    require(l.values.size() == samples, "lattice \"" + l.name + "\" must hold " + std::to_string(samples) + " numbers");
  }
  const auto finite = [](const auto& list) {
    return std::all_of(list.begin(), list.end(), [](auto x) { return std::isfinite(x); });
  };
  require(finite(s.lo) && finite(s.hi), "the domain must be finite");
  for (std::size_t a = 0; a < static_cast<std::size_t>(s.dim); ++a)
    require(s.lo[a] < s.hi[a], "hi must be above lo on every axis");
  require(std::count(s.up.begin(), s.up.end(), 0.0) == 2 && finite(s.up), "up must point along one axis");
  for (const Solid& solid : s.solids) {
    const TriangleMesh& m = *solid.surface;
    require(finite(solid.pose.rotation) && finite(solid.pose.shift), "the pose of a solid must be finite");
    require(finite(m.vertices) && m.vertices.size() % 3 == 0, "a solid must have three finite numbers for each vertex");
    const auto known = [&](std::uint32_t i) { return i < m.vertices.size() / 3; };
    require(m.triangles.size() % 3 == 0 && std::all_of(m.triangles.begin(), m.triangles.end(), known) &&
                m.outline.size() % 2 == 0 && std::all_of(m.outline.begin(), m.outline.end(), known),
            "a solid's triangles and outline must name its vertices");
  }
  for (const auto& t : s.trails)
    require(t->x.size() == 2 * t->id.size() && std::is_sorted(t->id.begin(), t->id.end()),
            "trails must hold two numbers for each particle, by ascending id");
  if (!s.history) return;
  for (const History::Column& c : s.history->columns)
    require(c.y.size() == s.history->t.size(), "curve \"" + c.name + "\" must be as long as its times");
}

template <class T> std::size_t heap(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

} // namespace

std::size_t Snapshot::bytes() const {
  std::size_t sum = sizeof *this + heap(x) + heap(v) + heap(id) + heap(parameters) +
                    heap(solids); // not their surfaces, which all snapshots of a run share
  for (const Channel& c : channels) sum += sizeof c + heap(c.values);
  for (const LatticeData& l : lattices) sum += sizeof l + heap(l.values);
  sum += heap(trails); // not their points, which the snapshots of a run share
  if (history) {
    sum += sizeof *history + heap(history->t);
    for (const History::Column& c : history->columns) sum += sizeof c + heap(c.y);
  }
  if (ledger) {
    sum += sizeof *ledger + heap(ledger->quantities) + heap(ledger->stages) + heap(ledger->step) + heap(ledger->total) +
           heap(ledger->claims);
    for (const LedgerTable::Account& a : ledger->accounts) sum += sizeof a + heap(a.held) + heap(a.changes);
  }
  return sum;
}

void save_snapshot(const Snapshot& s, const std::string& path) {
  Snapshot copy = s; // the listing of the fields is shared with reading, which writes to them
  Parts parts;
  if ((parts.has_history = s.history != nullptr)) parts.history = *s.history;
  if ((parts.has_ledger = s.ledger != nullptr)) parts.ledger = *s.ledger;
  for (const auto& t : s.trails) parts.trails.push_back(*t);
  TextWriter writer;
  writer.text.append(magic).append("\n");
  fields(writer, copy, parts);

  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  file << writer.text;
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());
    throw MachineError("cannot write the snapshot " + path);
  }
}

Snapshot load_snapshot(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf())) throw UserError("cannot read the snapshot", Location{path});
  const std::string text = std::move(content).str();
  if (!text.starts_with(std::string(magic) + "\n"))
    throw UserError("is not a snapshot: its first line must be \"" + std::string(magic) + "\"", Location{path, 1, 1});

  TextReader reader(std::string_view(text).substr(magic.size()), path);
  Snapshot s;
  Parts parts;
  fields(reader, s, parts);
  reader.end();
  if (parts.has_history) s.history = std::make_shared<History>(std::move(parts.history));
  if (parts.has_ledger) s.ledger = std::make_shared<LedgerTable>(std::move(parts.ledger));
  for (TrailPoints& t : parts.trails) s.trails.push_back(std::make_shared<TrailPoints>(std::move(t)));
  check(s, path);
  return s;
}

} // namespace flipbook
