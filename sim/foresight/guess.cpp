#include "sim/foresight/guess.h"

#include <algorithm>
#include <cmath>

#include "sim/agent/settings.h"

namespace sim::foresight {
namespace {

// Of 4000 balls that a robot believed in at moments of `baseline` against itself, spl2012, those that were less than 1 m
// off were off by 0.2 m along each axis, however old the belief. The others had been kicked, or put somewhere by the
// referee: 1 % of what it saw in the last half second, 5 % until 1 s, then a fifth.
constexpr float kFreshEyes = 2;      // [s] one's own sight counts for so long, as agent::Habits::trust_eyes
constexpr float kMostBall = 3;       // [m]
constexpr float kToldBall = 0.2f;    // [m] of a teammate's report: its eyes and its pose
constexpr float kBallLeaves = 0.1f;  // [1/s] how fast it becomes likely that it is elsewhere
constexpr float kElsewhere = 0.2f;   // [0..1] of what one's own eyes did not see for longer than kFreshEyes

// Of robots: how far off is what was told or seen of them, and how far they have gone since. Errors along each axis in
// 15 000 sightings of opponents at moments of `baseline` against itself, spl2012: 0.45 m at once, 0.69 m after 5 to 10 s,
// 0.93 m after 10 to 20, 1.21 m after 20 to 40, so that the variance grows evenly.
constexpr float kToldRobot = 0.15f;    // [m] a teammate's own localisation
constexpr float kSeenRobot = 0.45f;    // [m] an opponent by one's own eyes, from where one takes oneself to be
constexpr float kRobotStrays = 0.04f;  // [m²/s] along each axis
constexpr float kForgotten = 60;       // [s] after which it is as if it never had been told or seen
constexpr float kTurns = 0.3f;         // [rad/s]
constexpr float kMostHeading = 1.2f;   // [rad]

// Where a side stands while it plays, by the same games: the keeper in front of its goal, the others in their half, drawn
// to the ball. Shares of half the field, of the place at kick-off, and of where the ball is.
constexpr float kKeeperOut = 0.54f;         // [m] from the goal line
constexpr Vec2 kKeeperDrawn{0.04f, 0.21f};  // of the ball's place
constexpr float kKeeperRoams = 0.2f;        // [m]
constexpr float kBack = 0.3f;               // of half the length
constexpr Vec2 kFromKickOff{0.3f, 0.25f}, kFieldPlayerDrawn{0.18f, 0.38f};
constexpr float kFieldPlayerRoams = 0.73f;  // [m]

float grown(float at_first, float rate, float seconds, float most) { return std::min(at_first + rate * seconds, most); }

Vec2 scaled(Vec2 factors, Vec2 a) { return {factors.x * a.x, factors.y * a.y}; }

struct Place {
  Vec2 position;
  float deviation;  // [m] along each axis
};

/// Where a player is taken to be as long as nothing else is known. Frame: team_field of its side.
Place usual_place(const field::Field& field, int player, Vec2 ball) {
  const Vec2 half{field.length / 2, field.width / 2};
  if (player == 1) return {Vec2{kKeeperOut - half.x, 0} + scaled(kKeeperDrawn, ball), kKeeperRoams};
  const Vec2 kick_off = scaled(agent::Formation().theirs[player - 1], half);
  return {Vec2{-kBack * half.x, 0} + scaled(kFromKickOff, kick_off) + scaled(kFieldPlayerDrawn, ball),
          kFieldPlayerRoams};
}

/// What was told or seen of a robot `seconds` ago, and where it would be anyway, each by how sure it is.
Place weighed(const Place& usual, const Place& known, float seconds) {
  if (seconds >= kForgotten) return usual;
  const float known_variance = known.deviation * known.deviation + kRobotStrays * seconds;
  const float usual_variance = usual.deviation * usual.deviation;
  const float share = usual_variance / (usual_variance + known_variance);
  return {usual.position + share * (known.position - usual.position), std::sqrt(share * known_variance)};
}

float heading_to(Vec2 from, Vec2 to) { return from == to ? 0.f : angle_of(to - from); }

}  // namespace

BallGuess guess_ball(const Knowledge& knowledge) {
  const agent::Ball& own = knowledge.beliefs.ball;
  const Pose2& pose = knowledge.beliefs.pose.pose;
  const float own_age = age(knowledge.now, own.seen);
  BallGuess guess;
  if (own.seen != kNever) {
    const Vec2 facing = direction(pose.heading);
    guess.position = pose.position + turned(own.position, facing);
    guess.velocity = turned(own.velocity, facing);
    guess.deviation = std::min(std::sqrt(own.variance), kMostBall);
    guess.velocity_deviation = std::sqrt(own.velocity_variance);
    guess.seen = own.seen;
    guess.elsewhere = kBallLeaves * own_age;
    guess.by_own_eyes = true;
  }
  if (own_age <= kFreshEyes) return guess;

  // somebody may have seen it since
  for (const agent::Mate& mate : knowledge.beliefs.mates) {
    if (mate.sent == kNever || mate.ball_age == 0xffff) continue;
    const Tick seen = mate.sent - std::min<Tick>(mate.ball_age, mate.sent);
    if (guess.seen != kNever && seen <= guess.seen) continue;
    guess = {.position = mate.ball, .seen = seen};
  }
  if (guess.seen == kNever) return guess;
  // it has come to rest since, wherever that is
  guess.velocity = {};
  guess.velocity_deviation = 0;
  guess.deviation = kToldBall;
  guess.elsewhere = kElsewhere;
  return guess;
}

RobotGuess guess_robot(const Params& params, const Knowledge& knowledge, Vec2 ball, int robot) {
  const field::Field& field = params.rules.field;
  const int player = player_of(robot);
  const int own = knowledge.game.player;
  if (side_of(robot) == Side::home && player == own) {
    const agent::Pose& pose = knowledge.beliefs.pose;
    return {pose.pose, pose.deviation, pose.deviation_heading};
  }
  if (side_of(robot) == Side::home) {
    const agent::Mate& mate = knowledge.beliefs.mates[player < own ? player - 1 : player - 2];
    const float seconds = age(knowledge.now, mate.sent);
    const Place place = weighed(usual_place(field, player, ball), {mate.pose.position, kToldRobot}, seconds);
    if (seconds >= kForgotten)
      return {{place.position, heading_to(place.position, ball)}, place.deviation, kMostHeading};
    return {{place.position, mate.pose.heading}, place.deviation, grown(kToldRobot, kTurns, seconds, kMostHeading)};
  }
  const agent::Opponent& opponent = knowledge.beliefs.opponents[player - 1];
  const Place usual = usual_place(field, player, -ball);
  const Place place =
      weighed({-usual.position, usual.deviation}, {opponent.position, kSeenRobot}, age(knowledge.now, opponent.seen));
  return {{place.position, heading_to(place.position, ball)}, place.deviation, kMostHeading / 2};
}

}  // namespace sim::foresight
