// The schedule of a game in lanes: one robot in each. Internal to sim/match.
#pragma once

#include "sim/match/due.h"
#include "sim/math/lanes.h"

namespace sim {

/// The schedule of all robots of a game.
struct Dates {
  const Schedule& schedule;
  Tick now;
  Some present;            // robots of this game
  Tick moved[kMaxRobots];  // Body::moved
};

/// The members of Due, spread over lanes: their union, and the least tick, are those of the game.
struct DueLanes {
  Lane<Some> moves, turns, radios;
  Lane<Tick> later;
};

/// Finds those of the robots from `first` on that are due. Bit 0 is `first`.
inline void find_from(int first, const Dates& dates, DueLanes& due) {
  constexpr Lane<Some> kBit{1, 2, 4, 8, 16, 32, 64, 128};
  const Tick now = dates.now;
  const Some present = dates.present >> first;
  const Tick *const turns = dates.schedule.turn + first, *const radios = dates.schedule.radio + first;
  const Tick* const moved = dates.moved + first;
  SIM_FOR_LANES(i) {
    const Some bit = present & kBit[i];
    const Tick turn = turns[i], radio = radios[i], rest = (moved[i] - now) & 0xff;
    const Tick move = turn == kNever ? kNever : now + rest, next = move < radio ? move : radio;
    const Some has_turn = turn <= now ? bit : 0, talks = radio <= now ? bit : 0;
    const Some moves = rest == 0 ? bit : has_turn;
    due.moves[i] = moves;
    due.turns[i] = has_turn;
    due.radios[i] = talks;
    due.later[i] = (moves | talks) == bit ? kNever : next;
  }
}

/// Finds the robots that are due.
inline void find_due(const Dates& dates, Due& due) {
  // two blocks hold all robots; some are in both
  constexpr int kSecond = kMaxRobots - kLanes;
  static_assert(0 <= kSecond && kSecond <= kLanes);
  DueLanes first, second;
  find_from(0, dates, first);
  find_from(kSecond, dates, second);
  Some moves = 0, turns = 0, radios = 0;
  Tick later = kNever;
  for (int i = 0; i < kLanes; ++i) moves |= first.moves[i] | second.moves[i] << kSecond;
  for (int i = 0; i < kLanes; ++i) turns |= first.turns[i] | second.turns[i] << kSecond;
  for (int i = 0; i < kLanes; ++i) radios |= first.radios[i] | second.radios[i] << kSecond;
  for (int i = 0; i < kLanes; ++i) {
    const Tick next = first.later[i] < second.later[i] ? first.later[i] : second.later[i];
    later = next < later ? next : later;
  }
  due.moves = moves, due.turns = turns, due.radios = radios, due.later = later;
}

}  // namespace sim
