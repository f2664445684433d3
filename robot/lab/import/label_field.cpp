#include "robot/lab/import/label_field.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace robot::lab::labels {
namespace {

constexpr double kBetweenGoalkeepers = 8.5;  // [m] on a field of 9 m
constexpr std::size_t kFewestSights = 50;    // of a goalkeeper

/// Returns the median place of a team's goalkeeper before the camera.
Result<Ground> goalkeeper_of(int team, const Camera& camera, const std::vector<Frame>& frames, const Teams& teams) {
  std::vector<double> x, y;
  for (const Frame& frame : frames)
    for (const RobotBox& robot : frame.robots) {
      if (robot.number != 1 || team_of(robot, teams) != team) continue;
      const Ground place = camera.at(robot.box.middle(), robot.box.bottom);
      x.push_back(place.x), y.push_back(place.y);
    }
  if (x.size() < kFewestSights)
    return Error{"the field: expected at least 50 boxes of the goalkeeper with number 1 and colour " +
                 std::to_string(teams[static_cast<std::size_t>(team)]) + ", got " + std::to_string(x.size())};
  return Ground{.x = median(std::move(x)), .y = median(std::move(y))};
}

}  // namespace

Result<Teams> teams_of(const std::vector<Frame>& frames) {
  std::map<int, int> boxes;
  for (const Frame& frame : frames)
    for (const RobotBox& robot : frame.robots)
      if (robot.colour >= 0) ++boxes[robot.colour];
  if (boxes.size() < 2) return Error{"the teams: expected jerseys of two colours, got " + std::to_string(boxes.size())};
  std::vector<std::pair<int, int>> by_count(boxes.begin(), boxes.end());
  std::ranges::stable_sort(by_count, std::greater<>(), &std::pair<int, int>::second);
  return Teams{std::min(by_count[0].first, by_count[1].first), std::max(by_count[0].first, by_count[1].first)};
}

int team_of(const RobotBox& robot, const Teams& teams) {
  return robot.colour == teams[0] ? 0 : robot.colour == teams[1] ? 1 : -1;
}

Ground FieldView::at(double x_px, double y_px, double above) const {
  const Ground seen = camera.at(x_px, y_px, above);
  const double x = seen.x - middle.x, y = seen.y - middle.y;
  return {.x = scale * (ahead_x * x + ahead_y * y), .y = scale * (ahead_x * y - ahead_y * x)};
}

Result<FieldView> find_field(const Camera& camera, const std::vector<Frame>& frames, const Teams& teams) {
  const auto first = goalkeeper_of(0, camera, frames, teams), second = goalkeeper_of(1, camera, frames, teams);
  if (!first) return first.failure();
  if (!second) return second.failure();
  const double x = second->x - first->x, y = second->y - first->y, apart = std::hypot(x, y);
  if (!(apart > 1)) return Error{"the field: the goalkeepers are less than 1 m apart"};
  return FieldView{.camera = camera,
                   .middle = {.x = (first->x + second->x) / 2, .y = (first->y + second->y) / 2},
                   .ahead_x = x / apart,
                   .ahead_y = y / apart,
                   .scale = kBetweenGoalkeepers / apart};
}

}  // namespace robot::lab::labels
