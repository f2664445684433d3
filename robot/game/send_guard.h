// Whether we may send: never in the name of somebody who sends for himself, never more than the rules allow.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// Counts the team's messages and watches the GameController's budget. Used by one thread; no clock of its own.
///
/// Once it has stopped it stays so until the program starts again: a team that sends too much loses all its goals, and a
/// robot that sends twice does so every time.
class SendGuard {
 public:
  /// Messages kept for the end of the game, as B-Human keeps them.
  static constexpr std::uint32_t kReserve = 30;

  /// Between two messages of one robot [ns], at least.
  static constexpr std::uint64_t kLeastIntervalNs = 1'000'000'000;

  /// By how many messages the budget may fall beyond what was counted: packets get lost on the way to us, and not on the
  /// way to the GameController.
  static constexpr std::uint32_t slack(std::uint32_t counted) { return 10 + counted / 4; }

  /// The newest packet of the GameController. Formats without a budget (before 14) set none.
  void hear(const pb::GameState& game);

  /// A message of our team was heard, or sent by us.
  void count() { ++counted_; }

  /// Somebody else sends in our name, `who`.
  void hear_double(const std::string& who);

  /// True where a team message may go out: the game runs, nothing has stopped us, and the last one, sent at `last_ns`
  /// (0: never), is so long ago that the budget lasts to the end of the game if all players do the same.
  bool may_send(std::uint64_t now_ns, std::uint64_t last_ns) const;

  /// Why nothing is sent any more, in one sentence; empty while all is well.
  const std::string& stopped() const { return stopped_; }

 private:
  std::uint64_t interval_ns() const;

  pb::GameState game_;
  std::uint32_t counted_ = 0, spent_ = 0;  // [messages] of the team, since the budget was heard first
  std::string stopped_;
};

}  // namespace robot::game
