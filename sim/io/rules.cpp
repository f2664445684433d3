#include "sim/io/rules.h"

#include "robot/core/json_library.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/variation.h"

namespace sim::io {

using robot::Result;

namespace {

constexpr const char* kBallOut[] = {"placed_back", "set_play"};

void read_ball_out(Reader& reader, const Json& json, field::BallOut& into) {
  for (const int i : {0, 1})
    if (json == kBallOut[i]) {
      into = static_cast<field::BallOut>(i);
      return;
    }
  reader.refuse("ball_out must be \"placed_back\" or \"set_play\", got " + shown(json));
}

void read_rules(Reader& reader, const Json& json, Fields fields, field::Rules& rules) {
  if (const Json* found = reader.find(json, "field", fields)) reader.read(*found, "field", fields, rules.field);
  if (const Json* found = reader.find(json, "ball_out", fields)) read_ball_out(reader, *found, rules.ball_out);
  reader.read(json, "", fields, rules, {"name", "about", "field", "ball_out"});
}

/// Checks that goals, areas, marks and circle fit on the field.
void check(Reader& reader, const field::Field& field) {
  const auto at_most = [&](const char* name, float value, float limit) {
    if (value > limit)
      reader.refuse(std::string("field.") + name + " must be at most " + short_text(limit) +
                    " [m] on this field, got " + short_text(value));
  };
  at_most("goal_width", field.goal_width, field.width);
  at_most("goal_area_width", field.goal_area_width, field.width);
  at_most("goal_area_length", field.goal_area_length, field.length / 2);
  at_most("penalty_area_width", field.penalty_area_width, field.width);
  at_most("penalty_area_length", field.penalty_area_length, field.length / 2);
  at_most("penalty_mark", field.penalty_mark, field.length / 2);
  at_most("centre_circle_radius", field.centre_circle_radius, field.width / 2);
}

}  // namespace

Result<field::Rules> parse_rules(std::string_view text, const std::string& called, Sources* sources) {
  const Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called, sources);
  field::Rules rules{};
  for (const char* key : {"name", "about"})
    if (const auto found = json->find(key); found != json->end() && !found->is_string())
      reader.refuse(std::string(key) + " must be a text, got " + shown(*found));
  read_rules(reader, *json, Fields::all, rules);
  check(reader, rules.field);
  if (!reader.good()) return reader.error();
  return rules;
}

Result<field::Rules> load_rules(const std::string& name, Sources* sources) {
  const std::string called = "rules '" + name + "'";
  Result<Variation> variation = parse_variation(name, called);
  if (!variation) return variation.failure();
  const Result<Source> source = find_source("rules", "rules", variation->name);
  if (!source) return source.failure();
  Result<field::Rules> rules = parse_rules(source->text, source->called, sources);
  if (!rules) return rules;

  if (!variation->number.is_null()) variation->changes["players"] = variation->number;
  Reader reader(called, sources);
  read_rules(reader, variation->changes, Fields::some, *rules);
  check(reader, rules->field);
  if (!reader.good()) return reader.error();
  return rules;
}

std::string print_rules(const field::Rules& rules, const std::string& name, const Sources& sources) {
  Json json = {{"name", name}};
  json["field"] = written(rules.field, "field", sources);
  json["ball_out"] = kBallOut[static_cast<int>(rules.ball_out)];
  json.update(written(rules, "", sources));
  return printed(json);
}

}  // namespace sim::io
