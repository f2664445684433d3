#include "sim/drills/drill.h"

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/check/words.h"
#include "sim/drills/starts.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"

namespace sim::drills {

using io::Fields;
using io::Json;
using io::Reader;
using io::shown;
using robot::Error;
using robot::Result;

namespace {

constexpr std::size_t kMostPoints = 32;

struct Numbers {
  float seconds = 20;
  int players = 0;
  bool ball_known = true;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("seconds", self.seconds, "", 0.1f, 3600.f);
    see("players", self.players, "", 0, kMaxPlayers);
    see("ball_known", self.ball_known, "", false, true);
  }
};

/// Reads a condition that comes true in some tick.
void read_condition(Reader& reader, const Json& json, const char* key, check::Condition& into) {
  const std::string text = reader.text(json, "", key);
  if (!reader.good() || !json.contains(key)) return;
  Result<check::Condition> condition = check::parse_condition(text);
  if (!condition) return reader.refuse(std::string(key) + ": " + condition.error());
  for (const auto& clauses : condition->alternatives)
    if (std::ranges::any_of(clauses, [](const check::Clause& clause) { return clause.always || clause.negated; }))
      return reader.refuse(std::string(key) + " must come true in some tick, without 'always', 'never' and 'not'");
  into = *std::move(condition);
}

/// Reads an object of points by a text that `take` understands. Calls see(what it took, points).
template <class Take, class See>
void read_points(Reader& reader, const Json& json, const char* key, Take&& take, See&& see) {
  const Json* found = reader.find(json, key, Fields::some);
  if (!found || !reader.is_object(*found, key)) return;
  if (found->size() > kMostPoints)
    return reader.refuse(std::string(key) + " must have at most 32 entries, got " + std::to_string(found->size()));
  for (const auto& [text, points] : found->items()) {
    const std::string path = Reader::below(key, text);
    const double value = points.is_number() ? points.template get<double>() : 1e9;
    if (!(value >= -1000 && value <= 1000))
      return reader.refuse(path + " must be points from -1000 to 1000, got " + shown(points));
    if (text.size() > check::kMaxConditionBytes) return reader.refuse(path + " is too long");
    check::Words words(text);
    const auto taken = take(words);
    if (!taken) return reader.refuse(path + ": " + taken.error());
    if (!words.at_end()) return reader.refuse(path + ": expected nothing behind it, got " + io::quoted(words.rest()));
    see(*taken, static_cast<float>(value));
  }
}

/// Replaces the ranges of an object by their least or greatest values.
void take_ends(Reader& reader, Json& object, const std::string& path, bool most) {
  if (!object.is_object()) return;
  for (auto& [key, value] : object.items()) {
    if (!value.is_array()) continue;
    const bool is_range = value.size() == 2 && value[0].is_number() && value[1].is_number() && value[0] <= value[1];
    if (!is_range) return reader.refuse(Reader::below(path, key) + " must be [least, most], got " + shown(value));
    value = Json(value[most ? 1 : 0]);
  }
}

/// Returns the situation with all ranges at one end.
std::string end_of(Reader& reader, Json start, bool most) {
  if (start.contains("ball")) take_ends(reader, start["ball"], "start.ball", most);
  if (start.contains("robots") && start["robots"].is_array())
    for (std::size_t i = 0; i < start["robots"].size(); ++i)
      take_ends(reader, start["robots"][i], "start.robots[" + std::to_string(i) + "]", most);
  return start.dump();
}

void read_game(Reader& reader, const Json& json, Drill& drill) {
  Numbers numbers;
  reader.read(
      json, "", Fields::some, numbers,
      {"about", "home", "away", "rules", "models", "start", "success", "failure", "time_over", "score", "progress"});
  drill.about = reader.text(json, "", "about", drill.about);
  drill.game.strategies[0] = reader.text(json, "", "home", drill.game.strategies[0]);
  drill.game.strategies[1] = reader.text(json, "", "away", drill.game.strategies[1]);
  drill.game.rules = reader.text(json, "", "rules", drill.game.rules);
  const std::string models = reader.text(json, "", "models", "match");
  const std::string time_over = reader.text(json, "", "time_over", "failure");
  if (time_over != "failure" && time_over != "success")
    reader.refuse("time_over must be failure or success, got " + io::quoted(time_over));
  drill.game.models[0] = drill.game.models[1] = models;
  drill.game.players = numbers.players;
  drill.duration = ticks(numbers.seconds);
  drill.ball_known = numbers.ball_known;
  drill.time_is_success = time_over == "success";
}

}  // namespace

Result<Drill> parse_drill(std::string_view text, const std::string& called) {
  if (text.size() > io::kMaxFileBytes)
    return Error{called + ": must have at most " + std::to_string(io::kMaxFileBytes) + " bytes, got " +
                 std::to_string(text.size())};
  const Result<Json> json = io::parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called);
  Drill drill;
  read_game(reader, *json, drill);
  for (const char* key : {"start", "seconds", "success"})
    if (!json->contains(key)) reader.refuse(std::string(key) + " is missing");
  read_condition(reader, *json, "success", drill.success);
  read_condition(reader, *json, "failure", drill.failure);
  read_points(
      reader, *json, "score", [](check::Words& words) { return check::take_fact(words); },
      [&](const check::Fact& fact, float points) {
        drill.score.push_back({fact, points});
      });
  read_points(
      reader, *json, "progress", [](check::Words& words) { return check::take_quantity(words); },
      [&](int quantity, float points) {
        drill.progress.push_back({quantity, points});
      });
  if (const auto start = json->find("start"); start != json->end() && reader.is_object(*start, "start")) {
    drill.least = end_of(reader, *start, false);
    drill.most = end_of(reader, *start, true);
  }
  if (!reader.good()) return reader.error();
  return drill;
}

Result<Drill> load_drill(const std::string& name) {
  const Result<io::Source> source = io::find_source("drills", "drill", name);
  if (!source) return source.failure();
  Result<Drill> drill = parse_drill(source->text, source->called);
  if (!drill) return drill.failure();
  drill->name = name;
  const auto game = io::prepare(drill->game);
  if (!game) return game.failure(source->called);
  if (const auto starts = Starts::prepare(*drill, game->params); !starts) return starts.failure();
  return drill;
}

}  // namespace sim::drills
