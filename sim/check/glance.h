// The facts of one tick of a game: happenings and quantities, from the view of the home side.
//
// "our" is the home side, "their" the away side. Lengths are in team_field of the home side: +x is towards the goal of
// the away side, in both halves.
#pragma once

#include <string_view>

#include "sim/match/state.h"
#include "sim/referee/event.h"

namespace sim::check {

/// One tick as conditions see it.
struct Glance {
  const State* start;  // the first state of the game
  const State* now;    // the state after the tick
  const referee::Events* events;
  std::uint8_t toucher = kNobody;  // robot with a new touch of the ball in this tick
  std::uint8_t before = kNobody;   // robot of the touch before it
  int shots[2] = {0, 0};           // by Side, in this tick

  /// Returns the time since the start [s].
  float time() const { return static_cast<float>(now->world.tick - start->world.tick) * kTickDuration; }
};

/// A thing that happens in single ticks.
struct Happening {
  const char* name;
  const char* about;
  bool (*holds)(const Glance& glance);
};

/// A number that every tick has, or NaN.
struct Quantity {
  const char* name;
  const char* unit;
  float least, most;  // of a threshold, in `unit`
  const char* about;
  float (*compute)(const Glance& glance);
};

int happening_count();
int quantity_count();
const Happening& happening(int index);
const Quantity& quantity(int index);

/// Follows a game and makes the glances. A touch is new if it is that of another robot, or 0.5 s after the last one.
class Observer {
 public:
  /// `start` outlives the observer.
  explicit Observer(const State& start) : start_(start) {}

  /// Call once after each step. The glance refers to the arguments.
  Glance look(const State& now, const referee::Events& events);

 private:
  const State& start_;
  std::uint8_t toucher_ = kNobody;
  Tick touched_ = 0;
  int shots_[2] = {-1, -1};  // so far; -1: those of `start`
};

}  // namespace sim::check
