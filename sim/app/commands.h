// The commands of foresight-sim. Each adds itself to the command line and runs if it was chosen.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/command/command.h"
#include "sim/contest/lineup.h"
#include "sim/io/playbook.h"

namespace sim::app {

using robot::command::Command, robot::command::kDone, robot::command::kBadInput;

// a browser cannot represent every integer above 2^53
inline constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 53) - 1;

/// Prints the sentence on stderr and returns the exit status of bad input.
int fail(const std::string& sentence);

/// Returns the words of this program's command line, for a job of a cluster. Leaves out the options in `without`.
std::vector<std::string> words_again(const CLI::App& command, const std::vector<std::string>& without);

/// Prints a sentence on stderr if the games of a series repeat.
void warn_of_repetition(std::int64_t games, std::int64_t different, const io::Matchup& choice);

/// --rules, --home, --away, --home-rest, --away-rest, --changed, --models, --home-models, --away-models, --falls,
/// --players, --every-tick: the options of every command that plays games.
class ChoiceOptions {
 public:
  void add_to(CLI::App& command);
  /// Returns the names that the options give.
  io::Matchup choice() const;
  /// Returns them with the rest of each side.
  contest::LineupChoice lineup_choice() const;
  /// Prepares the lineup.
  robot::Result<contest::Lineup> line_up() const;
  /// Prepares the strategies between which the home side may choose, against the away side's. The first is the current
  /// one.
  robot::Result<io::Playbook> playbook(const std::vector<std::string>& strategies) const;

 private:
  io::Matchup choice_;
  std::string rest_[2];
  int changed_ = kMaxPlayers;
  std::string models_ = "match", home_models_, away_models_, falls_;
  bool every_tick_ = false;
};

std::unique_ptr<Command> match_command(CLI::App& app);
std::unique_ptr<Command> situation_command(CLI::App& app);
std::unique_ptr<Command> replay_command(CLI::App& app);
std::unique_ptr<Command> check_command(CLI::App& app);
std::unique_ptr<Command> why_command(CLI::App& app);
std::unique_ptr<Command> whynot_command(CLI::App& app);
std::unique_ptr<Command> debug_command(CLI::App& app);
std::unique_ptr<Command> drills_command(CLI::App& app);
std::unique_ptr<Command> learn_command(CLI::App& app);
std::unique_ptr<Command> coverage_command(CLI::App& app);
std::unique_ptr<Command> decisions_command(CLI::App& app);
std::unique_ptr<Command> compare_command(CLI::App& app);
std::unique_ptr<Command> bench_command(CLI::App& app);
std::unique_ptr<Command> calibration_command(CLI::App& app);
std::unique_ptr<Command> choosing_command(CLI::App& app);
std::unique_ptr<Command> outlook_command(CLI::App& app);
std::unique_ptr<Command> vet_command(CLI::App& app);
std::unique_ptr<Command> signature_command(CLI::App& app);
/// List the words of a strategy.
std::unique_ptr<Command> skills_command(CLI::App& app);
std::unique_ptr<Command> features_command(CLI::App& app);
/// Lists the embedded rules, models, strategies or situations.
std::unique_ptr<Command> list_command(CLI::App& app, const std::string& kind);

}  // namespace sim::app
