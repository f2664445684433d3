#include "sim/io/models.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/fall_table.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/variation.h"
#include "sim/motion/motion.h"

namespace sim::io {

using robot::Error;
using robot::Result;

namespace {

constexpr int kMostBases = 8;  // files in a chain of "based_on"
constexpr std::string_view kHead[] = {"name", "about", "based_on"};

/// Calls see(name, struct) for each section but the kicks.
template <class AnyModels, class See>
void visit_sections(AnyModels& models, See&& see) {
  see("effects", models.effects);
  see("ball", models.ball);
  see("contact", models.contact);
  see("walk", models.motion.walk);
  see("head", models.motion.head);
  see("hits", models.motion.hits);
  see("squat", models.motion.squat);
  see("falls", models.motion.falls);
  see("camera", models.perception.camera);
  see("ball_detection", models.perception.ball);
  see("robot_detection", models.perception.robots);
  see("noise", models.perception.noise);
  see("ball_filter", models.perception.filter);
  see("localisation", models.perception.localisation);
  see("radio", models.perception.radio);
}

/// Reads the falls: numbers, and perhaps a table.
void read_section(Reader& reader, const Json& json, const char* name, Fields fields, motion::Falls& falls) {
  reader.read(json, name, fields, falls, {"table"});
  if (!json.is_object()) return;
  if (const auto table = json.find("table"); table != json.end())
    read_fall_table(reader, *table, Reader::below(name, "table"), falls.table);
  if (fields == Fields::all || !falls.table.given) return;
  for (const char* other : {"per_minute_walking", "per_second_touching", "lying", "getting_up", "failure"})
    if (json.contains(other))
      reader.refuse(Reader::below(name, other) +
                    " is not played with a table of falls; leave that out with falls.table=off");
}

template <class Section>
void read_section(Reader& reader, const Json& json, const char* name, Fields fields, Section& section) {
  reader.read(json, name, fields, section);
}

/// Removes a kick of the base.
void remove_kick(Reader& reader, const std::string& name, motion::Model& model) {
  const int known = motion::find_kick(model, name);
  if (known < 0) return reader.refuse("kicks: there is no '" + name + "' to remove");
  std::copy(model.kicks + known + 1, model.kicks + model.kick_count, model.kicks + known);
  --model.kick_count;
}

/// Changes the known kicks, appends the others and removes those that are false.
void read_kicks(Reader& reader, const Json& kicks, motion::Model& model) {
  if (!reader.is_object(kicks, "kicks")) return;
  for (const auto& [name, kick] : kicks.items()) {
    if (kick == false) {
      remove_kick(reader, name, model);
      continue;
    }
    const int known = motion::find_kick(model, name);
    const int index = known < 0 ? model.kick_count : known;
    motion::Kick& into = model.kicks[std::min(index, motion::kMaxKicks - 1)];
    if (index == motion::kMaxKicks)
      return reader.refuse("kicks: expected at most " + std::to_string(motion::kMaxKicks) + ", got one more: '" + name +
                           "'");
    if (name.empty() || name.size() >= sizeof into.name)
      return reader.refuse("kicks: a name must have 1 .. " + std::to_string(sizeof into.name - 1) + " bytes, got '" +
                           name + "'");
    reader.read(kick, "kicks." + name, known < 0 ? Fields::all : Fields::some, into);
    std::memset(into.name, 0, sizeof into.name);
    std::memcpy(into.name, name.data(), name.size());
    model.kick_count = std::max(model.kick_count, index + 1);
  }
  if (model.kick_count == 0) reader.refuse("kicks: expected at least one, got none");
}

/// Reads over `models`, which hold the base of the description. Without a base all fields must be present.
void read_models(Reader& reader, const Json& json, Fields fields, Models& models) {
  std::vector<std::string_view> known(std::begin(kHead), std::end(kHead));
  visit_sections(models, [&](const char* name, auto& section) {
    known.push_back(name);
    if (const Json* found = reader.find(json, name, fields)) read_section(reader, *found, name, fields, section);
  });
  known.push_back("kicks");
  if (const Json* kicks = reader.find(json, "kicks", fields)) read_kicks(reader, *kicks, models.motion);
  reader.refuse_unknown(json, "", known);
}

Result<Models> parse_upon(std::string_view text, const std::string& called, Sources* sources, int bases) {
  Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called, sources);
  Models models{};
  const std::string based_on = reader.text(*json, "", "based_on");
  if (!based_on.empty()) {
    if (bases == kMostBases)
      return Error{called + ": based_on leads through more than 8 files, or back to the same file"};
    const Result<Source> source = find_source("models", "models", based_on);
    if (!source) return source.failure(called + ": based_on");
    Result<Models> base = parse_upon(source->text, source->called, sources, bases + 1);
    if (!base) return base;
    models = std::move(*base);
  }
  models.name = reader.text(*json, "", "name");
  if (models.name.empty()) reader.refuse("name is missing");
  reader.text(*json, "", "about");
  read_models(reader, *json, based_on.empty() ? Fields::all : Fields::some, models);
  if (!reader.good()) return reader.error();
  return models;
}

/// Moves entries without a section to the section "effects".
Json with_effects_below(const Json& changes) {
  Json sorted = Json::object();
  for (const auto& [name, value] : changes.items())
    if (value.is_object())
      sorted[name].update(value);
    else
      sorted["effects"][name] = value;
  return sorted;
}

/// Splits "match+3=perfect" into "match" and "3=perfect".
std::vector<std::string> split_single(std::string_view name) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t i = 0; i + 2 < name.size(); ++i)
    if (name[i] == '+' && name[i + 1] >= '0' && name[i + 1] <= '9' && name[i + 2] == '=') {
      parts.emplace_back(name.substr(from, i - from));
      from = i + 1;
    }
  parts.emplace_back(name.substr(from));
  return parts;
}

}  // namespace

