#include "sim/report/futures_report.h"

#include <vector>

#include "robot/core/json_library.h"

namespace sim::report {
namespace {

double seconds_of(Tick length) { return static_cast<double>(length) / kTicksPerSecond; }

Json effect_json(const debug::Effect& effect) {
  return {{"without", effect.without}, {"with", effect.with}, {"low", effect.low}, {"high", effect.high}};
}

Json points_json(const std::vector<Vec2>& points) {
  Json all = Json::array();
  for (const Vec2 point : points) all.insert(all.end(), {point.x, point.y});
  return all;
}

Json paths_json(const std::vector<debug::FuturePath>& paths) {
  Json all = Json::array();
  for (const debug::FuturePath& path : paths)
    all.push_back({{"ball", points_json(path.ball)}, {"robot", points_json(path.robot)}});
  return all;
}

}  // namespace

Json to_json(const debug::Futures& futures, Tick length) {
  Json parting;
  if (futures.parting) parting = {{"seconds", seconds_of(*futures.parting - futures.begin)}, {"field", futures.field}};
  return {{"pairs", futures.count},
          {"different", futures.different},
          {"seconds", seconds_of(length)},
          {"scores", effect_json(futures.scores)},
          {"concedes", effect_json(futures.concedes)},
          {"goals", effect_json(futures.goals)},
          {"parting", parting},
          {"spacing", seconds_of(debug::FuturePath::kSpacing)},
          {"paths", {{"without", paths_json(futures.paths_without)}, {"with", paths_json(futures.paths_with)}}}};
}

}  // namespace sim::report
