#include "robot/fit/rebounds/rebounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/least_squares.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/math/simplex.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestRebounds = 8, kFewestPostRebounds = 5, kFewestPushes = 20, kContactSamples = 200;
constexpr double kMostTilt = 0.35;  // [rad] 20°: beyond, the line between the middles is not known
constexpr double kStray = 0.02;     // share of pushes in any direction: something else met the ball
constexpr double kWidestRestitution = 0.15, kWidestPush = 0.12;  // [rad]

ContactFacts facts_of(const sim::Models& base) {
  const auto radius = static_cast<double>(base.ball.radius);
  return {.robot_reach = static_cast<double>(base.contact.foot_radius) + radius,
          .ball_radius = radius,
          .robot_restitution = static_cast<double>(base.ball.robot_restitution)};
}

double normal_below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

/// Returns the density of a turn [1/rad], or the probability of a turn that is bent back.
double density_of_turn(const Push& push, double deviation) {
  const double z = push.turn / deviation;
  if (push.least < push.turn && push.turn < push.most)
    return (1 - kStray) * std::exp(-z * z / 2) / (deviation * std::sqrt(2 * std::numbers::pi)) +
           kStray / (2 * std::numbers::pi);
  return (1 - kStray) * (normal_below(push.least / deviation) + normal_below(-push.most / deviation)) +
         kStray * (1 - (push.most - push.least) / (2 * std::numbers::pi));
}

template <class Contact>
std::vector<double> gaps_in(const std::vector<Contact>& contacts) {
  std::vector<double> gaps;
  for (const Contact& contact : contacts) gaps.push_back(contact.gap);
  return gaps;
}

Figure restitution_figure(const char* name, const std::vector<Rebound>& rebounds, double tilt,
                          const ReboundsSeen& seen) {
  const auto samples = resampled(
      single_groups(rebounds.size()), kContactSamples,
      [&](const std::vector<std::size_t>& chosen) -> Vector { return {fit_restitution(rebounds, chosen, tilt)}; });
  const double value = fit_restitution(rebounds, all_of(rebounds.size()), tilt);
  const double half = two_sided(rebounds.size() - 1) * deviations_of(samples)[0];
  const auto [slowest, fastest] = std::ranges::minmax_element(rebounds, {}, &Rebound::in);
  return {.name = name,
          .unit = "",
          .value = value,
          .low = std::max(0., value - half),
          .high = std::min(1., value + half),
          .events = rebounds.size(),
          .kind = "rebounds",
          .recordings = seen.recordings,
          .domain = {.quantity = "speed", .unit = "m/s", .from = slowest->in, .to = fastest->in},
          .widest = kWidestRestitution};
}

Picture picture_of_rebounds(const char* title, const std::vector<Rebound>& rebounds, double fitted, double usual) {
  Mark dots{.role = Mark::Role::truth, .label = "a rebound", .x = {}, .y = {}, .high = {}};
  double most = 1, least = 0;
  for (const Rebound& rebound : rebounds) {
    dots.x.push_back(rebound.in), dots.y.push_back(rebound.out);
    most = std::max(most, 1.05 * rebound.in), least = std::min(least, rebound.out);
  }
  const auto line = [&](Mark::Role role, const char* label, double share) {
    return Mark{
        .shape = Mark::Shape::line, .role = role, .label = label, .x = {0, most}, .y = {0, share * most}, .high = {}};
  };
  return {.title = title,
          .x_label = "normal speed before [m/s]",
          .y_label = "normal speed after [m/s]",
          .axes = {.left = 0, .right = most, .bottom = least, .top = most},
          .marks = {line(Mark::Role::other, "the models", usual), line(Mark::Role::fitted, "fitted", fitted),
                    std::move(dots)}};
}

