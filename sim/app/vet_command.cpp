// foresight-sim vet: checks that a behaviour can be compared. Its games must repeat and must return to an earlier
// state; the cost of a decision is measured.
#include <cstdio>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/app/compare_runs.h"
#include "sim/match/hash.h"
#include "sim/report/game_report.h"

namespace sim::app {
namespace {

/// The result of a game.
struct VettedGame {
  std::uint64_t hash = 0;
  contest::DecisionCost cost;
  std::string problem;
};

class VetCommand final : public Command {
 public:
  explicit VetCommand(CLI::App& app)
      : Command(app.add_subcommand(
            "vet", "check that a behaviour repeats its games, as comparisons need, and measure its cost")) {
    options().add_option("behaviour", name_, "name, file, library or pipe:command")->required();
    options()
        .add_option("--seconds", seconds_, "[s] length of the game")
        ->check(CLI::Range(1., 3600.))
        ->capture_default_str();
    options().add_option("--seed", seed_, "seed of the game")->capture_default_str();
    options().add_flag("--json", json_, "report as JSON");
    options().footer("Exit status: 0 fit, 1 not, 2 bad usage or input.");
  }

  int run() override {
    const auto lineup = contest::Lineup::prepare({.game = {.strategies = {name_, "baseline"}}, .rest = {}});
    if (!lineup) return fail(lineup.error());
    const VettedGame first = play(*lineup), again = play(*lineup);
    for (const VettedGame* played : {&first, &again})
      if (!played->problem.empty()) return fail(played->problem);
    const auto taken_back = take_back(*lineup);
    if (!taken_back) return fail(taken_back.error());
    const bool same = first.hash == again.hash, returns = taken_back->hash == first.hash;
    report(same, returns, taken_back->by_memory, first.cost);
    return same && returns ? kDone : kNo;
  }

 private:
  struct TakenBack {
    std::uint64_t hash = 0;
    bool by_memory = false;  // false: by playing again from the seed
  };

  Tick length() const { return ticks(static_cast<float>(seconds_)); }

  /// Plays on to the tick `end`.
  static void play_on(const contest::Cast& cast, State& state, Tick end) {
    referee::Events events;
    while (state.world.tick < end && !finished(state) && !cast.failed()) step(cast.params(), state, events);
  }

  State begun(const contest::Cast& cast) const {
    referee::Events events;
    return begin(cast.params(), {.seed = seed_}, events);
  }

  VettedGame play(const contest::Lineup& lineup) const {
    const contest::Cast cast(lineup, seed_);
    State state = begun(cast);
    play_on(cast, state, length());
    return {.hash = hash_of(state), .cost = cast.cost(Side::home), .problem = cast.problem()};
  }

  /// Plays to the end, back to the middle, and to the end again.
  robot::Result<TakenBack> take_back(const contest::Lineup& lineup) const {
    contest::Cast cast(lineup, seed_);
    State state = begun(cast);
    play_on(cast, state, length() / 2);
    const State middle = state;
    const auto memory = cast.save();
    play_on(cast, state, length());
    if (cast.failed()) return robot::Error{cast.problem()};
    if (memory) {
      state = middle;
      if (auto loaded = cast.load(*memory); !loaded) return loaded.failure();
      play_on(cast, state, length());
      return TakenBack{.hash = hash_of(state), .by_memory = true};
    }
    // a behaviour without memory to load is played again from its seed
    const contest::Cast second(lineup, seed_);
    State from_start = begun(second);
    play_on(second, from_start, length() / 2);
    const bool met = hash_of(from_start) == hash_of(middle);
    play_on(second, from_start, length());
    if (second.failed()) return robot::Error{second.problem()};
    return TakenBack{.hash = met ? hash_of(from_start) : 0, .by_memory = false};
  }

  void report(bool same, bool returns, bool by_memory, const contest::DecisionCost& cost) const {
    if (json_) {
      const report::Json json = {{"behaviour", name_},
                                 {"same_each_time", same},
                                 {"taken_back", returns},
                                 {"taken_back_by", by_memory ? "memory" : "replay"},
                                 {"decision_us", cost.mean_us()},
                                 {"decisions_timed", cost.timed}};
      std::printf("%s\n", json.dump(2).c_str());
      return;
    }
    std::printf("%s, %g s of a game against baseline\n", name_.c_str(), seconds_);
    std::printf("  the same each time   %s\n",
                same ? "yes" : "NO: its decisions depend on something other than the game");
    std::printf("  taken back           %s%s\n", by_memory ? "by its memory" : "by playing again from the seed",
                returns ? "" : ", and then it is ANOTHER game");
    std::printf("  a decision costs     %.2f us\n", cost.mean_us());
  }

  std::string name_;
  double seconds_ = 100;
  std::uint64_t seed_ = 1;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> vet_command(CLI::App& app) { return std::make_unique<VetCommand>(app); }

}  // namespace sim::app
