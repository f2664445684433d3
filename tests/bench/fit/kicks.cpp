// Kicks of a kind on an empty field, planted one by one.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "robot/core/text.h"
#include "robot/fit/kicks/kicks.h"
#include "sim/statistics/sample.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/planted_kicks.h"

namespace bench {
namespace {

using nlohmann::json;

robot::fit::KickFit tracked_kicks(const robot::tests::KickedBalls& game) {
  const robot::fit::KickKind kind{.name = "forward", .ball_x = 0.18, .ball_y = 0.05, .gate_x = 0.1, .gate_y = 0.1};
  robot::fit::KickFit seen;
  seen.kind = kind.name;
  seen.slowest = std::sqrt(2 * 0.3 * 3 * kTruthError);
  for (const robot::fit::KickRun& run : game.runs) {
    const auto kick = robot::fit::tracked(game.truth, game.robot, run, kind, 0.3);
    if (const auto* good = std::get_if<robot::fit::TrackedKick>(&kick)) seen.kicks.push_back(*good);
  }
  return seen;
}

void kicked(int repetitions, double partial) {
  robot::tests::PlantedKicks planted{.truth_error = kTruthError};
  planted.model.partial = partial;
  const robot::fit::KickModel& model = planted.model;
  const std::string name =
      partial > 0 ? robot::formatted("kick, %.0f %% partial: ", 100 * partial) : std::string("kick: ");
  Planted tallies({{"kicks.forward.range", model.speed * model.speed / 0.6},
                   {"kicks.forward.range_deviation", model.range_deviation},
                   {"kicks.forward.direction", model.direction},
                   {"kicks.forward.direction_deviation", model.direction_deviation},
                   {"kicks.forward.delay", planted.delay}},
                  name);
  Planted partials({{"hits.partial", partial}}, name);
  std::vector<double> speeds, directions, covered, scores;
  for (int i = 0; i < repetitions; ++i) {
    const auto fit =
        robot::fit::fit_kind(tracked_kicks(robot::tests::kicked_balls(planted, 500 + static_cast<std::uint64_t>(i))),
                             {"planted"}, {.kinds = {}, .deceleration = 0.3, .spread = planted.spread});
    if (!fit) continue;
    tallies.add(fit->figures);
    partials.add({fit->partial});
    speeds.push_back(100 * std::abs(fit->model.speed / model.speed - 1));
    directions.push_back(std::abs(fit->model.direction - model.direction) * 180 / 3.14159265);
    covered.push_back(100 * fit->covered);
    scores.push_back(fit->crps / fit->constant_error);
  }
  std::cout << json{{"case", "kicks"},
                    {"partial", partial},
                    {"repetitions", speeds.size()},
                    {"speed_percent", sim::statistics::quantile(speeds, 0.95)},
                    {"direction_degrees", sim::statistics::quantile(directions, 0.95)},
                    {"covered_percent", sim::statistics::mean_of(covered)},
                    {"crps_share", sim::statistics::mean_of(scores)}}
                   .dump()
            << std::endl;
  tallies.print();
  if (partial > 0) partials.print();
}

}  // namespace

void kicks(int repetitions) { kicked(repetitions, 0); }

void partial_kicks(int repetitions) { kicked(repetitions, 0.6); }

}  // namespace bench
