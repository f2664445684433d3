#include "robot/fit/opponents/opponents.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/opponents/opponents_page.h"
#include "robot/fit/rebounds/touches.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr double kKick = 0.5;                // [m/s] (sim/statistics/ball_path.h)
constexpr double kFasterBy = 2;              // times the speed before
constexpr double kKickerWithin = 0.35;       // [m]
constexpr std::size_t kBlock = 200;          // speeds of 20 s
constexpr std::size_t kManyRobots = 10;      // that are resampled whole
constexpr std::size_t kFewestWalking = 600;  // speeds of 60 s
constexpr std::size_t kFewestKicks = 15, kFewestTops = 5;
constexpr std::size_t kOutsideSamples = 200;
constexpr double kWidestForward = 0.08, kWidestSpread = 0.2;

/// All speeds with the blocks that share their luck.
struct Speeds {
  std::vector<double> all;
  std::vector<Group> blocks;
};

Speeds speeds_of(const std::vector<SeenWalk>& walks) {
  Speeds speeds;
  const bool by_robot = walks.size() >= kManyRobots;
  for (const SeenWalk& walk : walks)
    for (std::size_t i = 0; i < walk.speeds.size(); ++i) {
      if (i == 0 || (!by_robot && i % kBlock == 0)) speeds.blocks.emplace_back();
      speeds.blocks.back().push_back(speeds.all.size());
      speeds.all.push_back(walk.speeds[i]);
    }
  return speeds;
}

/// A quantile of some speeds; of those of robots that walk if `walking`.
double speed_quantile(const Speeds& speeds, const std::vector<std::size_t>& chosen, double share, bool walking) {
  std::vector<double> values;
  values.reserve(chosen.size());
  for (const std::size_t i : chosen)
    if (!walking || speeds.all[i] > kWalksFrom) values.push_back(speeds.all[i]);
  return values.empty() ? 0 : sim::statistics::quantile(std::move(values), share);
}

Figure outside_figure(const char* name, const char* unit, double value, double half, std::size_t events,
                      const char* kind, const OpponentsSeen& seen) {
  return {.name = name,
          .unit = unit,
          .value = value,
          .low = std::max(0., value - half),
          .high = value + half,
          .events = events,
          .kind = kind,
          .recordings = seen.recordings,
          .domain = {}};
}

// --- walking ---

void add_speeds(const OpponentsSeen& seen, const sim::Models& base, Report& report) {
  const Speeds speeds = speeds_of(seen.walks);
  const std::size_t walking = walking_speeds(speeds.all);
  if (walking < kFewestWalking) {
    const std::string reason = formatted("expected at least 60 s of robots that walk and recorded nothing, got %.0f s",
                                         static_cast<double>(walking) / 10);
    report.kept.push_back("opponents.speed: " + reason);
    report.kept.push_back("opponents.speed_median: " + reason);
    report.needs.push_back(need_of("opponents.speed", "s of walking", walking / 10, 600, "record the truth of a game"));
    return;
  }
  const auto samples = resampled(speeds.blocks, kOutsideSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
    return {speed_quantile(speeds, chosen, 0.99, false), speed_quantile(speeds, chosen, 0.5, true)};
  });
  const Vector deviations = deviations_of(samples);
  const Group all = all_of(speeds.all.size());
  const double wide = two_sided(std::max<std::size_t>(1, speeds.blocks.size() - 1));
  const Domain domain{.quantity = "speed", .unit = "m/s", .from = 0, .to = std::ranges::max(speeds.all)};
  const char* names[] = {"opponents.speed", "opponents.speed_median"};
  const double values[] = {speed_quantile(speeds, all, 0.99, false), speed_quantile(speeds, all, 0.5, true)};
  for (std::size_t i = 0; i < 2; ++i) {
    Figure figure = outside_figure(names[i], "m/s", values[i], wide * deviations[i], speeds.blocks.size(),
                                   seen.walks.size() >= kManyRobots ? "robots" : "blocks of 20 s", seen);
    figure.domain = domain;
    report.needs.push_back(need_of(figure, 0.03, "record the truth of more games"));
    report.figures.push_back(std::move(figure));
  }
  report.pictures.push_back(picture_of_speeds(speeds.all, values[0], static_cast<double>(base.motion.walk.forward)));
}

