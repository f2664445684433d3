// Detection of a game in progress: from READY to FINISHED of a real GameController.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// A follower of the game state. One thread calls update(); any thread may call in_progress().
///
/// A packet in an unreadable format means that a match may be in progress, so it begins one. A match that has begun so
/// ends with a readable INITIAL or FINISHED, or after the long silence.
///
/// A match begins with READY, or with SET or PLAYING for a robot that joins late. It ends with FINISHED, or with
/// INITIAL after a restart. A time-out or STANDBY does not end it. Another half or another opponent is another match.
class Match {
 public:
  /// After this silence the GameController counts as switched off [ns]. A shorter silence means nothing: a robot may
  /// lose the wireless network for minutes, and that is not the end of the game.
  static constexpr std::uint64_t kSilenceNs = 20ull * 60 * 1'000'000'000;

  enum class Change {
    none,
    began,
    ended,
    another,  // one ended and the next began
  };

  /// Follows the newest game state at `now_ns`; the same state may be passed many times. Simulated games are ignored.
  Change update(const pb::GameState& game, std::uint64_t now_ns);

  /// Returns true while requests from other machines should get the answer "game in progress".
  bool in_progress() const { return in_progress_.load(std::memory_order_acquire); }

 private:
  struct Identity {
    std::uint32_t opponent = 0, half = 0;
    bool shoot_out = false;

    bool operator==(const Identity&) const = default;
  };

  Change move_to(bool in_progress);

  std::atomic<bool> in_progress_ = false;
  Identity identity_;
};

/// Returns true for READY, SET and PLAYING.
bool under_way(pb::GameState::State state);

/// Returns the name of a match's recording: "A_vs-5_half-2_14-3_0123abcd" for field "A", opponent 5, the second half,
/// robot "14/3" and that build. An empty field is left out; the shoot-out is "shoot-out", overtime "overtime-1", and an
/// unreadable format 21 "format-21".
std::string session_name(const pb::GameState& game, std::string_view field, std::string_view build);

}  // namespace robot::game
