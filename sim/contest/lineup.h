// Who plays: trees, behaviours from outside, or a team of both; and the players of a single game.
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

/// What decisions cost [by the clock on the wall]: of trees a sample, of guests all.
struct DecisionCost {
  std::uint64_t timed = 0;
  double ns = 0;  // that these took

  double mean_us() const { return timed == 0 ? 0 : ns / static_cast<double>(timed) / 1000; }
  void add(const DecisionCost& other) { timed += other.timed, ns += other.ns; }
};

/// A behaviour as it was named: a tree, or where its players come from.
struct Named {
  std::shared_ptr<const agent::Behaviour> tree;
  std::shared_ptr<const guest::GuestFactory> guest;
};

/// Of a side's players the first few may play another behaviour.
struct LineupChoice {
  io::Matchup game;
  std::string rest[2];        // by Side: what players changed + 1 .. play; empty: as the others
  int changed = kMaxPlayers;  // so many play game.strategies
};

/// Any thread makes games of it.
class Lineup {
 public:
  static robot::Result<Lineup> prepare(const LineupChoice& choice);

  /// The behaviours in it are for looking at a situation only; games have their own.
  const Params& params() const { return setup_.params; }
  Params& params() { return setup_.params; }
  /// A side plays a behaviour from outside.
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

  /// Those of the game, with its own behaviours.
  const Params& params() const { return params_; }
  /// Something is wrong with a behaviour from outside, and what was played is worth nothing.
  bool failed() const;
  /// What it is; empty where nothing is.
  std::string problem() const;
  DecisionCost cost(Side side) const;

  /// What the guests remember; nothing where one of them cannot save it.
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

/// Of many games; any thread.
class Costs {
 public:
  void add(const Cast& cast);
  /// As cost_text, of both sides.
  std::string text() const;

 private:
  mutable std::mutex lock_;
  DecisionCost cost_[2];  // by Side
};

/// "a decision costs  home 0.62 us, away 41.30 us"
std::string cost_text(const DecisionCost& home, const DecisionCost& away);

}  // namespace sim::contest
