#include "sim/report/game_line.h"

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/match/hash.h"
#include "sim/report/census.h"
#include "sim/report/game_report.h"

namespace sim::report {
namespace {

using Kind = referee::Event::Kind;

double seconds(Tick ticks) { return static_cast<double>(ticks) / kTicksPerSecond; }

bool is_out(Kind kind) {
  return kind == Kind::out || kind == Kind::kick_in || kind == Kind::goal_kick || kind == Kind::corner_kick;
}

/// Returns how many set plays of each kind ended by a kick, and how many because their time was up.
Json set_plays(const Result& result) {
  Json json;
  for (int kind = 1; kind < kSetPlays; ++kind)
    json[agent::kSetPlayWords[kind]] = {{"taken", result.taken[kind][0] + result.taken[kind][1]},
                                        {"expired", result.expired[kind][0] + result.expired[kind][1]}};
  return json;
}

}  // namespace

GameLine game_line(const Params& params, std::uint64_t seed, bool shoot_out) {
  GameReport report{.seed = seed};
  referee::Events opening;
  State state = begin(params, {.seed = seed}, opening);
  Census census;
  Json first_goal;
  int outs = 0;
  Result decided{};
  play(
      params, state,
      [&](const State& now) {
        census.look(now);
        return false;
      },
      [&](const referee::Event& event) {
        decided.count(event);
        if (is_out(event.kind)) ++outs;
        if (event.kind == Kind::goal && first_goal.is_null()) first_goal = seconds(event.tick);
      });
  report.result = result_of(state, decided);
  if (shoot_out && state.book.score[0] == state.book.score[1])
    report.shoot_out = play_shoot_out(params, {.seed = seed});

  Json json = to_json(report, params.rules.players);
  json.erase("events");  // there are hundreds
  json["first_goal_seconds"] = first_goal;
  json["out"] = outs;
  json["set_plays"] = set_plays(report.result);
  json["home"].update(census.of(Side::home));
  json["away"].update(census.of(Side::away));
  json["seen"] = Json::array();
  for_each_robot(params.rules.players, [&](int robot) {
    json["seen"].push_back(seconds(state.counts.seen[robot]) / seconds(std::max<Tick>(1, state.counts.in_play)));
  });
  return {.text = json.dump() + "\n", .hash = hash_of_game(state)};
}

}  // namespace sim::report
