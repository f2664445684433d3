// The behaviours of a game: trees, behaviours from outside, or both in one team; and the players of a single game.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/mixed.h"
#include "sim/guest/guest.h"
#include "sim/io/matchup.h"
#include "sim/match/state.h"

namespace sim::contest {

/// The wall-clock time of decisions: a sample for trees, all for guests.
struct DecisionCost {
  std::uint64_t timed = 0;
  double ns = 0;  // total time

  double mean_us() const { return timed == 0 ? 0 : ns / static_cast<double>(timed) / 1000; }
  void add(const DecisionCost& other) { timed += other.timed, ns += other.ns; }
};

/// A named behaviour: a tree, or a factory of players from outside.
struct Named {
  std::shared_ptr<const agent::Behaviour> tree;
  std::shared_ptr<const guest::GuestFactory> guest;
};

/// The choice of behaviours. The first players of a side may play another behaviour than the rest.
struct LineupChoice {
  io::Matchup game;
  std::string rest[2];        // by Side: behaviour of players changed + 1 ..; empty: as the others
  int changed = kMaxPlayers;  // number of players of game.strategies
};

/// Prepared behaviours. Any thread may make games from it.
class Lineup {
 public:
  static robot::Result<Lineup> prepare(const LineupChoice& choice);

  /// Returns parameters for inspecting a situation. Games have behaviours of their own.
  const Params& params() const { return setup_.params; }
  Params& params() { return setup_.params; }
  /// Reports whether the side plays a behaviour from outside.
  bool has_guest(Side side) const { return has_guest_[static_cast<int>(side)]; }

 private:
  friend class Cast;

  io::PreparedGame setup_;
  Named first_[2], rest_[2];  // by Side
  int changed_ = kMaxPlayers;
  bool has_guest_[2] = {false, false};
};

/// The players of one game. Used by one thread.
class Cast {
 public:
  Cast(const Lineup& lineup, std::uint64_t seed);
  ~Cast();
  Cast(const Cast&) = delete;
  Cast& operator=(const Cast&) = delete;

  /// Returns the parameters of the game, with its own behaviours.
  const Params& params() const { return params_; }
  /// Reports a fault of a behaviour from outside. The game is then worthless.
  bool failed() const;
  /// Returns the fault in one sentence, or an empty string.
  std::string problem() const;
  DecisionCost cost(Side side) const;

  /// Returns the guests' memory, or nothing if a guest cannot save it.
  std::optional<std::string> save() const;
  robot::Result<void> load(std::string_view bytes);

 private:
  class Player;

  const agent::Behaviour* seat(const Named& named, std::uint64_t seed, Side side);

  Params params_;
  std::vector<std::unique_ptr<Player>> players_;
  std::vector<guest::GuestBehaviour*> guests_;  // those among players_
  std::unique_ptr<agent::Mixed> mixed_[2];
};

/// The decision costs of many games. Any thread.
class Costs {
 public:
  void add(const Cast& cast);
  /// Returns cost_text of both sides.
  std::string text() const;

 private:
  mutable std::mutex lock_;
  DecisionCost cost_[2];  // by Side
};

/// Returns a line such as "a decision costs  home 0.62 us, away 41.30 us".
std::string cost_text(const DecisionCost& home, const DecisionCost& away);

}  // namespace sim::contest
