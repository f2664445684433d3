// A made-up course of a game: states and events, tick by tick, without a simulation.
#pragma once

#include <functional>
#include <vector>

#include "sim/check/glance.h"

namespace sim::check {

/// A course of ticks. Robots home/1..4 and away/1..4 stand at the touch lines, the ball lies in the middle.
class Course {
 public:
  Course() {
    start_.world.players = 4;
    for_each_robot(4, [&](int robot) { start_.world.bodies[robot].position = {0, 3}; });
    now_ = start_;
  }

  State& start() { return start_; }
  State& now() { return now_; }

  /// Calls change(state, events) for the next tick, and see(glance) with its glance.
  void tick(const std::function<void(State&, referee::Events&)>& change,
            const std::function<void(const Glance&)>& see) {
    events_.count = 0;
    now_.world.touched = kNobody;
    change(now_, events_);
    ++now_.world.tick;
    see(observer_.look(now_, events_));
  }
  /// Lets ticks pass in which nothing happens.
  void wait(float seconds, const std::function<void(const Glance&)>& see) {
    for (Tick i = 0; i < ticks(seconds); ++i) tick([](State&, referee::Events&) {}, see);
  }
  void touch(Side side, int player, const std::function<void(const Glance&)>& see) {
    tick([&](State& state,
             referee::Events&) { state.world.touched = static_cast<std::uint8_t>(robot_of(side, player)); },
         see);
  }
  void event(referee::Event::Kind kind, Side side, const std::function<void(const Glance&)>& see, int robot = kNobody) {
    tick(
        [&](State& state, referee::Events& events) {
          events.add({.kind = kind,
                      .side = side,
                      .robot = static_cast<std::uint8_t>(robot),
                      .tick = state.world.tick,
                      .at = {}});
        },
        see);
  }

 private:
  State start_, now_;
  referee::Events events_;
  Observer observer_{start_};
};

}  // namespace sim::check