Table table_of_rebounds(const std::vector<Rebound>& rebounds, const ReboundsSeen& seen) {
  Table table{.columns = {"time [s]", "normal speed before [m/s]", "normal speed after [m/s]", "speed across [m/s]",
                          "deviation before [m/s]", "deviation after [m/s]", "distance of the middles [m]"},
              .names = seen.recordings,
              .rows = {}};
  for (const Rebound& one : rebounds)
    table.rows.push_back(
        {.recording = one.recording,
         .values = {one.at, one.in, one.out, one.across, one.in_deviation, one.out_deviation, one.gap}});
  return table;
}

/// Returns the sentence why rebounds cannot be fitted, or an empty one.
std::string reason_against(const std::vector<Rebound>& rebounds, std::size_t fewest, const char* off, double tilt) {
  if (rebounds.size() < fewest)
    return formatted("expected at least %zu rebounds off %s, got %zu", fewest, off, rebounds.size());
  if (tilt > kMostTilt)
    return formatted("expected a line between ball and %s that is known to %.2f rad, got %.2f rad", off, kMostTilt,
                     tilt);
  return "";
}

void add_robots(const ReboundsSeen& seen, const sim::Models& base, Report& report) {
  const auto usual = static_cast<double>(base.ball.robot_restitution);
  const double tilt = tilt_of(gaps_in(seen.robots));
  const std::string reason = reason_against(seen.robots, kFewestRebounds, "robots that stand", tilt);
  const char* advice = "kick the ball at robots that stand, straight and from 1 to 2 m";
  if (!seen.robots.empty()) report.tables.emplace_back("robot_rebounds", table_of_rebounds(seen.robots, seen));
  if (!reason.empty()) {
    report.kept.push_back("ball.robot_restitution: " + reason);
    report.needs.push_back(
        need_of("ball.robot_restitution", "rebounds", seen.robots.size(), 3 * kFewestRebounds, advice));
    return;
  }
  Figure figure = restitution_figure("ball.robot_restitution", seen.robots, tilt, seen);
  report.pictures.push_back(picture_of_rebounds("Rebounds off robots that stand", seen.robots, figure.value, usual));
  report.needs.push_back(need_of(figure, 0.05, advice));
  report.figures.push_back(std::move(figure));
}

void add_posts(const ReboundsSeen& seen, const sim::Models& base, Report& report) {
  const std::vector<Rebound>& rebounds = seen.posts.rebounds;
  const double tilt = tilt_of(gaps_in(rebounds));
  const std::string reason = reason_against(rebounds, kFewestPostRebounds, "goal posts of a known field", tilt);
  const char* advice = "kick the ball at a goal post";
  if (!rebounds.empty()) report.tables.emplace_back("post_rebounds", table_of_rebounds(rebounds, seen));
  if (!reason.empty()) {
    report.kept.push_back("ball.post_restitution: " + reason);
    report.needs.push_back(
        need_of("ball.post_restitution", "rebounds", rebounds.size(), 2 * kFewestPostRebounds, advice));
    return;
  }
  Figure figure = restitution_figure("ball.post_restitution", rebounds, tilt, seen);
  report.pictures.push_back(picture_of_rebounds("Rebounds off goal posts", rebounds, figure.value,
                                                static_cast<double>(base.ball.post_restitution)));
  report.notes.push_back(
      formatted("The goal posts are those of the field of %s: it explains most rebounds.", seen.posts.goals.field));
  report.needs.push_back(need_of(figure, 0.1, advice));
  report.figures.push_back(std::move(figure));
}

