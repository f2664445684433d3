#include "sim/app/commands.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "robot/core/json_library.h"
#include "sim/contest/repetition.h"
#include "sim/io/ingredients.h"
#include "sim/io/models.h"
#include "sim/io/rules.h"
#include "sim/io/source.h"
#include "sim/match/hash.h"

namespace sim::app {
namespace {

class SignatureCommand final : public Command {
 public:
  explicit SignatureCommand(CLI::App& app)
      : Command(app.add_subcommand(
            "signature", "print the hash of the simulator's behaviour, which is the same on every machine")) {}

  int run() override {
    const auto ingredients = io::embedded_ingredients();
    if (!ingredients) return fail(ingredients.error());
    std::printf("%s\n", hex(signature_of(ingredients->lists)).c_str());
    return kDone;
  }
};

class ListCommand final : public Command {
 public:
  ListCommand(CLI::App& app, std::string kind)
      : Command(app.add_subcommand(kind, "list the built-in " + kind + "; --show prints one as a template")),
        kind_(std::move(kind)) {
    options().add_option(
        "--show", show_,
        varies() ? "name: print its description, with the changes in the name" : "name: print its description");
    options().add_flag("--json", json_, "report as JSON");
  }

  int run() override {
    if (!show_.empty()) return print_one();
    const std::vector<std::string_view> names = io::names_of(kind_);
    if (json_) {
      std::printf("%s\n", nlohmann::json(names).dump().c_str());
    } else {
      for (const std::string_view name : names) std::printf("%.*s\n", static_cast<int>(name.size()), name.data());
    }
    return kDone;
  }

 private:
  bool varies() const { return kind_ == "rules" || kind_ == "models"; }
  std::string noun() const {
    return kind_ == "strategies"   ? "strategy"
           : kind_ == "situations" ? "situation"
           : kind_ == "falls"      ? "table of falls"
                                   : kind_;
  }

  /// Prints the description with its sources. With changes in the name it prints the changed values.
  int print_one() {
    if (varies() && show_.find_first_of(",:") != show_.npos) return print_variation();
    const auto source = io::find_source(kind_, noun(), show_);
    if (!source) return fail(source.error());
    std::fputs(source->text.c_str(), stdout);
    return kDone;
  }

  int print_variation() {
    io::Sources sources;
    if (kind_ == "rules") {
      const auto rules = io::load_rules(show_, &sources);
      if (!rules) return fail(rules.error());
      std::fputs(io::print_rules(*rules, show_, sources).c_str(), stdout);
      return kDone;
    }
    const auto models = io::load_models(show_, &sources);
    if (!models) return fail(models.error());
    std::fputs(io::print_models(*models, sources).c_str(), stdout);
    return kDone;
  }

  const std::string kind_;
  std::string show_;
  bool json_ = false;
};

}  // namespace

int fail(const std::string& sentence) { return robot::command::fail("foresight-sim", sentence); }

std::vector<std::string> words_again(const CLI::App& command, const std::vector<std::string>& without) {
  std::error_code unknown;  // then the job takes the program of its path
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  std::vector<std::string> words = {unknown ? "foresight-sim" : self.string(), command.get_name()};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::ranges::find(without, name) != without.end()) continue;
    if (!option->get_positional()) words.push_back(name);
    if (option->get_items_expected_max() == 0) continue;
    const std::vector<std::string>& values = option->results();
    if (const char delimiter = option->get_delimiter(); delimiter != '\0')
      words.push_back(CLI::detail::join(values, std::string(1, delimiter)));
    else
      words.insert(words.end(), values.begin(), values.end());
  }
  return words;
}

void warn_of_repetition(std::int64_t games, std::int64_t different, const io::Matchup& choice) {
  if (different == games) return;
  const std::string models =
      choice.models[0] == choice.models[1] ? choice.models[0] : choice.models[0] + "' and '" + choice.models[1];
  std::fprintf(stderr, "foresight-sim: %s\n", contest::repetition(games, different, "games", models).c_str());
}

void ChoiceOptions::add_to(CLI::App& command) {
  command.add_option("--rules", choice_.rules, "rules of a year: name, name:players, name,field=value or file")
      ->capture_default_str();
  command
      .add_option("--home", choice_.strategies[0], "behaviour of the home side: name, file, library or pipe:command")
      ->capture_default_str();
  command.add_option("--away", choice_.strategies[1], "behaviour of the away side")->capture_default_str();
  command.add_option("--home-rest", rest_[0], "behaviour of the home players after the first --changed");
  command.add_option("--away-rest", rest_[1], "behaviour of the away players after the first --changed");
  command.add_option("--changed", changed_, "number of players that play --home or --away, on a side with a rest")
      ->check(CLI::Range(1, kMaxPlayers));
  command
      .add_option("--models", models_,
                  "models of the robots: name, name,effect=off,walk.forward=0.2 or file; player 3 another: name+3=name")
      ->capture_default_str();
  command.add_option("--home-models", home_models_, "models of the home side's robots, and of ball and contacts");
  command.add_option("--away-models", away_models_, "models of the away side's robots");
  const auto is_table = [](const std::string& table) -> std::string {
    if (!table.empty() && table.find_first_of(",+") == table.npos) return "";
    return "expected the name or the path of a table of falls, without ',' and '+', got '" + table + "'";
  };
  command
      .add_option("--falls", falls_,
                  "how often all robots fall: name or file of a table, as bench_walk makes it of a walk")
      ->check(is_table);
  command.add_option("--players", choice_.players, "players per side; by the rules if not given")
      ->check(CLI::Range(1, kMaxPlayers));
  command.add_flag("--every-tick", every_tick_, "all robots decide 30 times a second, also far from the ball");
}

io::Matchup ChoiceOptions::choice() const {
  io::Matchup choice = choice_;
  choice.models[0] = home_models_.empty() ? models_ : home_models_;
  choice.models[1] = away_models_.empty() ? models_ : away_models_;
  if (!falls_.empty())
    for (std::string& models : choice.models) models = io::with_falls(models, falls_);
  choice.pace = every_tick_ ? Pace::every_tick : Pace::thinned;
  return choice;
}

contest::LineupChoice ChoiceOptions::lineup_choice() const {
  return {.game = choice(), .rest = {rest_[0], rest_[1]}, .changed = changed_};
}

robot::Result<contest::Lineup> ChoiceOptions::line_up() const { return contest::Lineup::prepare(lineup_choice()); }

robot::Result<io::Playbook> ChoiceOptions::playbook(const std::vector<std::string>& strategies) const {
  const io::Matchup game = choice();
  return io::prepare_playbook({.strategies = strategies,
                               .opponent = game.strategies[1],
                               .rules = game.rules,
                               .models = game.models[0],
                               .opponent_models = game.models[1],
                               .players = game.players,
                               .pace = game.pace});
}

std::unique_ptr<Command> signature_command(CLI::App& app) { return std::make_unique<SignatureCommand>(app); }

std::unique_ptr<Command> list_command(CLI::App& app, const std::string& kind) {
  return std::make_unique<ListCommand>(app, kind);
}

}  // namespace sim::app