void add_paces(const OpponentsSeen& seen, Report& report) {
  const auto keep = [&](const std::string& reason) {
    report.kept.push_back("walk.forward: " + reason);
    report.kept.push_back("walk.spread: " + reason);
  };
  if (!seen.all_unknown) return;  // the robots' own recordings know better
  std::vector<TopSpeed> tops;
  for (const SeenWalk& walk : seen.walks)
    if (const auto top = top_speed_of(walk)) tops.push_back(*top);
  if (tops.size() < kFewestTops)
    return keep(formatted("expected at least %zu robots that walk for a minute, and fast for a quarter of it, got %zu",
                          kFewestTops, tops.size()));
  const PaceFit fit = fit_paces(tops);
  const auto [slowest, fastest] = std::ranges::minmax_element(tops, {}, &TopSpeed::value);
  const Domain domain{.quantity = "top speed", .unit = "m/s", .from = slowest->value, .to = fastest->value};
  const auto figure_of = [&](const char* name, const char* unit, double widest) {
    return Figure{.name = name,
                  .unit = unit,
                  .events = tops.size(),
                  .kind = "robots",
                  .recordings = seen.recordings,
                  .domain = domain,
                  .widest = widest};
  };
  Figure forward = figure_of("walk.forward", "m/s", kWidestForward);
  forward.value = fit.forward, forward.low = fit.forward_low, forward.high = fit.forward_high;
  Figure spread = figure_of("walk.spread", "", kWidestSpread);
  spread.value = fit.spread, spread.low = fit.spread_low, spread.high = fit.spread_high;
  for (Figure* figure : {&forward, &spread}) {
    report.needs.push_back(need_of(*figure, figure->widest / 2, "record the truth of more robots"));
    report.figures.push_back(std::move(*figure));
  }
  report.notes.push_back(
      "walk.forward and walk.spread are those of speeds that were seen: robots that never hurry look slow.");
}

// --- kicks ---

double kick_quantile(const std::vector<SeenKick>& kicks, const std::vector<std::size_t>& chosen,
                     double SeenKick::*value, double share) {
  std::vector<double> values;
  for (const std::size_t i : chosen) values.push_back(kicks[i].*value);
  return sim::statistics::quantile(std::move(values), share);
}

void add_kicks(const OpponentsSeen& seen, Report& report) {
  const std::vector<SeenKick>& kicks = seen.kicks;
  if (kicks.size() < kFewestKicks) {
    const std::string reason =
        formatted("expected at least %zu kicks by robots that recorded nothing, got %zu", kFewestKicks, kicks.size());
    report.kept.push_back("opponents.kick_speed: " + reason);
    report.kept.push_back("opponents.reach: " + reason);
    report.needs.push_back(need_of("opponents.reach", "kicks", kicks.size(), 50, "record the truth of more games"));
    return;
  }
  const auto samples =
      resampled(single_groups(kicks.size()), kOutsideSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        return {kick_quantile(kicks, chosen, &SeenKick::speed, 0.5),
                kick_quantile(kicks, chosen, &SeenKick::reach, 0.9)};
      });
  const Vector deviations = deviations_of(samples);
  const Group all = all_of(kicks.size());
  const double wide = two_sided(kicks.size() - 1), middle = kick_quantile(kicks, all, &SeenKick::speed, 0.5);
  const double reach = kick_quantile(kicks, all, &SeenKick::reach, 0.9);
  const auto [weakest, hardest] = std::ranges::minmax_element(kicks, {}, &SeenKick::speed);
  const Domain domain{.quantity = "speed", .unit = "m/s", .from = weakest->speed, .to = hardest->speed};
  Figure speed =
      outside_figure("opponents.kick_speed", "m/s", middle, wide * deviations[0], kicks.size(), "kicks", seen);
  Figure range = outside_figure("opponents.reach", "m", reach, wide * deviations[1], kicks.size(), "kicks", seen);
  speed.domain = range.domain = domain;
  report.pictures.push_back(picture_of_kicks(kicks, middle));
  report.needs.push_back(need_of(range, 1, "record the truth of more games"));
  report.figures.push_back(std::move(speed));
  report.figures.push_back(std::move(range));
}

