#include "sim/report/race_report.h"
#include "robot/core/json_library.h"

#include <cstdio>

namespace sim::report {

using foresight::Forecast;
using foresight::Question;
using foresight::Standing;

void print_race(const Forecast& forecast, const Question& question, const std::vector<std::string>& names) {
  std::printf("%-20s%9s%18s%26s%9s%9s%10s\n", "", "futures", "value", "gain, 95 % interval", "best", "scores",
              "concedes");
  for (int i = 0; i < forecast.strategies; ++i) {
    const Standing& standing = forecast.standings[i];
    std::printf("%-20s%9d%9.3f ± %-6.3f", names[static_cast<std::size_t>(i)].c_str(), standing.rollouts, standing.mean,
                standing.error);
    if (i == 0)
      std::printf("%26s", "");
    else
      std::printf("%9.3f (%6.3f .. %6.3f)", standing.gain, standing.gain_low, standing.gain_high);
    std::printf("%7.0f %%%7.0f %%%8.0f %%\n", 100 * standing.best, 100 * standing.score, 100 * standing.concede);
  }
  std::printf("\n%s\n", foresight::reason(forecast, question, names.data()).c_str());
}

Json race_json(const Forecast& forecast, const Question& question, const std::vector<std::string>& names) {
  static constexpr const char* kAdvice[] = {"none", "keep", "change"};
  Json strategies = Json::array();
  for (int i = 0; i < forecast.strategies; ++i) {
    const Standing& standing = forecast.standings[i];
    strategies.push_back({{"strategy", names[static_cast<std::size_t>(i)]},
                          {"rollouts", standing.rollouts},
                          {"mean", standing.mean},
                          {"error", standing.error},
                          {"gain", standing.gain},
                          {"gain_low", standing.gain_low},
                          {"gain_high", standing.gain_high},
                          {"best", standing.best},
                          {"score", standing.score},
                          {"concede", standing.concede},
                          {"raced_on", standing.raced_on}});
  }
  return {{"question",
           {{"measure", foresight::kMeasureNames[static_cast<std::size_t>(question.measure)]},
            {"until", foresight::kUntilNames[static_cast<std::size_t>(question.until)]}}},
          {"advice", kAdvice[static_cast<int>(forecast.advice)]},
          {"choice", names[static_cast<std::size_t>(forecast.choice)]},
          {"reason", foresight::reason(forecast, question, names.data())},
          {"strategies", std::move(strategies)}};
}

}  // namespace sim::report
