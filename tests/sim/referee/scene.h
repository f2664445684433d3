// A game without agents: tests place ball and robots and check the referee's decisions.
#pragma once

#include <string>
#include <vector>

#include "sim/referee/referee.h"

namespace sim::referee {

field::Rules rules_2012();
field::Rules rules_2025();

struct Scene {
  field::Rules rules;
  BallModel ball_model{
      .radius = 0.05f, .deceleration = 0.3f, .post_restitution = 0.5f, .robot_restitution = 0.4f, .stop_speed = 0.01f};
  ContactModel contact{.robot_radius = 0.15f,
                       .foot_radius = 0.1f,
                       .lying_radius = 0.3f,
                       .official_radius = 0.2f,
                       .push_deviation = 0.5f};
  World world;
  Book book;
  GameCounts counts;
  std::vector<Event> events;  // all so far

  explicit Scene(const field::Rules& given, std::uint64_t seed = 1);

  RefereeParams params() const { return {rules, ball_model, contact}; }
  Ball& ball() { return world.ball; }
  Body& robot(Side side, int player) { return world.bodies[robot_of(side, player)]; }

  /// Plays one tick without motion and without a touch of the ball.
  void pass();
  void pass(Tick count) {
    for (Tick i = 0; i < count; ++i) pass();
  }
  void pass_seconds(float seconds) { pass(ticks(seconds)); }

  /// Plays from a fresh scene until everybody may touch the ball, all robots at the touch lines. Clears the events.
  void start_play();
  /// Plays one tick in which the robot touches the ball.
  void touch(Side side, int player);
  /// Moves the ball from one place to another in one tick. The robot is the last that touched it and does nothing else.
  void carry(Side side, int player, Vec2 from, Vec2 to);
  /// Makes the robot stand there.
  void stand(Side side, int player, Vec2 at);

  /// Returns the names of the events since the last call, each with its side if it has one: "goal home".
  std::vector<std::string> told();

 private:
  std::size_t read_ = 0;
};

using Names = std::vector<std::string>;

}  // namespace sim::referee
