// A robot's beliefs at one decision, in the form that features and skills use.
#pragma once

#include <cstdint>

#include "sim/agent/behaviour.h"
#include "sim/agent/settings.h"

namespace sim::agent {

/// [s] An opponent unseen for longer is ignored.
inline constexpr float kOpponentMemory = 3;
inline constexpr int kMaxFeatures = 256;  // ours and the team's own; a multiple of 64
inline constexpr int kMaxOwnFeatures = 128;

/// The view of one decision. Features are computed on demand and once (features.h).
struct View {
  View(const Surroundings& surroundings, const Settings& settings, const Game& game, const Beliefs& beliefs, Tick now,
       const Mind& mind);

  const Surroundings& around;
  const Settings& settings;
  const Game& game;
  const Beliefs& beliefs;
  const Mind& mind;
  Tick now;

  float half_length;  // [m]
  float half_width;   // [m]
  Vec2 position;      // [m, team_field] own
  Vec2 facing;        // [team_field] unit vector at the own heading

  bool ball_known;      // seen or reported, and not forgotten; or supposed at its place of a set play
  Tick ball_put = 0;    // time at which the present kick-off or set play began; 0: none
  Tick ball_seen;       // time of that sight, or of the set play's beginning; kNever: none
  Vec2 ball;            // [m, robot]
  Vec2 ball_in_team;    // [m, team_field]
  Vec2 ball_velocity;   // [m/s, team_field]; 0 for a reported ball
  float ball_distance;  // [m]

  // values that features.h has computed for this decision
  mutable std::uint64_t computed[kMaxFeatures / 64] = {};  // one bit per feature
  mutable float values[kMaxFeatures];                      // [SI] NaN: not known

  /// Transform a point of the field into the frame of the robot, and back.
  Vec2 to_robot(Vec2 in_team) const { return turned_back(in_team - position, facing); }
  Vec2 to_team(Vec2 in_robot) const { return position + turned(in_robot, facing); }
  Vec2 goal() const { return {half_length, 0}; }
  Vec2 own_goal() const { return {-half_length, 0}; }
  /// Returns whether the opponent was seen recently.
  bool believes(const Opponent& opponent) const {
    return (opponent.seen != kNever) & (now - opponent.seen < ticks(kOpponentMemory));
  }
  /// Returns whether the teammate is on the field and was heard in the last `memory` [ticks].
  bool believes(const Mate& mate, Tick memory) const {
    return mate.active & (mate.sent != kNever) & (now - mate.sent < memory);
  }
  /// Calls see(position) [m, team_field] for each opponent seen recently.
  template <class See>
  void for_each_opponent(See&& see) const {
    for (int i = 0; i < game.players; ++i)
      if (believes(beliefs.opponents[i])) see(beliefs.opponents[i].position);
  }
  /// Calls see(mate, index) for each teammate on the field that was heard recently.
  template <class See>
  void for_each_mate(See&& see) const {
    const Tick stale = ticks(settings.roles.stale);
    for (int i = 0; i + 1 < game.players; ++i)
      if (believes(beliefs.mates[i], stale)) see(beliefs.mates[i], i);
  }
  /// Returns the number [1..7] of beliefs.mates[index].
  int player_of_mate(int index) const { return agent::player_of_mate(game.player, index); }
};

/// Returns -1, 0 or +1.
constexpr float sign(float value) { return static_cast<float>((value > 0) - (value < 0)); }
constexpr float clamp(float value, float least, float most) {
  return value < least ? least : value > most ? most : value;
}
/// Returns `a` with length 1, or {1, 0} for the zero vector.
inline Vec2 unit(Vec2 a) {
  const float size = length(a);
  return size > 1e-6f ? (1 / size) * a : Vec2{1, 0};
}
/// Returns `a` turned left by a right angle.
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }

}  // namespace sim::agent
