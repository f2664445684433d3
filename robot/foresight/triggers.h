// The reasons for which the captain asks foresight.
#pragma once

#include <cstdint>

#include "robot/bridge/from_messages.h"

namespace robot::foreseeing {

namespace pb = ::foresight;

/// Returns the player that chooses for the whole team: the unpenalised field player of the lowest number. Returns 0 if
/// no player plays or the GameController has not reported the players.
int captain_of(const pb::GameState& game);

/// Finds reasons to ask in a sequence of moments. Used by one thread.
class Triggers {
 public:
  static constexpr std::uint64_t kLeastApartNs =
      2'000'000'000;  // [ns] of game time between questions, so that strategies do not flutter

  /// `goal_x` is the place of the opponents' goal line [m, team_field].
  explicit Triggers(float goal_x) : goal_x_(goal_x) {}

  /// Returns the reason to ask now, or null. In play there is one at the latest `period_ns` of game time after the last
  /// question, at the beginning, and after time was moved back. A reason holds until asked(), or until the state is the
  /// same as at the last question. There are reasons only for the captain, in READY, SET and
  /// PLAYING, and not in a shoot-out.
  const char* look(const bridge::Recollection& now, std::uint64_t period_ns);

  /// Notes that the question was asked, at the moment of the last look().
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
  Seen answered_;  // at the last question, or while not playing
  std::uint64_t seen_ns_ = 0, asked_ns_ = 0;
};

/// Reports whether an opponent stands between the ball and the middle of the goal, so near that a kick would hit it.
bool way_is_blocked(const bridge::Recollection& now, float goal_x);

}  // namespace robot::foreseeing
