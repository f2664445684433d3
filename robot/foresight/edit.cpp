#include "robot/foresight/edit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "robot/core/text.h"
#include "robot/foresight/question.h"
#include "sim/match/situation.h"
#include "sim/match/step.h"

namespace robot::foreseeing {
namespace {

using sim::Vec2;

bool is_within(float value, float least, float most) { return value >= least && value <= most; }

/// Returns the place [m]. A place off the field is refused later.
bool is_sane(float place) { return is_within(place, -100, 100); }

sim::Side side_of(const pb::WhatIf::MovedRobot& robot) { return robot.opponent() ? sim::Side::away : sim::Side::home; }

/// Returns the body's index of a moved robot, in a situation whose own side is home.
int index_of(const pb::WhatIf::MovedRobot& robot, const bridge::PlayerMaps& lineups) {
  return sim::robot_of(side_of(robot), lineups.of(side_of(robot)).place_of(robot.player()));
}

Result<void> check_place(const sim::field::Field& field, const std::string& who, Vec2 at, float room) {
  const std::string where =
      formatted("%s at %g, %g", who.c_str(), static_cast<double>(at.x), static_cast<double>(at.y));
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !sim::field::inside_field(field, at, room))
    return Error{where + " is not on the field"};
  for (int post = 0; post < 4; ++post)
    if (sim::distance(sim::field::post_of(field, post), at) < room + field.post_radius)
      return Error{where + " is in a goalpost"};
  return {};
}

/// Checks that no edited robot overlaps another robot or the ball.
Result<void> check_apart(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups,
                         const sim::ContactModel& contact, const sim::World& world) {
  std::string problem;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    const int robot = index_of(moved, lineups);
    const Vec2 at = world.bodies[robot].position;
    sim::for_each_robot(world.players, [&](int other) {
      const sim::Body& body = world.bodies[other];
      if (other == robot || body.doing == sim::Body::Doing::removed) return;
      const bool moved_too = std::any_of(edit.robots().begin(), edit.robots().end(),
                                         [&](const auto& one) { return index_of(one, lineups) == other; });
      // the place of a robot that was not moved is only a belief
      if (moved_too && sim::distance(body.position, at) < 2 * contact.robot_radius)
        problem = name_of(moved) + " stands in another robot";
    });
    if (edit.has_ball() && sim::distance(world.ball.position, at) < contact.robot_radius)
      problem = name_of(moved) + " stands on the ball";
  }
  if (problem.empty()) return {};
  return Error{problem};
}

}  // namespace

void tell(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, sim::foresight::Knowledge& knowledge) {
  sim::agent::Beliefs& beliefs = knowledge.beliefs;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    if (moved.opponent() || lineups.own.place_of(moved.player()) != knowledge.game.player) continue;
    if (!is_sane(moved.x()) || !is_sane(moved.y()) || !is_within(moved.heading(), -sim::kPi, sim::kPi)) continue;
    beliefs.pose = {.pose = {{moved.x(), moved.y()}, sim::normalized(moved.heading())}};
  }
  if (!edit.has_ball() || !is_sane(edit.ball().x()) || !is_sane(edit.ball().y())) return;
  const sim::Pose2& pose = beliefs.pose.pose;
  const Vec2 to_ball = Vec2{edit.ball().x(), edit.ball().y()} - pose.position;
  beliefs.ball = {.position = sim::turned_back(to_ball, sim::direction(pose.heading)), .seen = knowledge.now};
}

Result<void> apply(const pb::WhatIf::Edit& edit, const bridge::PlayerMaps& lineups, const sim::Params& params,
                   sim::foresight::Situation& situation) {
  sim::State& state = situation.state;
  sim::World& world = state.world;
  const sim::ContactModel& contact = params.teams[0].models.contact;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    if (const bridge::PlayerMap& lineup = lineups.of(side_of(moved)); lineup.place_of(moved.player()) == 0)
      return Error{name_of(moved) + " does not play: players are " + lineup.text()};
    const Vec2 at{moved.x(), moved.y()};
    if (Result<void> placed = check_place(params.rules.field, name_of(moved), at, contact.robot_radius); !placed)
      return placed;
    if (!is_within(moved.heading(), -sim::kPi, sim::kPi))
      return Error{formatted("%s: 'heading' must be -3.1416 .. 3.1416 [rad], got %g", name_of(moved).c_str(),
                             static_cast<double>(moved.heading()))};
    const int robot = index_of(moved, lineups);
    sim::Body& body = world.bodies[robot];
    body = {};
    body.position = at;
    body.heading = moved.heading();
    body.facing = sim::direction(moved.heading());
    state.book.penalised_until[robot] = 0;
    sim::enter(params, state, robot);
    situation.doubt.position[robot] = situation.doubt.heading[robot] = 0;
  }
  if (edit.has_ball()) {
    const Vec2 at{edit.ball().x(), edit.ball().y()};
    if (Result<void> placed = check_place(params.rules.field, "the ball", at, 0); !placed) return placed;
    sim::place(world.ball, at);
    situation.doubt.ball = situation.doubt.ball_velocity = situation.doubt.ball_elsewhere = 0;
    situation.doubt.ball_by_own_eyes = false;
    constexpr float kKnown = 0.1f;  // [m] and [m/s]
    sim::know_ball(state, world.tick, kKnown);
  }
  if (Result<void> apart = check_apart(edit, lineups, contact, world); !apart) return apart;
  if (edit.own_score() > 255 || edit.opponent_score() > 255)
    return Error{"a score must be 0 .. 255, got " + std::to_string(std::max(edit.own_score(), edit.opponent_score()))};
  if (edit.has_own_score()) state.book.score[0] = static_cast<std::uint8_t>(edit.own_score());
  if (edit.has_opponent_score()) state.book.score[1] = static_cast<std::uint8_t>(edit.opponent_score());
  if (!edit.has_seconds_remaining()) return {};
  const float half = params.rules.half_duration;
  if (!is_within(edit.seconds_remaining(), 0, half))
    return Error{formatted("'seconds_remaining' must be 0 .. %g [s], got %g", static_cast<double>(half),
                           static_cast<double>(edit.seconds_remaining()))};
  state.book.clock = sim::ticks(half - edit.seconds_remaining());
  return {};
}

}  // namespace robot::foreseeing
