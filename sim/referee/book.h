// What the referee writes down.
#pragma once

#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/math/random.h"
#include "sim/math/tick.h"
#include "sim/world/world.h"

namespace sim::referee {

struct Book {
  agent::Game::Phase phase = agent::Game::Phase::initial;
  agent::Game::SetPlay set_play = agent::Game::SetPlay::none;
  Side kicking = Side::home;  // whose kick-off or set play it is
  Side first_kick_off = Side::home;
  Side last_touch = Side::home;
  std::uint8_t kick_off_by = kNobody;   // index of the robot that kicked off and may not score yet; kNobody: any may
  std::uint8_t last_toucher = kNobody;  // index of the robot; kNobody: nobody since the ball was placed
  std::uint8_t half = 1;
  bool ball_free = true;                  // everybody may touch the ball
  Tick phase_since = 0;                   // when phase or set play last changed
  Tick playing_since = 0;                 // `phase_since` of before the last goal
  Tick clock = 0;                         // [ticks] of the half that have run
  Tick told_phase_since = 0;              // as the robots know it: goals are told late
  Tick last_touch_tick = 0;               // or when the ball was placed
  Vec2 last_touch_at;                     // [m, field] where the ball was then
  Vec2 ball_before;                       // [m, field] where the ball was in the last tick
  Tick still_since = 0;                   // since when everybody stands, in ready
  Tick stuck_since = 0;                   // since when the ball is about where `stuck_at` says, robots round it
  Vec2 stuck_at;                          // [m, field]; while the ball is not free: where it was placed
  std::uint8_t score[2] = {0, 0};         // by side
  std::int32_t packets[2] = {0, 0};       // sent by side
  std::uint16_t penalties[2] = {0, 0};    // given by side
  Tick penalised_until[kMaxRobots] = {};  // a removed robot may come back then; 0: not penalised
};

/// The clock of play runs: set plays included, kick-offs not yet taken too.
constexpr bool in_play(const Book& book) { return book.phase == agent::Game::Phase::playing; }

/// What a game is summed up by.
struct GameCounts {
  std::uint16_t kicks[2] = {0, 0};       // that touched the ball
  std::uint16_t whiffs[2] = {0, 0};      // that did not
  std::uint16_t shots[2] = {0, 0};       // kicks whose ball would roll into the goal
  std::uint32_t possession[2] = {0, 0};  // [ticks] in play since whose touch
  std::uint32_t in_play = 0;             // [ticks] in which the ball was in play
  std::uint32_t seen[kMaxRobots] = {};   // [ticks] in play in which a robot saw the ball
};

}  // namespace sim::referee
