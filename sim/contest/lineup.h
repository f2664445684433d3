// The lineup of a game: trees, behaviours from outside, or a team of both; and the players of a single game.
#pragma once

#include <cstdint>
#include <functional>
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

/// The cost of decisions in wall time. Every decision of a guest is timed, and a sample of those of trees.
struct DecisionCost {
  std::uint64_t timed = 0;  // number of timed decisions
  double ns = 0;            // [ns] sum over the timed decisions

  double mean_us() const { return timed == 0 ? 0 : ns / static_cast<double>(timed) / 1000; }
  void add(const DecisionCost& other) { timed += other.timed, ns += other.ns; }
};

/// A behaviour found by its name: a tree, or the factory of a guest. Exactly one is set.
struct Named {
  std::shared_ptr<const agent::Behaviour> tree;
  std::shared_ptr<const guest::GuestFactory> guest;
};

/// A game in which the first players of a side may play another behaviour than the rest.
struct LineupChoice {
  io::Matchup game;
  std::string rest[2];        // by Side: behaviour of players changed + 1 ..; empty: as the first
  int changed = kMaxPlayers;  // number of players per side that play game.strategies
};

/// A prepared lineup. Any thread may make games (Cast) from it.
class Lineup {
 public:
  static robot::Result<Lineup> prepare(const LineupChoice& choice);

  /// The parameters of the game. Their behaviours serve only to inspect a situation; each game has its own.
  const Params& params() const { return setup_.params; }
  Params& params() { return setup_.params; }
  /// Returns true if the side plays a behaviour from outside.
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

  /// The parameters of this game, with its own behaviours.
  const Params& params() const { return params_; }
  /// Returns true if a behaviour from outside has failed. The game is then invalid.
  bool failed() const;
  /// Returns the failure as a sentence, or an empty string without one.
  std::string problem() const;
  DecisionCost cost(Side side) const;

  /// Returns the guests' memory, or nothing if one of the guests cannot save its own.
  std::optional<std::string> save() const;
  robot::Result<void> load(std::string_view bytes);

 private:
  class Player;

  const agent::Behaviour* seat(const Named& named, std::uint64_t seed, Side side);

  Params params_;
  std::vector<std::unique_ptr<Player>> players_;
  std::vector<guest::GuestBehaviour*> guests_;  // among these
  std::unique_ptr<agent::Mixed> mixed_[2];
};

/// The cost of decisions over many games. Thread-safe.
class Costs {
 public:
  void add(const Cast& cast);
  /// Returns cost_text() of both sides.
  std::string text() const;

 private:
  mutable std::mutex lock_;
  DecisionCost cost_[2];  // by Side
};

/// Returns "a decision costs  home 0.62 us, away 41.30 us"
std::string cost_text(const DecisionCost& home, const DecisionCost& away);

}  // namespace sim::contest
