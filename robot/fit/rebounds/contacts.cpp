#include "robot/fit/rebounds/contacts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr double kLeastIn = 0.4;        // [m/s] of a rebound
constexpr double kObliquest = 0.87;     // [rad] 50°
constexpr double kStandsBelow = 0.03;   // [m/s] beyond two deviations
constexpr double kOtherRobot = 0.35;    // [m] from another robot to the ball: it may have touched it
constexpr double kWrongGap = 0.1;       // [m] off the expected distance of a touch
constexpr double kLeastOwn = 0.1;       // [m/s] of a push
constexpr double kLeastMeeting = 0.2;   // [m/s] of robot and ball towards each other
constexpr double kLeastAfter = 0.2;     // [m/s] of a ball whose direction is known
constexpr double kSharpest = 0.85;      // share of the greatest turn that is not bent back
constexpr double kOtherSpeed = 0.15;    // [m/s] off the speed after a push: a kick
constexpr double kLeastGate = 0.03;     // [m] off the median distance of touches
constexpr double kWrongPostGap = 0.05;  // [m]

// sim/data/rules: the fields of 2012, 2025 and 2026
constexpr Goals kGoals[] = {{.field = "9 m x 6 m", .length = 9, .width = 1.6, .post_radius = 0.05},
                            {.field = "8.95 m x 5.95 m", .length = 8.95, .width = 1.9, .post_radius = 0.05},
                            {.field = "6 m x 4 m", .length = 6, .width = 1.4, .post_radius = 0.05}};

/// The line from the middle of a thing to the ball.
struct Away {
  double x, y;  // unit vector
  double gap;   // [m]

  double along(double vx, double vy) const { return vx * x + vy * y; }
  double across(double vx, double vy) const { return vy * x - vx * y; }
};

std::optional<Away> away_from(double x, double y, const Touch& touch) {
  const double gap = std::hypot(touch.x - x, touch.y - y);
  if (gap < 0.02) return std::nullopt;
  return Away{.x = (touch.x - x) / gap, .y = (touch.y - y) / gap, .gap = gap};
}

/// Returns the rebound off a thing that stands, or nothing if the ball does not come in fast and straight enough.
std::optional<Rebound> rebound_off(const Away& away, const Touch& touch, const Toucher& thing) {
  const double drift = away.along(thing.drift_x, thing.drift_y);
  const double in = drift - away.along(touch.before_x, touch.before_y),
               across = away.across(touch.before_x, touch.before_y);
  if (in < kLeastIn || std::abs(std::atan2(across, in)) > kObliquest) return std::nullopt;
  return Rebound{.recording = touch.recording,
                 .at = touch.at,
                 .in = in,
                 .out = away.along(touch.after_x, touch.after_y) - drift,
                 .across = across,
                 .in_deviation = touch.before_deviation,
                 .out_deviation = touch.after_deviation,
                 .gap = away.gap,
                 .gap_deviation = std::hypot(thing.deviation, touch.deviation)};
}

bool is_alone(const Touch& touch) {
  return touch.near.size() < 2 || std::hypot(touch.near[1].x - touch.x, touch.near[1].y - touch.y) > kOtherRobot;
}

std::optional<Push> push_of(const Touch& touch, const ContactFacts& facts) {
  if (touch.near.empty() || !is_alone(touch) || touch.near[0].fallen) return std::nullopt;
  const Toucher& robot = touch.near[0];
  const auto away = away_from(robot.x, robot.y, touch);
  if (!away || std::abs(away->gap - facts.robot_reach) > kWrongGap) return std::nullopt;
  const double own = away->along(robot.speed_x, robot.speed_y), in = -away->along(touch.before_x, touch.before_y);
  if (own < kLeastOwn || own + in < kLeastMeeting) return std::nullopt;
  // as sim/world/bounce.cpp: the normal speed relative to the robot is reversed
  const double gain = (1 + facts.robot_restitution) * (own + in);
  const double x = touch.before_x + gain * away->x, y = touch.before_y + gain * away->y;
  const double expected = std::hypot(x, y), speed = std::hypot(touch.after_x, touch.after_y);
  if (speed < kLeastAfter || expected < kLeastAfter) return std::nullopt;
  const double of_robot = (1 + facts.robot_restitution) * robot.speed_deviation;
  const double doubt = std::hypot(touch.after_deviation, touch.before_deviation, of_robot);
  if (std::abs(speed - expected) > std::max(kOtherSpeed, 2 * doubt)) return std::nullopt;
  // the foot bends the ball back as soon as it is slower than the robot along the line
  const double aside = std::atan2(away->across(x, y), away->along(x, y));
  const double widest = kSharpest * std::acos(std::min(1., own / expected));
  return Push{.recording = touch.recording,
              .at = touch.at,
              .own = own,
              .in = in,
              .speed = speed,
              .turn = wrapped(std::atan2(touch.after_y, touch.after_x) - std::atan2(y, x)),
              .deviation = std::hypot(touch.after_deviation / speed, touch.before_deviation / expected,
                                      of_robot * std::abs(std::sin(aside)) / expected),
              .lever = gain * std::abs(std::cos(aside)) / expected,
              .least = std::min(-0.05, -widest - aside),
              .most = std::max(0.05, widest - aside),
              .gap = away->gap};
}

