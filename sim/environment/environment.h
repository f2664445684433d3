// Games side by side, each with agents that a learner moves.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/drills/attempt.h"
#include "sim/drills/starts.h"
#include "sim/environment/options.h"
#include "sim/io/matchup.h"

namespace sim::environment {

/// The arrays that a learner reads and writes. Rows are by game, and in a game by agent. An observation is that of the
/// robot's newest turn (sim/match/pace.h), or of the start before its first one.
struct Arrays {
  std::vector<float> observations;       // rows x columns
  std::vector<float> actions;            // rows x width
  std::vector<float> rewards;            // rows; of an agent of the away side the negative points of the home side
  std::vector<std::uint8_t> terminated;  // rows: success, failure or the end of the game
  std::vector<std::uint8_t> truncated;   // rows: the time of the episode is over
  std::vector<std::uint8_t> active;      // rows: the robot is on the field and in play
  std::vector<std::uint8_t> succeeded;   // games
  std::vector<std::uint64_t> seeds;      // games: of the present episode
};

/// An environment. Used by one thread at a time.
class Environment {
 public:
  /// Opens it from options as JSON (options.h). All games begin with the seeds 0, 1, ….
  static robot::Result<std::unique_ptr<Environment>> open(std::string_view options);
  ~Environment();
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  int games() const { return options_.games; }
  int agents() const { return static_cast<int>(agents_.size()); }
  int columns() const { return options_.frame.columns.count(); }
  int width() const { return width_of(options_.actions); }
  /// The actions are to be written.
  Arrays& arrays() { return arrays_; }
  /// Returns the description as JSON.
  const std::string& about() const { return about_; }
  const State& state(int game) const { return states_[static_cast<std::size_t>(game)]; }

  /// Begins new episodes with seeds[game] where which[game] is not 0, or everywhere without `which`.
  void reset(std::span<const std::uint64_t> seeds, std::span<const std::uint8_t> which = {});
  /// Plays on by the actions. An Error about an action names game and agent; then no game has been played on.
  robot::Result<void> step();
  /// Returns an Error if the state of a game is not one that a snapshot may have.
  robot::Result<void> check() const;

 private:
  class Puppets;

  /// The episode of a game, without its state.
  struct Episode {
    std::uint64_t first = 0;   // seed of the reset
    std::uint32_t number = 0;  // of the episode since the reset
    bool ended = false;
  };

  Environment(Options options, io::PreparedGame game);
  robot::Result<void> prepare();
  void begin(int game, std::uint64_t seed);
  void show_start(int game, std::uint64_t seed);
  void restart(int game);
  robot::Result<void> check_actions() const;
  void play(int first, int count);
  void judge(int game, const referee::Events& events);
  void observe(int game);
  void note_active(int game);
  float* observation(std::size_t row) {
    return arrays_.observations.data() + row * static_cast<std::size_t>(columns());
  }
  const float* action(std::size_t row) const {
    return arrays_.actions.data() + row * static_cast<std::size_t>(width());
  }
  bool is_agent(int robot) const { return agent_of_[robot] >= 0; }

  Options options_;
  io::PreparedGame game_;
  std::unique_ptr<Puppets> puppets_[2];  // by Side
  std::optional<drills::Starts> starts_;
  std::vector<int> agents_;   // robots, ascending
  int agent_of_[kMaxRobots];  // by robot; -1: plays its strategy
  std::vector<State> states_, begun_;
  std::vector<std::optional<drills::Attempt>> attempts_;
  std::vector<Episode> episodes_;
  Arrays arrays_;
  std::string about_;
};

}  // namespace sim::environment