Picture picture_of_pushes(const std::vector<Push>& pushes, double fitted, double usual) {
  constexpr double kBar = 0.1;
  constexpr double kEnd = 1.6;  // [rad]
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "pushes",
            .x = {},
            .y = {},
            .high = {},
            .width = kBar};
  for (double from = -kEnd; from < kEnd - kBar / 2; from += kBar) {
    bars.x.push_back(from);
    bars.y.push_back(static_cast<double>(
        std::ranges::count_if(pushes, [&](const Push& push) { return push.turn >= from && push.turn < from + kBar; })));
  }
  const double most = std::max(1., 1.2 * std::ranges::max(bars.y));
  const auto bell = [&](Mark::Role role, const char* label, double deviation) {
    Mark line{.shape = Mark::Shape::line, .role = role, .label = label, .x = {}, .y = {}, .high = {}};
    for (int i = 0; i <= 160; ++i) {
      const double turn = -kEnd + 2 * kEnd * i / 160, z = turn / deviation;
      line.x.push_back(turn);
      line.y.push_back(std::min(most, static_cast<double>(pushes.size()) * kBar * std::exp(-z * z / 2) /
                                          (deviation * std::sqrt(2 * std::numbers::pi))));
    }
    return line;
  };
  return {.title = "Direction of a ball that a robot walks into",
          .x_label = "direction from that without deviation [rad]",
          .y_label = "pushes",
          .axes = {.left = -kEnd, .right = kEnd, .bottom = 0, .top = most},
          .marks = {std::move(bars), bell(Mark::Role::other, "the models", std::max(0.02, usual)),
                    bell(Mark::Role::fitted, "fitted", std::max(0.02, fitted))}};
}

Table table_of_pushes(const ReboundsSeen& seen) {
  Table table{
      .columns = {"time [s]", "speed of the robot [m/s]", "speed of the ball before [m/s]", "speed of the ball [m/s]",
                  "direction [rad]", "deviation [rad]", "distance of the middles [m]"},
      .names = seen.recordings,
      .rows = {}};
  for (const Push& push : seen.pushes)
    table.rows.push_back({.recording = push.recording,
                          .values = {push.at, push.own, push.in, push.speed, push.turn, push.deviation, push.gap}});
  return table;
}

void add_pushes(const ReboundsSeen& seen, const sim::Models& base, Report& report) {
  const double tilt = tilt_of(gaps_in(seen.pushes));
  const char* advice = "let a robot walk into balls that lie on an empty field";
  const auto keep = [&](const std::string& reason) {
    report.kept.push_back("contact.push_deviation: " + reason);
    report.needs.push_back(need_of("contact.push_deviation", "pushes", seen.pushes.size(), 3 * kFewestPushes, advice));
  };
  if (!seen.pushes.empty()) report.tables.emplace_back("pushes", table_of_pushes(seen));
  if (seen.pushes.size() < kFewestPushes)
    return keep(formatted("expected at least %zu pushes, got %zu", kFewestPushes, seen.pushes.size()));
  if (tilt > kMostTilt)
    return keep(
        formatted("expected a line between ball and robot that is known to %.2f rad, got %.2f rad", kMostTilt, tilt));
  const auto bent = static_cast<std::size_t>(std::ranges::count_if(
      seen.pushes, [](const Push& push) { return push.turn <= push.least || push.turn >= push.most; }));
  if (2 * bent > seen.pushes.size())
    return keep(formatted("expected that the foot bends back at most half of the pushes, got %zu of %zu", bent,
                          seen.pushes.size()));
  const auto samples = resampled(single_groups(seen.pushes.size()), kContactSamples,
                                 [&](const std::vector<std::size_t>& chosen) -> Vector {
                                   return {fit_push_deviation(seen.pushes, chosen, tilt)};
                                 });
  const double value = fit_push_deviation(seen.pushes, all_of(seen.pushes.size()), tilt);
  const double half = two_sided(seen.pushes.size() - 1) * deviations_of(samples)[0];
  const auto [slowest, fastest] = std::ranges::minmax_element(seen.pushes, {}, &Push::own);
  Figure figure{.name = "contact.push_deviation",
                .unit = "rad",
                .value = value,
                .low = std::max(0., value - half),
                .high = value + half,
                .events = seen.pushes.size(),
                .kind = "pushes",
                .recordings = seen.recordings,
                .domain = {.quantity = "speed of the robot", .unit = "m/s", .from = slowest->own, .to = fastest->own},
                .widest = kWidestPush};
  report.pictures.push_back(picture_of_pushes(seen.pushes, value, static_cast<double>(base.contact.push_deviation)));
  report.notes.push_back(formatted(
      "The line from a robot to the ball that it pushes is known to %.2f rad; its error is subtracted.", tilt));
  report.needs.push_back(need_of(figure, 0.05, advice));
  report.figures.push_back(std::move(figure));
}

}  // namespace

