#include "sim/statistics/crowd.h"

#include <algorithm>
#include <limits>

#include "sim/statistics/sample.h"

namespace sim::statistics {
namespace {

constexpr std::size_t kStride = 10;  // [frames]
constexpr std::size_t kFewest = 3;   // robots of a side whose distances mean something
constexpr double kClose = 0.5;       // [m]
constexpr double kFar = std::numeric_limits<double>::infinity();

/// The robots seen in one frame.
struct Seen {
  std::vector<Vec2> all, of_side[2], field_players[2];
};

Seen seen_in(const Window& window, std::size_t frame) {
  Seen seen;
  for (const Robot& robot : window.robots) {
    if (!robot.frames[frame]) continue;
    const Vec2 place = robot.frames[frame]->position;
    seen.all.push_back(place);
    seen.of_side[robot.side].push_back(place);
    if (robot.player != 1) seen.field_players[robot.side].push_back(place);
  }
  return seen;
}

/// Returns the distances from `ball` [m], ascending.
std::vector<double> distances(Vec2 ball, const std::vector<Vec2>& robots) {
  std::vector<double> all;
  for (const Vec2 robot : robots) all.push_back(static_cast<double>(distance(ball, robot)));
  std::ranges::sort(all);
  return all;
}

double at_or_far(const std::vector<double>& ascending, std::size_t place) {
  return place < ascending.size() ? ascending[place] : kFar;
}

double mean_distance(const std::vector<Vec2>& robots) {
  std::vector<double> all;
  for (std::size_t i = 0; i < robots.size(); ++i)
    for (std::size_t j = i + 1; j < robots.size(); ++j)
      all.push_back(static_cast<double>(distance(robots[i], robots[j])));
  return mean_of(all);
}

template <class Of>
double extent(const std::vector<Vec2>& robots, Of&& coordinate) {
  const auto [least, most] = std::ranges::minmax(robots, {}, coordinate);
  return static_cast<double>(coordinate(most) - coordinate(least));
}

}  // namespace

NearBall near_ball(const Window& window, const Path& smooth) {
  std::vector<double> nearest, second, third;
  Share nobody, both_60cm, both_1m;
  for (std::size_t frame = 0; frame < smooth.size(); ++frame) {
    if (!smooth[frame]) continue;
    const Seen seen = seen_in(window, frame);
    const std::vector<double> all = distances(*smooth[frame], seen.all);
    nearest.push_back(at_or_far(all, 0)), second.push_back(at_or_far(all, 1)), third.push_back(at_or_far(all, 2));
    nobody.add(nearest.back() > 1);
    const double farther = std::max(at_or_far(distances(*smooth[frame], seen.of_side[0]), 0),
                                    at_or_far(distances(*smooth[frame], seen.of_side[1]), 0));
    both_60cm.add(farther < 0.6), both_1m.add(farther < 1);
  }
  return {.nearest = median(std::move(nearest)),
          .second = median(std::move(second)),
          .third = median(std::move(third)),
          .nobody_1m = nobody.value(),
          .both_60cm = both_60cm.value(),
          .both_1m = both_1m.value()};
}

Room room_between(const Window& window) {
  std::vector<double> mates, extents_x, extents_y;
  Share close;
  for (std::size_t frame = 0; frame < window.size(); frame += kStride) {
    const Seen seen = seen_in(window, frame);
    for (const Vec2 robot : seen.all) close.add(at_or_far(distances(robot, seen.all), 1) < kClose);
    for (const int side : {0, 1}) {
      if (seen.of_side[side].size() >= kFewest) mates.push_back(mean_distance(seen.of_side[side]));
      const std::vector<Vec2>& field_players = seen.field_players[side];
      if (field_players.size() < kFewest) continue;
      extents_x.push_back(extent(field_players, [](Vec2 place) { return place.x; }));
      extents_y.push_back(extent(field_players, [](Vec2 place) { return place.y; }));
    }
  }
  return {
      .mates = mean_of(mates), .close = close.value(), .extent_x = mean_of(extents_x), .extent_y = mean_of(extents_y)};
}

}  // namespace sim::statistics
