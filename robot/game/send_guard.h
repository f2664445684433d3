// Permission to send team messages: never for a player for which another program sends,
// never more than the rules allow.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// A guard that counts the team's messages and watches the GameController's budget.
/// Used by one thread; it has no clock.
///
/// Once it has stopped, it stays stopped until the program restarts. A team that sends too much loses all its goals,
/// and a second sender with our number does not go away.
class SendGuard {
 public:
  /// Messages that are kept for the end of the game, as B-Human does.
  static constexpr std::uint32_t kReserve = 30;

  /// The shortest interval between two messages of one robot [ns].
  static constexpr std::uint64_t kLeastIntervalNs = 1'000'000'000;

  /// Returns how far the budget may fall below our count [messages]. Packets get lost on the way to us
  /// that do reach the GameController.
  static constexpr std::uint32_t slack(std::uint32_t counted) { return 10 + counted / 4; }

  /// Takes the newest packet of the GameController. Formats before 14 have no budget.
  void hear(const pb::GameState& game);

  /// Counts a message of our team that was received or sent.
  void count() { ++counted_; }

  /// Stops sending because `who` also sends with our number.
  void hear_double(const std::string& who);

  /// Returns true if a team message may be sent: the game runs, the guard has not stopped, and the last message, at
  /// `last_ns` (0: never), is old enough. At that rate the budget of all players lasts to the end of the game.
  bool may_send(std::uint64_t now_ns, std::uint64_t last_ns) const;

  /// Returns the reason why sending has stopped, in one sentence, or an empty string while it has not.
  const std::string& stopped() const { return stopped_; }

 private:
  std::uint64_t interval_ns() const;

  pb::GameState game_;
  std::uint32_t counted_ = 0, spent_ = 0;  // [messages] of the team, since the first packet with a budget
  std::string stopped_;
};

}  // namespace robot::game