Result<Models> parse_models(std::string_view text, const std::string& called, Sources* sources) {
  return parse_upon(text, called, sources, 0);
}

Result<Models> load_models(const std::string& name, Sources* sources) {
  const std::string called = "models '" + name + "'";
  const Result<Variation> variation = parse_variation(name, called);
  if (!variation) return variation.failure();
  if (!variation->number.is_null()) return Error{called + ": models take no number behind a colon"};
  const Result<Source> source = find_source("models", "models", variation->name);
  if (!source) return source.failure();
  Result<Models> models = parse_models(source->text, source->called, sources);
  if (!models || variation->changes.empty()) return models;

  Reader reader(called, sources);
  read_models(reader, with_effects_below(variation->changes), Fields::some, *models);
  const auto falls = variation->changes.find("falls");
  const bool changes_table = falls != variation->changes.end() && falls->contains("table");
  if (changes_table && models->motion.falls.table.given && !models->effects.falls)
    reader.refuse("falls.table is not played while the effect falls is off; switch it on with effects.falls=on");
  if (!reader.good()) return reader.error();
  models->name += name.substr(variation->name.size());
  return models;
}

Result<void> load_team_models(const std::string& name, int players, Team& team) {
  const std::string called = "models '" + name + "'";
  const std::vector<std::string> parts = split_single(name);
  Result<Models> all = load_models(parts.front());
  if (!all) return all.failure();
  team.models = std::move(*all);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const int player = parts[i].front() - '0';
    if (player < 1 || player > players)
      return Error{called + ": the player before '=' must be 1 .. " + std::to_string(players) + ", got " +
                   std::to_string(player)};
    std::shared_ptr<const Models>& single = team.single[player - 1];
    if (single) return Error{called + ": player " + std::to_string(player) + " has models twice"};
    Result<Models> own = load_models(parts[i].substr(2));
    if (!own) return own.failure();
    team.models.name += "+" + parts[i].substr(0, 2) + own->name;
    single = std::make_shared<const Models>(std::move(*own));
  }
  return {};
}

std::vector<std::string> names_of_models(const std::string& name) {
  std::vector<std::string> names = split_single(name);
  for (std::size_t i = 1; i < names.size(); ++i) names[i].erase(0, 2);
  return names;
}

std::vector<std::string> names_of_falls(const std::string& name) {
  constexpr std::string_view kChange = "falls.table=";
  std::vector<std::string> names;
  for (const std::string_view part : robot::split(name, ","))
    if (part.starts_with(kChange)) names.emplace_back(part.substr(kChange.size(), part.find('+') - kChange.size()));
  return names;
}

std::string with_falls(const std::string& name, const std::string& table) {
  std::string all;
  for (const std::string& part : split_single(name))
    all.append(all.empty() ? "" : "+").append(part).append(",falls.table=").append(table);
  return all;
}

std::string print_models(const Models& models, const Sources& sources) {
  Json json = {{"name", models.name}};
  visit_sections(models, [&](const char* name, const auto& section) { json[name] = written(section, name, sources); });
  if (const motion::FallTable& table = models.motion.falls.table; table.given)
    json["falls"]["table"] = written_fall_table(table, "falls.table", sources);
  Json& kicks = json["kicks"] = Json::object();
  for (int i = 0; i < models.motion.kick_count; ++i) {
    const motion::Kick& kick = models.motion.kicks[i];
    kicks[kick.name] = written(kick, "kicks." + std::string(kick.name), sources);
  }
  return printed(json);
}

}  // namespace sim::io
