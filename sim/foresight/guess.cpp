#include "sim/foresight/guess.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim::foresight {
namespace {

// Source: 16 000 balls that a robot believed in, at moments of `baseline` against itself, spl2012. Beliefs with an
// error under 1 m had 0.14 m along each axis when just seen, and 0.2 to 0.3 m at any greater age. The other balls had
// been kicked or placed by the referee. True velocities were 0.82 of the believed ones at a deviation of 0.15 m/s, 0.67
// at 0.35 m/s, 0.44 at 0.6 m/s: a prior of 0.5 m/s along each axis explains it. Nearly
// all balls believed to lie did lie.
constexpr float kFreshEyes = 2;      // [s] the own sight counts for this time, as agent::Habits::trust_eyes
constexpr float kLeastBall = 0.1f;   // [m]
constexpr float kMostBall = 0.3f;    // [m]
constexpr float kToldBall = 0.2f;    // [m] of a teammate's report: its eyes and its pose
constexpr float kUsualSpeed = 0.5f;  // [m/s] of a ball along each axis
constexpr float kLying = 0.3f;       // [m/s] a slower ball is taken to lie
constexpr float kLyingMoves = 0.3f;  // of the deviation of its velocity

// Share of these balls with an error over 1 m, by the time since a robot of the team had seen them:
//   0.75 s 6 %, 1.25 s 20 %, 1.75 s 40 %, 2.5 s 61 %, 4 s 83 %, from 6 s on 95 %.
// The same for balls that were believed to be out:
//   0 s 20 %, 0.35 s 29 %, 0.75 s 48 %, 1.25 s 64 %, from 1.75 s on 90 %.
constexpr float kBallLeaves = 0.1f;  // [1/s³] the odds that it is elsewhere grow with the third power of the time
constexpr float kOutIsTaken = 0.7f;  // [s] after this time the referee has placed half of the balls that are out

// Errors of reported or seen robots, and their way since then. Source: 15 000 sightings of opponents at moments of
// `baseline` against itself, spl2012. The errors along each axis were 0.45 m at once, 0.69 m after 5 to 10 s, 0.93 m
// after 10 to 20 s, 1.21 m after 20 to 40 s: the variance grows linearly with time.
constexpr float kToldRobot = 0.15f;    // [m] a teammate's own localisation
constexpr float kSeenRobot = 0.45f;    // [m] an opponent seen by the own eyes, relative to the believed own pose
constexpr float kRobotStrays = 0.04f;  // [m²/s] along each axis
// A side keeps together: independent errors would open gaps in it that do not exist.
constexpr float kOwnShare = 0.5f;     // independent share of a robot's deviation: the value with the best forecasts
constexpr float kForgotten = 60;      // [s] after this time a message or sight is ignored
constexpr float kTurns = 0.3f;        // [rad/s]
constexpr float kMostHeading = 1.2f;  // [rad]
constexpr float kTowardsBall = 0.6f;  // [rad] deviation from facing the ball, for an unknown heading

// Usual places of a side in play. Source: 16 000 moments of such games by spl2012 and spl2025. The keeper is in front
// of its goal, the others on the way from there to the ball, one of them near the ball.
constexpr float kKeeperOut = 0.54f;             // [m] from the goal line
constexpr Vec2 kKeeperDrawn{0.04f, 0.21f};      // of the ball's place
constexpr float kKeeperRoams = 0.2f;            // [m]
constexpr float kChaserOut = 0.8f;              // of the way from the goal to the ball
constexpr float kChaserRoams[] = {0.3f, 0.1f};  // [m], and of the ball's distance from the goal
constexpr float kOthersOut = 0.6f;              // of the way to the ball, but at most ...
constexpr float kOthersBack = 0.27f;            // of the field's length
constexpr float kOthersRoam = 0.7f;             // [m]
constexpr float kUnknownChaser = 1.5f;          // [m] from the ball: a robot known to be nearer is preferred as chaser

float grown(float at_first, float rate, float seconds, float most) { return std::min(at_first + rate * seconds, most); }

/// Returns the probability that a ball is not where it was seen that time ago.
float elsewhere(const field::Field& field, Vec2 position, float seconds) {
  if (!(seconds < kForgotten)) return 1;
  const float odds = kBallLeaves * seconds * seconds * seconds;
  return std::max(odds / (1 + odds), beyond_lines(field, position) ? seconds / (seconds + kOutIsTaken) : 0.f);
}

float heading_to(Vec2 from, Vec2 to) { return from == to ? 0.f : angle_of(to - from); }

struct Guess {
  Vec2 position;
  float deviation;  // [m] along each axis
};

/// The assumed place of a player without other knowledge. Frame: team_field of its side.
Guess usual_place(const field::Field& field, int player, bool chases, Vec2 ball) {
  const Vec2 goal{-field.length / 2, 0};
  if (player == 1) return {goal + Vec2{kKeeperOut + kKeeperDrawn.x * ball.x, kKeeperDrawn.y * ball.y}, kKeeperRoams};
  const Vec2 to_ball = ball - goal;
  const float far = length(to_ball);
  if (chases) return {goal + kChaserOut * to_ball, kChaserRoams[0] + kChaserRoams[1] * far};
  const float share = far > 0 ? std::min(kOthersOut, kOthersBack * field.length / far) : kOthersOut;
  return {goal + share * to_ball, kOthersRoam};
}

/// The last message or sight of a robot, and its age. Frame: team_field of the robot that knows it.
struct Sighting {
  Pose2 pose;
  float deviation;  // [m] along each axis
  float seconds;    // [s] at most kForgotten
};

/// Returns it for any other robot, or nothing when it is forgotten or never known. An opponent's heading is unknown.
std::optional<Sighting> sighting_of(const Knowledge& knowledge, int robot) {
  const int player = player_of(robot), own = knowledge.game.player;
  const auto unless_forgotten = [](const Sighting& sighting) {
    return sighting.seconds < kForgotten ? std::optional(sighting) : std::nullopt;
  };
  if (side_of(robot) == Side::away) {
    const agent::Opponent& opponent = knowledge.beliefs.opponents[player - 1];
    return unless_forgotten({{opponent.position, 0}, kSeenRobot, age(knowledge.now, opponent.seen)});
  }
  const agent::Mate& mate = knowledge.beliefs.mates[agent::index_of_mate(own, player)];
  return unless_forgotten({mate.pose, kToldRobot, age(knowledge.now, mate.sent)});
}

/// Returns whether a robot is assumed to be the field player of its side that is nearest to the ball.
bool chases(const Params& params, const Knowledge& knowledge, Vec2 ball, int robot) {
  const Side side = side_of(robot);
  int chaser = kNobody;
  float nearest = 0;
  for (int player = 2; player <= params.rules.players; ++player) {
    if (knowledge.away[static_cast<int>(side)][player - 1] != 0) continue;
    const int other = robot_of(side, player);
    float far = kUnknownChaser;
    if (other == robot_of(Side::home, knowledge.game.player))
      far = distance(knowledge.beliefs.pose.pose.position, ball);
    else if (const auto sighting = sighting_of(knowledge, other))
      far = distance(sighting->pose.position, ball);
    if (chaser == kNobody || far < nearest) chaser = other, nearest = far;
  }
  return chaser == robot;
}

/// Combines the last message or sight of a robot with its usual place, each weighted by its certainty.
Guess weighed(const Guess& usual, const Sighting& sighting) {
  const float known_variance = sighting.deviation * sighting.deviation + kRobotStrays * sighting.seconds;
  const float usual_variance = usual.deviation * usual.deviation;
  const float share = usual_variance / (usual_variance + known_variance);
  return {usual.position + share * (sighting.pose.position - usual.position), std::sqrt(share * known_variance)};
}

}  // namespace

