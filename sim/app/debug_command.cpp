// foresight-sim why, whynot and debug: the debugger of decisions.
#include <cstdio>
#include <filesystem>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/app/debugged_game.h"
#include "sim/app/line_editor.h"
#include "sim/debug/session.h"
#include "sim/report/reasons.h"

namespace sim::app {
namespace {

/// The options of a debugged game.
class GameOptions {
 public:
  void add_to(CLI::App& command) {
    game_.add_to(command);
    command.add_option("--at", at_, "moment: [s] since the first tick, or half:minutes:seconds on the clock");
    command.add_option("--robot", robot_, "robot: 14/3 or home/3");
    command.add_option("--home-team", teams_.home, "team number in the names of robots")
        ->check(CLI::Range(1, 999))
        ->capture_default_str();
    command.add_option("--away-team", teams_.away, "team number in the names of robots")
        ->check(CLI::Range(1, 999))
        ->capture_default_str();
  }

  /// Begins the game, and goes to the moment and the robot.
  robot::Result<debug::Session> begin() const {
    if (teams_.home == teams_.away)
      return robot::Error{"the teams must have different numbers, got " + std::to_string(teams_.home) + " twice"};
    const auto game = game_.prepare();
    if (!game) return game.failure();
    debug::Session session(game->setup, game->openings.begin(game->params(), game_.seed()), teams_);
    if (!robot_.empty())
      if (const auto done = session.run("robot " + robot_); !done) return done.failure("--robot");
    if (!at_.empty())
      if (const auto done = session.run("goto " + at_); !done) return done.failure("--at");
    return session;
  }

 private:
  DebuggedGameOptions game_;
  std::string at_, robot_;
  io::SituationTeams teams_ = kUsualTeams;
};

constexpr std::size_t kMostFile = 1'000'000;  // [bytes] of breakpoints

/// Prints the answer to one line.
int answer(debug::Session& session, const std::string& line) {
  const auto text = session.run(line);
  if (!text) return fail(text.error());
  std::fputs(text->c_str(), stdout);
  return kDone;
}

int print(const report::Json& json) {
  std::printf("%s\n", json.dump(2).c_str());
  return kDone;
}

class WhyCommand final : public Command {
 public:
  explicit WhyCommand(CLI::App& app)
      : Command(
            app.add_subcommand("why", "explain a decision of a robot: every comparison, its margin and its beliefs")) {
    game_.add_to(options());
    options().get_option("--at")->required();
    options().get_option("--robot")->required();
    options().add_flag("--json", json_, "answer as JSON");
  }

  int run() override {
    auto session = game_.begin();
    if (!session) return fail(session.error());
    if (!json_) return answer(*session, "why");
    auto explained = session->explain(session->focus());
    if (!explained) return fail(explained.error());
    find_sources(explained->setup->params, *explained->tree, explained->why);
    return print(report::to_json(explained->why, *explained->tree, session->name_of(session->focus())));
  }

 private:
  GameOptions game_;
  bool json_ = false;
};

class WhynotCommand final : public Command {
 public:
  explicit WhynotCommand(CLI::App& app)
      : Command(
            app.add_subcommand("whynot", "the smallest change with which a robot would have played another skill")) {
    game_.add_to(options());
    options().get_option("--at")->required();
    options().get_option("--robot")->required();
    options().add_option("--skill", skill_, "skill, or the name of a rule of the tree")->required();
    options().add_flag("--json", json_, "answer as JSON");
  }

  int run() override {
    auto session = game_.begin();
    if (!session) return fail(session.error());
    if (!json_) return answer(*session, "whynot " + skill_);
    const auto explained = session->explain(session->focus());
    if (!explained) return fail(explained.error());
    const auto found = session->alternative(*explained, skill_);
    if (!found) return fail(found.error());
    return print(report::to_json(*found, *explained->tree, session->name_of(session->focus()), skill_));
  }

 private:
  GameOptions game_;
  std::string skill_;
  bool json_ = false;
};

class DebugCommand final : public Command {
 public:
  explicit DebugCommand(CLI::App& app)
      : Command(app.add_subcommand("debug", "stop, go back, ask, change and run again: lines from standard input")) {
    game_.add_to(options());
    options().add_option("--breakpoints", file_, "file of the breakpoints, a condition a line; kept up to date");
    options().footer("Commands:\n" + debug::help_text());
  }

  int run() override {
    auto session = game_.begin();
    if (!session) return fail(session.error());
    if (const auto read = read_breakpoints(*session); !read) return fail(read.error());
    if (const std::string note = session->note(); !note.empty()) std::fprintf(stderr, "%s\n", note.c_str());
    LineEditor editor([&](std::string_view line) { return session->completions(line); });
    for (int number = 1;; ++number) {
      const auto line = editor.read(session->prompt());
      if (!line || *line == "quit") return kDone;
      const std::vector<std::string> before = session->breakpoints();
      const auto text = session->run(*line);
      if (!file_.empty() && session->breakpoints() != before)
        if (const auto kept = write_breakpoints(*session); !kept) return fail(kept.error());
      if (text) {
        std::fputs(text->c_str(), stdout);
        std::fflush(stdout);
        continue;
      }
      // a script ends with its first error; a person tries again
      if (!editor.is_terminal()) return fail("line " + std::to_string(number) + ": " + text.error());
      std::printf("%s\n", text.error().c_str());
    }
  }

 private:
  /// Sets the breakpoints of the file. A file that does not exist yet has none.
  robot::Result<void> read_breakpoints(debug::Session& session) const {
    std::error_code problem;
    if (file_.empty() || (!std::filesystem::exists(file_, problem) && !problem)) return {};
    const auto text = robot::read_file(file_, kMostFile);
    if (!text) return text.failure();
    int number = 0;
    for (const std::string_view part : robot::split(*text, "\n")) {
      ++number;
      const std::string_view line = robot::trimmed(part);
      if (line.empty() || line.starts_with('#')) continue;
      if (const auto set = session.run("break " + std::string(line)); !set)
        return robot::Error{file_ + ", line " + std::to_string(number) + ": " + set.error()};
    }
    return {};
  }

  robot::Result<void> write_breakpoints(const debug::Session& session) const {
    std::string text;
    for (const std::string& condition : session.breakpoints()) text += condition + "\n";
    return robot::replace_file(file_, text);
  }

  GameOptions game_;
  std::string file_;
};

}  // namespace

std::unique_ptr<Command> why_command(CLI::App& app) { return std::make_unique<WhyCommand>(app); }
std::unique_ptr<Command> whynot_command(CLI::App& app) { return std::make_unique<WhynotCommand>(app); }
std::unique_ptr<Command> debug_command(CLI::App& app) { return std::make_unique<DebugCommand>(app); }

}  // namespace sim::app
