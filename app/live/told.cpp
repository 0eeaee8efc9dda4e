// SPDX-License-Identifier: MIT
#include "app/live/told.h"

#include "app/encode/provenance.h"

#include "sim/frame/errors.h"
#include "sim/scene/assets.h"
#include "sim/scene/read_scene.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace flipbook::app::live {
namespace {

using Json = nlohmann::json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The first of `keys` that a file's table has as a text.
std::string title_in(const Node& root, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const Node* n = root.find(key); n && n->type == Node::Type::text) return n->text;
  return "";
}

/// Names and titles of the files in a folder of the assets; one that cannot be read has no title.
Json listed(const char* folder, const std::vector<std::string>& names) {
  Json all = Json::array();
  for (const std::string& name : names) {
    std::string title;
    try {
      if (const auto path = find_asset(folder, name))
        title = title_in(parse_toml(read_text_file(*path), *path), {"title", "summary"});
    } catch (const UserError&) { // opening it will say what is wrong
    }
    all.push_back({{"name", name}, {"title", title}});
  }
  return all;
}

Json json_of(const Value& value) {
  return std::visit([](const auto& x) { return Json(x); }, value);
}
Json finite(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json json_of(const std::vector<Parameter>& all) {
  constexpr const char* kinds[] = {"flag", "real", "integer", "choice", "text", "reals", "integers", "names"};
  Json list = Json::array();
  for (const Parameter& p : all)
    list.push_back({{"path", p.path},
                    {"kind", kinds[static_cast<std::size_t>(p.kind)]},
                    {"value", json_of(p.value)},
                    {"help", p.help},
                    {"unit", p.unit},
                    {"min", finite(p.min)},
                    {"max", finite(p.max)},
                    {"options", p.options},
                    {"option_help", p.option_help},
                    {"at_min", p.at_min},
                    {"at_max", p.at_max},
                    {"level", p.level == Level::teach ? "teach" : "expert"},
                    {"restart", p.effect == Effect::restart},
                    {"applies", p.applies}});
  return list;
}

double tenths(double x) {
  return std::round(10 * x) / 10;
}

} // namespace

std::string tell_hello(serve::ClientId client, bool drives, const std::string& folder) {
  Json tools = Json::array();
  for (const std::string_view t : serve::tool_names) tools.push_back(std::string(t));
  return text_of({{"type", "hello"},
                  {"protocol", 1},
                  {"version", version()},
                  {"id", client},
                  {"role", drives ? "driver" : "viewer"},
                  {"studies", listed("studies", list_studies())},
                  {"scenes", listed("scenes", list_scenes())},
                  {"tools", tools},
                  {"folder", folder}});
}

std::string tell_role(bool drives, std::size_t clients) {
  return text_of({{"type", "role"}, {"role", drives ? "driver" : "viewer"}, {"clients", clients}});
}

std::string tell_message(const std::string& level, const std::string& text) {
  return text_of({{"type", "message"}, {"level", level}, {"text", text}});
}

std::string tell_saved(const std::string& kind, const std::string& name, const std::string& text) {
  return text_of({{"type", "saved"}, {"kind", kind}, {"name", name}, {"text", text}});
}

std::string tell_parameters(const std::vector<std::string>& titles, const std::vector<std::vector<Parameter>>& panes,
                            const std::vector<Parameter>& view) {
  Json all = Json::array();
  for (std::size_t i = 0; i < panes.size(); ++i)
    all.push_back({{"title", i < titles.size() ? titles[i] : ""}, {"parameters", json_of(panes[i])}});
  return text_of({{"type", "parameters"}, {"panes", all}, {"view", json_of(view)}});
}

std::string tell_state(const ToldState& t) {
  const LiveStatus& s = t.status;
  Json json{{"type", "state"},
            {"running", s.running},
            {"busy", s.busy},
            {"failed", s.failed},
            {"frame", s.frame},
            {"time", s.time},
            {"edits", s.edits},
            {"particles", s.particles},
            {"solids", s.solids},
            {"panes", t.titles},
            {"linked", t.linked},
            {"keyboard", t.keyboard},
            {"cursor", t.cursor},
            {"fps_sim", tenths(s.fps)},
            {"fps_draw", tenths(t.fps_drawn)},
            {"pictures", {{"width", t.width}, {"height", t.height}}},
            {"recording", nullptr}};
  if (s.take)
    json.update({{"kind", s.take->kind},
                 {"name", s.take->study.name},
                 {"title", s.take->resolved.title},
                 {"dim", s.take->resolved.variants.front().scene.settings.dim},
                 {"duration", s.take->resolved.duration},
                 {"take", s.take->number},
                 {"fps", s.take->resolved.output.fps}});
  if (!t.recording_name.empty())
    json["recording"] = {{"kind", t.recording_kind}, {"name", t.recording_name}, {"frames", t.recording_frames}};
  return text_of(json);
}

} // namespace flipbook::app::live
