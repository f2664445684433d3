#include "robot/app/forecast_report.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/strategy.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/foresight/foreseer.h"
#include "robot/foresight/scorer.h"
#include "robot/logging/sessions/read_all.h"
#include "sim/io/rules.h"

namespace robot::app {
namespace {

/// Returns the delay [s] of the referee's message about a goal: by the rules of the recorded simulation, or by the
/// newest rules if no simulation was recorded.
float goal_delay_of(const std::vector<logging::Recorded<foresight::Simulation>>& simulations) {
  const std::string rules = simulations.empty() ? foreseeing::kNewestRules : simulations.front().value.rules();
  const auto loaded = sim::io::load_rules(rules);
  return loaded ? loaded->goal_message_delay : 0;
}

}  // namespace

std::map<std::string, foresight::ForecastScore> score_forecasts(const logging::Session& session) {
  constexpr std::string_view kForecast = "/forecast";
  std::map<std::string, foresight::ForecastScore> scores;
  auto simulations = logging::read_all<foresight::Simulation>(session, memory::kSimulationTopic);
  const float goal_delay = goal_delay_of(simulations);
  std::ranges::stable_sort(simulations, {}, &logging::Recorded<foresight::Simulation>::capture_ns);
  for (const logging::StreamFile& file : session.streams) {
    if (!file.topic.ends_with(kForecast)) continue;
    const std::string robot = file.topic.substr(1, file.topic.size() - 1 - kForecast.size());
    const auto forecasts = logging::read_all<foresight::Forecast>(session, file.topic);
    auto games = logging::read_all<foresight::GameState>(session, "/" + robot + "/game");
    if (forecasts.empty() || games.empty()) continue;
    std::ranges::stable_sort(games, {}, &logging::Recorded<foresight::GameState>::capture_ns);
    foreseeing::Scorer scorer(goal_delay);
    // in the order of writing, because a choice carries the time of its question and replaces newer values
    for (const auto& strategy : logging::read_all<foresight::Strategy>(session, "/" + robot + "/strategy"))
      scorer.see(strategy.value, strategy.capture_ns);
    auto next = forecasts.begin();
    auto truth = simulations.begin();
    for (const auto& game : games) {
      for (; next != forecasts.end() && next->capture_ns < game.capture_ns; ++next)
        scorer.foretell(next->value, next->capture_ns);
      for (; truth != simulations.end() && truth->capture_ns < game.capture_ns; ++truth)
        scorer.see(truth->value, truth->capture_ns);
      scorer.see(game.value, game.capture_ns);
    }
    scores[robot] = scorer.score();
  }
  return scores;
}

}  // namespace robot::app
