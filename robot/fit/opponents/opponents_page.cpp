#include "robot/fit/opponents/opponents_page.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "sim/statistics/sample.h"

namespace robot::fit {

std::size_t walking_speeds(const std::vector<double>& speeds) {
  return static_cast<std::size_t>(std::ranges::count_if(speeds, [](double speed) { return speed > kWalksFrom; }));
}

Picture picture_of_speeds(const std::vector<double>& speeds, double fast, double usual) {
  constexpr double kBar = 0.02, kEnd = 0.6;  // [m/s]
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "robots that walk",
            .x = {},
            .y = {},
            .high = {},
            .width = kBar};
  const auto walking = static_cast<double>(std::max<std::size_t>(1, walking_speeds(speeds)));
  for (int i = 0; i < 30; ++i) bars.x.push_back(i * kBar), bars.y.push_back(0);
  for (const double speed : speeds)
    if (speed > kWalksFrom && speed < kEnd) bars.y[static_cast<std::size_t>(speed / kBar)] += 100 / walking;
  const double top = std::max(1., 1.1 * std::ranges::max(bars.y));
  const auto line = [&](Mark::Role role, const char* label, double x) {
    return Mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = {x, x}, .y = {0, top}, .high = {}};
  };
  return {.title = "Speeds of robots that walk",
          .x_label = "displacement in a second [m/s]",
          .y_label = "share [%]",
          .axes = {.left = 0, .right = kEnd, .bottom = 0, .top = top},
          .marks = {std::move(bars), line(Mark::Role::other, "walk.forward of the models", usual),
                    line(Mark::Role::fitted, "99 % of all robots are slower", fast)}};
}

Results results_of_teams(const OpponentsSeen& seen) {
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> teams;  // speeds, kicks
  for (const SeenWalk& walk : seen.walks) {
    auto& speeds = teams[walk.team].first;
    speeds.insert(speeds.end(), walk.speeds.begin(), walk.speeds.end());
  }
  for (const SeenKick& kick : seen.kicks) teams[kick.team].second.push_back(kick.speed);
  Results results{.title = "Each team",
                  .head = {"team", "walking [min]", "median [m/s]", "99 % [m/s]", "kicks", "median kick [m/s]"},
                  .rows = {}};
  for (const auto& [team, values] : teams) {
    std::vector<double> walking;
    std::ranges::copy_if(values.first, std::back_inserter(walking), [](double speed) { return speed > kWalksFrom; });
    const auto text = [](std::vector<double> list, double share) {
      return list.empty() ? std::string("-") : formatted("%.2f", sim::statistics::quantile(std::move(list), share));
    };
    results.rows.push_back({team.empty() ? "not identified" : team,
                            formatted("%.1f", static_cast<double>(walking.size()) / 600), text(walking, 0.5),
                            text(values.first, 0.99), formatted("%zu", values.second.size()),
                            text(values.second, 0.5)});
  }
  return results;
}

Picture picture_of_kicks(const std::vector<SeenKick>& kicks, double middle) {
  constexpr double kBar = 0.1, kEnd = 3;  // [m/s]
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "kicks",
            .x = {},
            .y = {},
            .high = {},
            .width = kBar};
  for (int i = 0; i < 30; ++i) bars.x.push_back(i * kBar), bars.y.push_back(0);
  for (const SeenKick& kick : kicks)
    if (kick.speed < kEnd) bars.y[static_cast<std::size_t>(kick.speed / kBar)] += 1;
  const double top = 1.1 * std::max(1., std::ranges::max(bars.y));
  Mark line{.shape = Mark::Shape::line,
            .role = Mark::Role::fitted,
            .label = "median",
            .x = {middle, middle},
            .y = {0, top},
            .high = {}};
  return {.title = "Speeds of kicks",
          .x_label = "speed of the ball after a kick [m/s]",
          .y_label = "kicks",
          .axes = {.left = 0, .right = kEnd, .bottom = 0, .top = top},
          .marks = {std::move(bars), std::move(line)}};
}

Table table_of_kicks(const OpponentsSeen& seen) {
  Table table{.columns = {"time [s]", "speed [m/s]", "reach [m]"}, .names = seen.recordings, .rows = {}};
  for (const SeenKick& kick : seen.kicks)
    table.rows.push_back({.recording = kick.recording, .values = {kick.at, kick.speed, kick.reach}});
  return table;
}

Table table_of_walks(const OpponentsSeen& seen) {
  Table table{.columns = {"seen [s]", "walking [s]", "99 % of its speeds [m/s]"}, .names = seen.recordings, .rows = {}};
  for (const SeenWalk& walk : seen.walks)
    table.rows.push_back(
        {.recording = walk.recording,
         .values = {static_cast<double>(walk.speeds.size()) / 10, static_cast<double>(walking_speeds(walk.speeds)) / 10,
                    sim::statistics::quantile(walk.speeds, 0.99)}});
  return table;
}

}  // namespace robot::fit
