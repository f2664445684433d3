// The referee's notes.
#pragma once

#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/math/random.h"
#include "sim/math/tick.h"
#include "sim/world/world.h"

namespace sim::referee {

/// The state of the rules: phase, score, clock and penalties.
struct Book {
  agent::Game::Phase phase = agent::Game::Phase::initial;
  agent::Game::SetPlay set_play = agent::Game::SetPlay::none;
  Side kicking = Side::home;  // side that has the kick-off or set play
  Side first_kick_off = Side::home;
  Side last_touch = Side::home;
  std::uint8_t kick_off_by = kNobody;   // index of the robot that kicked off and may not score yet; kNobody: all may
  std::uint8_t last_toucher = kNobody;  // index of the robot; kNobody: no touch since the ball was placed
  std::uint8_t half = 1;
  bool ball_free = true;                  // both sides may touch the ball
  Tick phase_since = 0;                   // last change of phase or set play
  Tick playing_since = 0;                 // `phase_since` from before the last goal
  Tick clock = 0;                         // [ticks] played of this half
  Tick told_phase_since = 0;              // tick at which the robots receive the phase: later after a goal
  Tick last_touch_tick = 0;               // last touch or placement of the ball
  Vec2 last_touch_at;                     // [m, field] ball at that moment
  Vec2 ball_before;                       // [m, field] ball in the last tick
  Tick still_since = 0;                   // in READY: since when all robots stand
  Tick stuck_since = 0;                   // since when the ball has stayed near `stuck_at` with robots round it
  Vec2 stuck_at;                          // [m, field]; while the ball is not free: where it was placed
  std::uint8_t score[2] = {0, 0};         // by side
  std::int32_t packets[2] = {0, 0};       // sent, by side
  std::uint16_t penalties[2] = {0, 0};    // received, by side
  Tick penalised_until[kMaxRobots] = {};  // return of a removed robot; 0: not penalised
};

/// Reports whether the phase is PLAYING. This includes set plays and a kick-off that nobody has taken yet.
constexpr bool in_play(const Book& book) { return book.phase == agent::Game::Phase::playing; }

/// The statistics of a game. Pairs are by Side.
struct GameCounts {
  std::uint16_t kicks[2] = {0, 0};       // kicks that hit the ball
  std::uint16_t whiffs[2] = {0, 0};      // kicks that missed it
  std::uint16_t shots[2] = {0, 0};       // kicks after which the ball would roll into the goal
  std::uint32_t possession[2] = {0, 0};  // [ticks] in play with the last touch by this side
  std::uint32_t in_play = 0;             // [ticks] in play
  std::uint32_t seen[kMaxRobots] = {};   // [ticks] in play in which a robot saw the ball
};

}  // namespace sim::referee
