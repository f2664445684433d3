// The strategy that a team plays: one robot, the captain, chooses; the others follow the messages that they hear.
//
// All robots of a team have the same strategies in the same order. The first is the default.
#pragma once

#include <cstdint>

namespace sim::agent {

inline constexpr std::uint8_t kNoStrategy = 0xff;

/// The strategy that a robot plays: two bytes of each team message.
struct Choice {
  std::uint8_t strategy = kNoStrategy;  // index in the playbook; kNoStrategy: nobody chose, the default is played
  std::uint8_t epoch = 0;               // number of changes by captains, modulo 256

  constexpr int played() const { return strategy == kNoStrategy ? 0 : strategy; }
};

/// Returns whether `epoch` was chosen after `than`. Of two epochs 128 apart neither is newer.
constexpr bool is_newer(std::uint8_t epoch, std::uint8_t than) {
  return static_cast<std::int8_t>(static_cast<std::uint8_t>(epoch - than)) > 0;
}

/// Takes over a teammate's choice if it is newer than the own one, or the captain's choice of the same epoch. A robot
/// that never had a choice takes the first. A robot that let go of one takes it back from the captain only; otherwise
/// the followers would keep it alive among themselves for ever. Returns true when `own` is
/// the team's choice of that message.
constexpr bool follow(const Choice& heard, bool by_captain, Choice& own) {
  if (heard.strategy == kNoStrategy) return false;
  const bool has_none = own.strategy == kNoStrategy;
  const bool never_had_one = has_none && own.epoch == 0;
  const bool by_right = by_captain && (has_none || heard.epoch == own.epoch);
  if (!never_had_one && !by_right && !is_newer(heard.epoch, own.epoch)) return false;
  own = heard;
  return true;
}

/// Drops a choice that nobody confirmed for too long. Keeps its epoch, so that the choice is recognised later.
constexpr void let_go(Choice& own) { own.strategy = kNoStrategy; }

/// Makes the captain's choice. Only another strategy begins a new epoch.
constexpr void choose(std::uint8_t strategy, Choice& own) {
  if (strategy == own.strategy) return;
  own = {strategy, static_cast<std::uint8_t>(own.epoch + 1)};
}

}  // namespace sim::agent
