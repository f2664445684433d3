// Whether a game is in progress: from READY to FINISHED of a real GameController.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// Follows the game state from version to version. update() belongs to one thread, in_progress() to any.
///
/// A match begins with READY, or with SET or PLAYING for a robot that comes late. It ends with FINISHED, or with INITIAL,
/// when somebody began anew. A time-out does not end it, nor does STANDBY. Another half or opponent is another match.
class Match {
 public:
  /// A GameController that is not heard for so long has been switched off [ns]. Until then silence means nothing: a robot
  /// may lose the wireless network for minutes, and must not take that for the end of the game.
  static constexpr std::uint64_t kSilenceNs = 20ull * 60 * 1'000'000'000;

  enum class Change {
    none,
    began,
    ended,
    another,  // one ended and the next began
  };

  /// Looks at the newest game state at `now_ns`; the same one may be looked at again and again. Simulated ones count for
  /// nothing.
  Change update(const pb::GameState& game, std::uint64_t now_ns);

  /// True while services from beyond this machine should answer "game in progress".
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

/// True in READY, SET and PLAYING.
bool under_way(pb::GameState::State state);

/// What the recording of a match is called: "A_vs-5_half-2_14-3_0123abcd" for field "A", opponent 5, the second half,
/// robot "14/3" and that build. An empty field is left out; the shoot-out is "shoot-out", overtime "overtime-1".
std::string session_name(const pb::GameState& game, std::string_view field, std::string_view build);

}  // namespace robot::game
