// When the captain asks foresight of its own accord.
#pragma once

#include <cstdint>

#include "robot/bridge/from_messages.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// The player that chooses for the whole team: the unpenalised field player of the lowest number. 0: nobody plays, or the
/// GameController has not told who does.
int captain_of(const pb::GameState& game);

/// Looks at one moment after the other and says when there is a reason to ask. Used by one thread.
class Triggers {
 public:
  static constexpr std::uint64_t kLeastApartNs = 2'000'000'000;  // of game time: strategies do not flutter

  /// The others' goal is at x = `goal_x` [m, team_field].
  explicit Triggers(float goal_x) : goal_x_(goal_x) {}

  /// Why to ask now; nullptr: no reason. `period_ns` of game time after the last question at the latest there is one,
  /// while the game is in play; and where time was moved back, as at the beginning. A reason stays one until asked() or
  /// until things are again as they were at the last question. Only ever for the captain, and only in READY, SET and
  /// PLAYING of a game that is no shoot-out.
  const char* look(const bridge::Recollection& now, std::uint64_t period_ns);

  /// The question was asked, at the moment that look() saw last.
  void asked();

 private:
  struct Seen {
    int state = -1, set_play = 0;
    std::uint32_t own_score = 0, opponent_score = 0;
    bool ball_lost = false;
    bool blocked = false;
  };
  const float goal_x_;
  Seen seen_;      // at the last look
  Seen answered_;  // when it asked last, or did not play
  std::uint64_t seen_ns_ = 0, asked_ns_ = 0;
};

/// An opponent stands between the ball and the middle of the others' goal, so near that a kick would meet it.
bool way_is_blocked(const bridge::Recollection& now, float goal_x);

}  // namespace robot::foreseeing
