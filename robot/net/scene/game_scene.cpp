#include "robot/net/scene/game_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "robot/core/clock.h"

namespace robot::net {
namespace {

namespace pb = foresight;

constexpr double kBodyHeight = 0.58;                   // [m] of a standing Nao
constexpr double kBodyWidth = 0.28;                    // [m] arms included
constexpr double kBallDiameter = 0.1;                  // [m] rules since 2016
constexpr double kBeliefAlpha = 0.5, kOldAlpha = 0.2;  // of a fresh belief and of an old one
constexpr std::uint64_t kOldNs = 3 * kSecond, kForgottenNs = 60 * kSecond;
constexpr int kMostRobots = 64;  // in one message: more are nonsense

/// Jerseys by TeamState.Colour, bright enough for the carpet, as in our own viewer.
std::optional<Colour> jersey_of(pb::TeamState::Colour colour) {
  switch (colour) {
    case pb::TeamState::COLOUR_BLUE: return colour_of(0x6fb1ff);
    case pb::TeamState::COLOUR_RED: return colour_of(0xe33b2e);
    case pb::TeamState::COLOUR_YELLOW: return colour_of(0xffe04a);
    case pb::TeamState::COLOUR_BLACK: return colour_of(0x20252b);
    case pb::TeamState::COLOUR_WHITE: return colour_of(0xf5f7f5);
    case pb::TeamState::COLOUR_GREEN: return colour_of(0x86e07a);
    case pb::TeamState::COLOUR_ORANGE: return colour_of(0xff9430);
    case pb::TeamState::COLOUR_PURPLE: return colour_of(0xc58bff);
    case pb::TeamState::COLOUR_BROWN: return colour_of(0xb07d4c);
    case pb::TeamState::COLOUR_GRAY: return colour_of(0xaab2ba);
    default: return {};
  }
}

/// A robot as it is drawn.
struct Body {
  double x = 0, y = 0;                 // [m, field]
  std::optional<double> heading = {};  // [rad, field]
  bool fallen = false;
  bool round = true;
  Colour colour = {};
  std::string words = {};  // above it
};

Entity entity_of(std::string id, const Body& body) {
  const double heading = body.heading.value_or(0), cosine = std::cos(heading), sine = std::sin(heading);
  const auto at = [&](double ahead, double z) { return Point3{body.x + ahead * cosine, body.y + ahead * sine, z}; };
  constexpr double kHead = 0.13;
  const double trunk = kBodyHeight - kHead;
  Entity entity{std::move(id), {}};
  // a fallen robot lies: its own z points forward, and its middle is as high as half its width
  const double pitch = body.fallen ? std::numbers::pi / 2 : 0;
  entity.shapes.push_back({.kind = body.round ? Shape::Kind::cylinder : Shape::Kind::box,
                           .place = body.fallen ? at(0, kBodyWidth / 2) : at(0, trunk / 2),
                           .size = {kBodyWidth, kBodyWidth, trunk},
                           .heading = heading,
                           .pitch = pitch,
                           .colour = body.colour});
  entity.shapes.push_back({.kind = Shape::Kind::ball,
                           .place = body.fallen ? at((trunk + kHead) / 2, kBodyWidth / 2) : at(0, trunk + kHead / 2),
                           .size = {kHead, kHead, kHead},
                           .heading = heading,
                           .colour = colour_of(0xf5f7f5, body.colour.alpha)});
  if (body.heading)
    entity.shapes.push_back({.kind = Shape::Kind::arrow,
                             .place = at(kBodyWidth / 2, 0.02),
                             .size = {0.2, 0.03, 0},
                             .heading = heading,
                             .colour = body.colour});
  entity.shapes.push_back({.kind = Shape::Kind::words,
                           .place = at(0, kBodyHeight + 0.17),
                           .size = {0, 0, 0.2},
                           .colour = colour_of(body.fallen ? 0xffe14d : 0xffffff, body.colour.alpha),
                           .words = body.words + (body.fallen ? " fallen" : "")});
  return entity;
}

/// A ball at a place of the field, with an arrow of its way in half a second if it rolls.
Entity ball_at(double x, double y, double velocity_x, double velocity_y, Colour colour) {
  Entity entity{"ball", {}};
  entity.shapes.push_back({.kind = Shape::Kind::ball,
                           .place = {x, y, kBallDiameter / 2},
                           .size = {kBallDiameter, kBallDiameter, kBallDiameter},
                           .colour = colour});
  const double way = std::hypot(velocity_x, velocity_y) / 2;
  if (way > 0.05 && way < 10)
    entity.shapes.push_back({.kind = Shape::Kind::arrow,
                             .place = {x, y, kBallDiameter / 2},
                             .size = {way, 0.03, 0},
                             .heading = std::atan2(velocity_y, velocity_x),
                             .colour = colour});
  return entity;
}

/// Returns a name like "robot 14/2"; without both numbers one that counts.
std::string id_of(const pb::GroundTruth::TrueRobot& robot, int index) {
  if (!robot.has_team() || !robot.has_player()) return "robot " + std::to_string(index + 1) + " without a number";
  return "robot " + std::to_string(robot.team()) + "/" + std::to_string(robot.player());
}

/// Returns how strong a belief of that age is drawn, or nothing for one that is too old.
std::optional<double> alpha_of(std::uint64_t seen_ns, std::uint64_t now_ns) {
  const std::uint64_t age_ns = now_ns > seen_ns ? now_ns - seen_ns : 0;
  if (age_ns > kForgottenNs) return {};
  return age_ns > kOldNs ? kOldAlpha : kBeliefAlpha;
}

Colour faded(Colour colour, double alpha) {
  colour.alpha = alpha;
  return colour;
}

bool turned(const pb::GameState& game) { return game.has_attacks_positive_x() && !game.attacks_positive_x(); }

}  // namespace

Liveries liveries_of(std::uint32_t home_team, const pb::GameState& game) {
  Liveries liveries{.home_team = home_team};
  const auto own = jersey_of(game.own().field_colour()), opponent = jersey_of(game.opponent().field_colour());
  if (!own || !opponent || game.own().field_colour() == game.opponent().field_colour()) return liveries;
  const bool own_is_home = game.own().number() == home_team;
  liveries.home = own_is_home ? *own : *opponent;
  liveries.away = own_is_home ? *opponent : *own;
  return liveries;
}

Scene truth_scene(const pb::GroundTruth& truth, const Liveries& liveries) {
  Scene scene;
  if (truth.has_ball())
    scene.push_back(ball_at(truth.ball().x(), truth.ball().y(), truth.ball().velocity_x(), truth.ball().velocity_y(),
                            colour_of(0xffffff)));
  for (int i = 0; i < std::min(truth.robots_size(), kMostRobots); ++i) {
    const pb::GroundTruth::TrueRobot& robot = truth.robots(i);
    const bool home = liveries.is_home(robot.team());
    scene.push_back(entity_of(id_of(robot, i),
                              {.x = robot.x(),
                               .y = robot.y(),
                               .heading = robot.has_heading() ? std::optional<double>(robot.heading()) : std::nullopt,
                               .fallen = robot.fallen(),
                               .round = home,
                               .colour = robot.has_team() ? liveries.of(home) : colour_of(0xaab2ba),
                               .words = robot.has_player() ? std::to_string(robot.player()) : "?"}));
  }
  return scene;
}

GroundPose pose_in_field(const pb::Pose& pose, const pb::GameState& game) {
  const double sign = turned(game) ? -1 : 1;
  return {sign * pose.x(), sign * pose.y(), pose.heading() + (turned(game) ? std::numbers::pi : 0)};
}

Scene belief_scene(const Believed& believed, const Liveries& liveries, std::uint64_t now_ns) {
  Scene scene;
  const GroundPose own = pose_in_field(believed.pose, believed.game);
  const bool home = liveries.is_home(believed.team);
  const Colour colour = faded(liveries.of(home), kBeliefAlpha);
  const bool fallen = believed.motion.fall() == pb::MotionStatus::FALL_FALLEN ||
                      believed.motion.fall() == pb::MotionStatus::FALL_GETTING_UP;
  scene.push_back(entity_of("self", {.x = own.x,
                                     .y = own.y,
                                     .heading = own.heading,
                                     .fallen = fallen,
                                     .round = home,
                                     .colour = colour,
                                     .words = std::to_string(believed.player)}));

  const auto ball_alpha = alpha_of(believed.ball.seen_ns(), now_ns);
  if (believed.ball.seen_ns() > 0 && ball_alpha) {
    const double cosine = std::cos(own.heading), sine = std::sin(own.heading);
    const auto turn = [&](double x, double y) { return Point3{x * cosine - y * sine, x * sine + y * cosine}; };
    const Point3 place = turn(believed.ball.x(), believed.ball.y());
    const Point3 velocity = turn(believed.ball.velocity_x(), believed.ball.velocity_y());
    scene.push_back(ball_at(own.x + place.x, own.y + place.y, velocity.x, velocity.y, faded(colour, *ball_alpha)));
  }

  for (int i = 0; i < std::min(believed.mates.teammates_size(), kMostRobots); ++i) {
    const pb::Teammate& mate = believed.mates.teammates(i);
    const auto alpha = alpha_of(mate.received_ns(), now_ns);
    if (!mate.has_pose() || !mate.active() || !alpha) continue;
    const GroundPose pose = pose_in_field(mate.pose(), believed.game);
    scene.push_back(entity_of("mate " + std::to_string(mate.player()), {.x = pose.x,
                                                                        .y = pose.y,
                                                                        .heading = pose.heading,
                                                                        .fallen = mate.fallen(),
                                                                        .round = home,
                                                                        .colour = faded(colour, *alpha),
                                                                        .words = std::to_string(mate.player())}));
  }

  for (int i = 0; i < std::min(believed.opponents.opponents_size(), kMostRobots); ++i) {
    const pb::Opponents::Opponent& opponent = believed.opponents.opponents(i);
    const auto alpha = alpha_of(opponent.seen_ns(), now_ns);
    if (!alpha) continue;
    const double sign = turned(believed.game) ? -1 : 1;
    const std::string number = opponent.has_player() ? std::to_string(opponent.player()) : "?";
    const std::string id = opponent.has_player() ? number : "without a number " + std::to_string(i + 1);
    scene.push_back(entity_of("opponent " + id, {.x = sign * opponent.x(),
                                                 .y = sign * opponent.y(),
                                                 .round = !home,
                                                 .colour = faded(liveries.of(!home), *alpha),
                                                 .words = number}));
  }
  return scene;
}

}  // namespace robot::net
