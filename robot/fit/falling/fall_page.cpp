#include "robot/fit/falling/fall_page.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "robot/core/text.h"

namespace robot::fit {

double sum_over(const std::vector<FallRisk>& robots, double FallRisk::*time) {
  double sum = 0;
  for (const FallRisk& robot : robots) sum += robot.*time;
  return sum;
}

std::size_t falls_of(const std::vector<FallRisk>& robots) {
  std::size_t count = 0;
  for (const FallRisk& robot : robots) count += robot.falls.size();
  return count;
}

Picture picture_of_rates(const FallsSeen& seen, const FallRates& rates) {
  Mark robots{.role = Mark::Role::truth, .label = "a robot", .x = {}, .y = {}, .high = {}};
  Mark expected{.shape = Mark::Shape::line,
                .role = Mark::Role::fitted,
                .label = "as many as expected",
                .x = {0},
                .y = {0},
                .high = {}};
  double most = 1;
  for (const FallRisk& robot : seen.robots) {
    robots.x.push_back(rates.walking.value * robot.walking + rates.touching.value * rates.contact * robot.touching);
    robots.y.push_back(static_cast<double>(robot.falls.size()));
    most = std::max({most, robots.x.back() + 0.5, robots.y.back() + 0.5});
  }
  expected.x.push_back(most), expected.y.push_back(most);
  return {.title = "Falls of each robot over those that its time at risk lets expect",
          .x_label = "expected falls",
          .y_label = "falls",
          .axes = {.left = 0, .right = most, .bottom = 0, .top = most},
          .marks = {std::move(expected), std::move(robots)}};
}

Picture picture_of_times(const std::vector<double>& times, const std::optional<GroundTime>& model, double usual) {
  const double most = std::min(30., std::max(2 * usual, 1.1 * std::ranges::max(times))), width = most / 30;
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "falls",
            .x = {},
            .y = {},
            .high = {},
            .width = width};
  for (int i = 0; i < 30; ++i) {
    const double from = i * width;
    bars.x.push_back(from);
    bars.y.push_back(static_cast<double>(
        std::ranges::count_if(times, [&](double time) { return time >= from && time < from + width; })));
  }
  const double top = std::max(1., 1.1 * std::ranges::max(bars.y));
  Mark before{.shape = Mark::Shape::line,
              .role = Mark::Role::other,
              .label = "one attempt of the models",
              .x = {usual, usual},
              .y = {0, top},
              .high = {}};
  Picture picture{.title = "Time on the ground",
                  .x_label = "time on the ground [s]",
                  .y_label = "falls",
                  .axes = {.left = 0, .right = most, .bottom = 0, .top = top},
                  .marks = {std::move(bars), std::move(before)}};
  if (!model) return picture;
  Mark line{.shape = Mark::Shape::line, .role = Mark::Role::fitted, .label = "fitted", .x = {}, .y = {}, .high = {}};
  for (int i = 0; i <= 300; ++i) {
    line.x.push_back(most * i / 300);
    line.y.push_back(std::min(top, width * static_cast<double>(times.size()) * density_of(*model, line.x.back())));
  }
  picture.marks.push_back(std::move(line));
  return picture;
}

Table table_of_falls(const FallsSeen& seen) {
  Table table{
      .columns = {"time [s]", "walking", "touching", "time on the ground [s]"}, .names = seen.recordings, .rows = {}};
  for (const FallRisk& robot : seen.robots)
    for (const TrueFall& fall : robot.falls)
      table.rows.push_back(
          {.recording = robot.recording,
           .values = {fall.at, fall.walking ? 1. : 0., fall.touching ? 1. : 0., fall.down.value_or(NAN)}});
  return table;
}

Results fall_results(const FallsSeen& seen) {
  Results results{.title = "Falls of each recording",
                  .head = {"recording", "robots", "walking [min]", "contact [s]", "falls"},
                  .rows = {}};
  for (std::size_t i = 0; i < seen.recordings.size(); ++i) {
    std::vector<FallRisk> robots;
    std::ranges::copy_if(seen.robots, std::back_inserter(robots),
                         [&](const FallRisk& robot) { return robot.recording == i; });
    results.rows.push_back({seen.recordings[i], formatted("%zu", robots.size()),
                            formatted("%.1f", sum_over(robots, &FallRisk::walking) / 60),
                            formatted("%.0f", sum_over(robots, &FallRisk::touching)),
                            formatted("%zu", falls_of(robots))});
  }
  return results;
}

}  // namespace robot::fit