double tilt_of(const std::vector<double>& gaps) {
  return gaps.empty() ? 0 : gap_scatter(gaps) / sim::statistics::median(gaps);
}

double fit_restitution(const std::vector<Rebound>& rebounds, const std::vector<std::size_t>& chosen, double tilt) {
  const auto residuals = [&](const Vector& p, Vector& errors) {
    errors.resize(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const Rebound& one = rebounds[chosen[k]];
      // a tilted line mixes the speed across into both
      const double mixed = (1 + p[0]) * tilt * one.across;
      errors[k] = (one.out - p[0] * one.in) / std::hypot(one.out_deviation, p[0] * one.in_deviation, mixed);
    }
  };
  std::vector<double> shares;
  for (const std::size_t i : chosen) shares.push_back(rebounds[i].out / rebounds[i].in);
  return minimise({.least = {0}, .most = {1}, .residuals = residuals, .loss = Loss::cauchy},
                  {std::clamp(sim::statistics::median(std::move(shares)), 0., 1.)})
      .parameters[0];
}

double fit_push_deviation(const std::vector<Push>& pushes, const std::vector<std::size_t>& chosen, double tilt) {
  const auto unlikely = [&](const Vector& p) {
    if (p[0] < 0 || p[0] > 1.5) return static_cast<double>(INFINITY);
    double sum = 0;
    for (const std::size_t i : chosen)
      sum -= std::log(density_of_turn(pushes[i], std::hypot(p[0], pushes[i].deviation, pushes[i].lever * tilt)));
    return sum;
  };
  return least_of(unlikely, {0.4}, {0.1})[0];
}

ReboundsSeen read_rebounds(const Evidence& evidence, const sim::Models& base) {
  ReboundsSeen seen;
  std::vector<Touch> all;
  for (const auto& game : evidence.games) {
    TouchesSeen touches = touches_in(game->record, static_cast<double>(base.ball.deceleration), seen.recordings.size());
    seen.recordings.push_back(game->name);
    seen.unclear += touches.unclear, seen.left_out += touches.left_out;
    std::ranges::move(touches.touches, std::back_inserter(all));
  }
  seen.touches = all.size();
  ContactFacts facts = facts_of(base);
  seen.robots = robot_rebounds(all, facts);
  seen.posts = post_rebounds(all, facts);
  // a push is judged by the restitution of these robots, if it is known
  if (seen.robots.size() >= kFewestRebounds)
    facts.robot_restitution = fit_restitution(seen.robots, all_of(seen.robots.size()), tilt_of(gaps_in(seen.robots)));
  seen.pushes = pushes(all, facts);
  return seen;
}

Report fit_rebounds(const ReboundsSeen& seen, const sim::Models& base) {
  Report report;
  report.name = "rebounds";
  report.title = "How the ball rebounds and is pushed";
  add_robots(seen, base, report);
  add_posts(seen, base, report);
  add_pushes(seen, base, report);
  report.notes.push_back(
      formatted("%zu touches: %zu rebounds off robots that stand, %zu off posts, %zu pushes; the others are kicks, "
                "oblique or slow.",
                seen.touches, seen.robots.size(), seen.posts.rebounds.size(), seen.pushes.size()));
  if (seen.unclear > 0)
    report.notes.push_back(
        formatted("Left out: %zu touches whose ball does not roll freely before and after.", seen.unclear));
  if (seen.left_out > 0)
    report.notes.push_back(formatted("Left out: %zu impossible places of the ball.", seen.left_out));
  return report;
}

Report fit_rebounds(const Evidence& evidence, const sim::Models& base) {
  return fit_rebounds(read_rebounds(evidence, base), base);
}

}  // namespace robot::fit