template <class Contact>
std::vector<double> gaps_of(const std::vector<Contact>& contacts) {
  std::vector<double> gaps;
  for (const Contact& contact : contacts) gaps.push_back(contact.gap);
  return gaps;
}

/// Leaves out touches that are farther away or nearer than most: the robot squatted, or an arm met the ball.
template <class Contact>
void drop_strange_gaps(std::vector<Contact>& contacts) {
  if (contacts.empty()) return;
  const std::vector<double> gaps = gaps_of(contacts);
  const double middle = sim::statistics::median(gaps), most = std::max(kLeastGate, 3 * gap_scatter(gaps));
  std::erase_if(contacts, [&](const Contact& contact) { return std::abs(contact.gap - middle) > most; });
}

}  // namespace

double gap_scatter(std::vector<double> gaps) {
  if (gaps.size() < 2) return 0;
  const double middle = sim::statistics::median(gaps);
  for (double& gap : gaps) gap = std::abs(gap - middle);
  return kOfMedian * sim::statistics::median(std::move(gaps));
}

std::vector<Rebound> robot_rebounds(const std::vector<Touch>& touches, const ContactFacts& facts) {
  std::vector<Rebound> rebounds;
  for (const Touch& touch : touches) {
    if (touch.near.empty() || !is_alone(touch)) continue;
    const Toucher& robot = touch.near[0];
    const auto away = away_from(robot.x, robot.y, touch);
    const double walks = std::hypot(robot.drift_x, robot.drift_y);
    if (!away || robot.fallen || std::abs(away->gap - facts.robot_reach) > kWrongGap ||
        walks > kStandsBelow + 2 * robot.drift_deviation)
      continue;
    if (const auto rebound = rebound_off(*away, touch, robot)) rebounds.push_back(*rebound);
  }
  drop_strange_gaps(rebounds);
  return rebounds;
}

std::vector<Push> pushes(const std::vector<Touch>& touches, const ContactFacts& facts) {
  std::vector<Push> all;
  for (const Touch& touch : touches)
    if (const auto push = push_of(touch, facts)) all.push_back(*push);
  drop_strange_gaps(all);
  return all;
}

PostRebounds post_rebounds(const std::vector<Touch>& touches, const ContactFacts& facts) {
  PostRebounds best{.goals = kGoals[0], .rebounds = {}};
  for (const Goals& goals : kGoals) {
    std::vector<Rebound> rebounds;
    for (const Touch& touch : touches) {
      if (!touch.near.empty() && std::hypot(touch.near[0].x - touch.x, touch.near[0].y - touch.y) < kOtherRobot)
        continue;
      // the post in the ball's quarter of the field
      const auto away =
          away_from(std::copysign(goals.length / 2, touch.x), std::copysign(goals.width / 2, touch.y), touch);
      if (!away || std::abs(away->gap - goals.post_radius - facts.ball_radius) > kWrongPostGap) continue;
      if (const auto rebound = rebound_off(*away, touch, {})) rebounds.push_back(*rebound);
    }
    if (rebounds.size() > best.rebounds.size()) best = {.goals = goals, .rebounds = std::move(rebounds)};
  }
  return best;
}

}  // namespace robot::fit