// --- reading ---

/// Returns the names of the robots of a truth that recorded themselves.
std::vector<std::string> known_in(const Evidence& evidence, const std::shared_ptr<const TrueGame>& game) {
  std::vector<std::string> names;
  for (const WatchedRobot& robot : evidence.robots) {
    if (robot.game != game) continue;
    names.push_back(robot.session.info.robot);
    // a truth that does not identify its robots has the same path under another name
    for (const lab::TrueRobotPath& path : game->record.robots)
      if (!path.path.empty() && !robot.path.empty() && path.path.front().at == robot.path.front().at &&
          path.path.front().x == robot.path.front().x && path.path.front().y == robot.path.front().y)
        names.push_back(path.name);
  }
  return names;
}

std::optional<SeenKick> kick_in(const Touch& touch, const std::vector<SeenWalk>& walks, double deceleration) {
  const double before = std::hypot(touch.before_x, touch.before_y), speed = std::hypot(touch.after_x, touch.after_y);
  if (touch.near.empty() || speed < kKick || speed < kFasterBy * before) return std::nullopt;
  const Toucher& robot = touch.near.front();
  if (std::hypot(robot.x - touch.x, robot.y - touch.y) > kKickerWithin) return std::nullopt;
  const auto walk = std::ranges::find_if(
      walks, [&](const SeenWalk& one) { return one.recording == touch.recording && one.robot == robot.robot; });
  if (walk == walks.end()) return std::nullopt;
  return SeenKick{.recording = touch.recording,
                  .at = touch.at,
                  .team = walk->team,
                  .speed = speed,
                  .reach = speed * speed / (2 * deceleration)};
}

}  // namespace

OpponentsSeen read_opponents(const Evidence& evidence, double deceleration) {
  OpponentsSeen seen;
  seen.all_unknown = evidence.robots.empty();
  for (const auto& game : evidence.games) {
    const std::size_t recording = seen.recordings.size();
    auto walks = walks_in(game->record, known_in(evidence, game), recording);
    if (walks.empty()) continue;
    seen.recordings.push_back(game->name);
    for (const Touch& touch : touches_in(game->record, deceleration, recording).touches)
      if (auto kick = kick_in(touch, walks, deceleration)) seen.kicks.push_back(std::move(*kick));
    std::ranges::move(walks, std::back_inserter(seen.walks));
  }
  return seen;
}

Report fit_opponents(const OpponentsSeen& seen, const sim::Models& base) {
  Report report;
  report.name = "opponents";
  report.title = "What the robots of a game can do, from outside";
  add_speeds(seen, base, report);
  add_paces(seen, report);
  add_kicks(seen, report);
  if (!seen.walks.empty()) {
    report.results.push_back(results_of_teams(seen));
    report.tables.emplace_back("opponents_walks", table_of_walks(seen));
  }
  if (!seen.kicks.empty()) report.tables.emplace_back("opponents_kicks", table_of_kicks(seen));
  return report;
}

Report fit_opponents(const Evidence& evidence, const sim::Models& base) {
  return fit_opponents(read_opponents(evidence, static_cast<double>(base.ball.deceleration)), base);
}

}  // namespace robot::fit
