#include "sim/report/game_line.h"

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/match/hash.h"
#include "sim/report/game_report.h"

namespace sim::report {
namespace {

using Kind = referee::Event::Kind;

double seconds(Tick ticks) { return static_cast<double>(ticks) / kTicksPerSecond; }

/// Returns how many set plays of each kind ended by a kick, and how many because their time was up.
Json set_plays(const Result& result) {
  Json json;
  for (int kind = 1; kind < kSetPlays; ++kind)
    json[agent::kSetPlayWords[kind]] = {{"taken", result.taken[kind][0] + result.taken[kind][1]},
                                        {"expired", result.expired[kind][0] + result.expired[kind][1]}};
  return json;
}

}  // namespace

LineGame::LineGame(const Params& params, std::uint64_t seed) : seed_(seed) {
  referee::Events opening;
  state = begin(params, {.seed = seed}, opening);
}

bool LineGame::goes_on() {
  census_.look(state);
  return true;
}

void LineGame::see(const referee::Events& events) {
  for (const referee::Event& event : events) {
    decided_.count(event);
    if (referee::is_out(event.kind)) ++outs_;
    if (event.kind == Kind::goal && !first_goal_) first_goal_ = event.tick;
  }
}

GameLine LineGame::line(const Params& params, bool shoot_out) const {
  GameReport report{.seed = seed_};
  report.result = result_of(state, decided_);
  if (shoot_out && state.book.score[0] == state.book.score[1])
    report.shoot_out = play_shoot_out(params, {.seed = seed_});

  Json json = to_json(report, params.rules.players);
  json.erase("events");  // there are hundreds
  json["first_goal_seconds"] = first_goal_ ? Json(seconds(*first_goal_)) : Json();
  json["out"] = outs_;
  json["set_plays"] = set_plays(report.result);
  json["home"].update(census_.of(Side::home));
  json["away"].update(census_.of(Side::away));
  json["seen"] = Json::array();
  for_each_robot(params.rules.players, [&](int robot) {
    json["seen"].push_back(seconds(state.counts.seen[robot]) / seconds(std::max<Tick>(1, state.counts.in_play)));
  });
  return {.text = json.dump() + "\n", .hash = hash_of_game(state)};
}

}  // namespace sim::report