BallGuess guess_ball(const field::Field& field, const Knowledge& knowledge) {
  const agent::Ball& own = knowledge.beliefs.ball;
  const Pose2& pose = knowledge.beliefs.pose.pose;
  const float own_age = age(knowledge.now, own.seen);
  BallGuess guess;
  if (own.seen != kNever) {
    const Vec2 facing = direction(pose.heading);
    guess.position = pose.position + turned(own.position, facing);
    guess.deviation = std::min(std::sqrt(own.variance + kLeastBall * kLeastBall), kMostBall);
    // the filter does not know of robots that stop a ball
    const float share = kUsualSpeed * kUsualSpeed / (kUsualSpeed * kUsualSpeed + own.velocity_variance);
    const bool lies = squared_length(own.velocity) < kLying * kLying;
    guess.velocity = share * turned(own.velocity, facing);
    guess.velocity_deviation = (lies ? kLyingMoves : 1) * std::sqrt(share * own.velocity_variance);
    guess.seen = own.seen;
    guess.elsewhere = elsewhere(field, guess.position, own_age);
    guess.by_own_eyes = true;
  }
  if (own_age <= kFreshEyes) return guess;

  // a teammate may have seen the ball since then
  for (const agent::Mate& mate : knowledge.beliefs.mates) {
    if (mate.sent == kNever || mate.ball_age == 0xffff) continue;
    const Tick seen = mate.sent - std::min<Tick>(mate.ball_age, mate.sent);
    if (guess.seen != kNever && seen <= guess.seen) continue;
    guess = {.position = mate.ball, .seen = seen};
  }
  if (guess.seen == kNever) return guess;
  // the ball has come to rest since then, at an unknown place
  guess.velocity = {};
  guess.velocity_deviation = 0;
  guess.deviation = kToldBall;
  guess.elsewhere = elsewhere(field, guess.position, age(knowledge.now, guess.seen));
  return guess;
}

RobotGuess guess_robot(const Params& params, const Knowledge& knowledge, Vec2 ball, int robot) {
  const int player = player_of(robot);
  const bool home = side_of(robot) == Side::home;
  if (home && player == knowledge.game.player) {
    const agent::Pose& pose = knowledge.beliefs.pose;
    return {pose.pose, pose.deviation, pose.deviation_heading};
  }
  const float sign = home ? 1 : -1;
  Guess place = usual_place(params.rules.field, player, chases(params, knowledge, ball, robot), sign * ball);
  place.position = sign * place.position;
  const auto sighting = sighting_of(knowledge, robot);
  if (sighting) place = weighed(place, *sighting);
  if (home && sighting)
    return {{place.position, sighting->pose.heading},
            kOwnShare * place.deviation,
            grown(kToldRobot, kTurns, sighting->seconds, kMostHeading)};
  return {{place.position, heading_to(place.position, ball)}, kOwnShare * place.deviation, kTowardsBall};
}

}  // namespace sim::foresight
