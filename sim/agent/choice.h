// Which strategy of its playbook a team plays: one robot, the captain, chooses; the others follow what they hear.
//
// All robots of a team have the same strategies in the same order, the first of which is the default.
#pragma once

#include <cstdint>

namespace sim::agent {

inline constexpr std::uint8_t kNoStrategy = 0xff;

/// What a robot plays, as it tells it in two bytes of each team message.
struct Choice {
  std::uint8_t strategy = kNoStrategy;  // index in the playbook; kNoStrategy: nobody chose, it plays the default
  std::uint8_t epoch = 0;               // how often captains have chosen anew, modulo 256

  constexpr int played() const { return strategy == kNoStrategy ? 0 : strategy; }
};

/// The epoch was chosen after `than`; of two that are 128 apart neither was.
constexpr bool is_newer(std::uint8_t epoch, std::uint8_t than) {
  return static_cast<std::int8_t>(static_cast<std::uint8_t>(epoch - than)) > 0;
}

/// Takes over what a teammate told, if it is newer than one's own or the captain's word about the same epoch; whoever
/// never had a choice takes the first. Who let go of one takes it back from the captain alone: those who follow would
/// else tell it to each other for ever. True: `own` is the team's choice as of that message.
constexpr bool follow(const Choice& heard, bool by_captain, Choice& own) {
  if (heard.strategy == kNoStrategy) return false;
  const bool has_none = own.strategy == kNoStrategy;
  const bool never_had_one = has_none && own.epoch == 0;
  const bool by_right = by_captain && (has_none || heard.epoch == own.epoch);
  if (!never_had_one && !by_right && !is_newer(heard.epoch, own.epoch)) return false;
  own = heard;
  return true;
}

/// What nobody confirmed for too long is played no more; its epoch is kept, so that it is known again.
constexpr void let_go(Choice& own) { own.strategy = kNoStrategy; }

/// The captain's choice: a new epoch begins with another strategy only.
constexpr void choose(std::uint8_t strategy, Choice& own) {
  if (strategy == own.strategy) return;
  own = {strategy, static_cast<std::uint8_t>(own.epoch + 1)};
}

}  // namespace sim::agent
