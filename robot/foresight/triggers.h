// When the captain asks foresight of its own accord.
#pragma once

#include <cstdint>

#include "robot/foresight/knowledge.h"

namespace robot::foreseeing {

/// The player that chooses for the whole team: the unpenalised field player of the lowest number. 0: nobody plays, or the
/// GameController has not told who does.
int captain_of(const pb::GameState& game);

/// Looks at one moment after the other and says when there is a reason to ask. Used by one thread.
class Triggers {
 public:
  static constexpr std::uint64_t kLeastApartNs = 2'000'000'000;  // strategies do not flutter

  /// Why to ask now; nullptr: no reason. `period_ns` after the last question at the latest there is one, while the game is
  /// in play. Only ever for the captain, and only in READY, SET and PLAYING.
  const char* look(const Recollection& now, std::uint64_t period_ns);

 private:
  struct Seen {
    int state = -1, set_play = 0;
    std::uint32_t own_score = 0, opponent_score = 0;
    bool ball_lost = false;
    bool blocked = false;
  };
  Seen last_;
  std::uint64_t asked_ns_ = 0;
};

/// An opponent stands between the ball and the others' goal, so near that a kick would meet it.
bool way_is_blocked(const Recollection& now);

}  // namespace robot::foreseeing
