// The referee's decisions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/math/tick.h"
#include "sim/math/vec2.h"
#include "sim/world/world.h"

namespace sim::referee {

/// One decision of the referee.
struct Event {
  enum class Kind : std::uint8_t {
    // phases
    ready,
    set,
    playing,
    ball_free,
    // the ball
    goal,
    out,
    kick_in,
    goal_kick,
    corner_kick,
    // offences
    pushing,
    illegal_defender,
    leaving,
    local_stuck,
    global_stuck,
    illegal_kick,
    illegal_position,
    // others
    returned,   // a penalised robot comes back
    half_time,  // sides have changed, all robots stand at the touch lines again, nobody is penalised
    end,
    placed,  // a robot with an illegal place in SET was carried to the nearest legal one
  };
  Kind kind;
  Side side = Side::home;        // side that scored, has the kick, or owns the robot
  std::uint8_t robot = kNobody;  // index; kNobody: not about one robot
  Tick tick = 0;
  Vec2 at;                                                     // [m, field] of the ball or the robot
  agent::Game::SetPlay set_play = agent::Game::SetPlay::none;  // that ran until this decision
};

/// Reports whether the decision says that the ball left the field without a goal, by the rules of any year.
constexpr bool is_out(Event::Kind kind) {
  using Kind = Event::Kind;
  return kind == Kind::out || kind == Kind::kick_in || kind == Kind::goal_kick || kind == Kind::corner_kick;
}

/// Returns the words for a report: "goal", "kick-in", ...
const char* name_of(Event::Kind kind);

/// The decisions of one step. Events beyond the capacity are counted and dropped; this cannot happen, because each rule
/// decides at most once a step.
struct Events {
  std::array<Event, 32> list;
  int count = 0;

  const Event* begin() const { return list.data(); }
  const Event* end() const { return list.data() + std::min(count, static_cast<int>(list.size())); }
  void add(const Event& event) {
    if (count < static_cast<int>(list.size())) list[static_cast<std::size_t>(count)] = event;
    ++count;
  }
};

}  // namespace sim::referee
