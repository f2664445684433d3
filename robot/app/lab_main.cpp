// foresight-lab: recordings in, described and shown, on the lab's machine.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "robot/app/build_id.h"
#include "robot/app/clock_option.h"
#include "robot/app/forecast_report.h"
#include "robot/app/import.h"
#include "robot/app/lab_foresight.h"
#include "robot/app/play.h"
#include "robot/app/relay.h"
#include "robot/core/json.h"
#include "robot/foresight/question.h"
#include "robot/foresight/scorer.h"
#include "robot/lab/clocks/session_report.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {
namespace {

constexpr int kDone = 0, kBadInput = 2;

int fail(const std::string& sentence) {
  std::fprintf(stderr, "foresight-lab: %s\n", sentence.c_str());
  return kBadInput;
}

struct ImportCommand {
  std::string format, file, out, session, robot = "0/1", name;
  bool json = false;

  void add_to(CLI::App& app) {
    CLI::App* command = app.add_subcommand("import", "make a session of a recording of others");
    command->add_option("format", format, "bhuman2009, nblog, or auto")->required();
    command->add_option("file", file, "the recording")->required();
    auto* folder = command->add_option_group("where", "one of")->require_option(1);
    folder->add_option("--out", out, "log folder in which the session gets a folder of its own");
    folder->add_option("--session", session, "folder of the session");
    command->add_option("--robot", robot, "<team>/<player> it is to appear as")->capture_default_str();
    command->add_option("--name", name, "name of the session");
    command->add_flag("--json", json, "report as JSON");
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const Result<RobotName> robot_name = parse_robot_name(robot);
    if (!robot_name) return fail(robot_name.error());
    const std::string shown = name.empty() ? std::filesystem::path(file).stem().string() : name;
    const std::filesystem::path folder =
        session.empty() ? std::filesystem::path(out) / logging::session_folder_name(kUndatedEpochNs, shown, "import")
                        : std::filesystem::path(session);
    const auto report =
        import_recording({.format = format, .file = file, .session = folder, .robot = *robot_name, .name = shown});
    if (!report) return fail(report.error());
    print(folder, *report);
    return kDone;
  }

  void print(const std::filesystem::path& folder, const lab::ImportReport& report) const {
    if (json) {
      const nlohmann::json said = {{"session", folder.string()},
                                   {"messages", report.messages},
                                   {"warnings", report.warnings},
                                   {"damage", report.damage}};
      std::printf("%s\n", said.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
      return;
    }
    for (const auto& [object, count] : report.messages)
      std::printf("%8llu  %s\n", static_cast<unsigned long long>(count), object.c_str());
    for (const std::string& warning : report.warnings) std::printf("note: %s\n", warning.c_str());
    if (!report.damage.empty()) std::printf("damaged: %s\n", report.damage.c_str());
    std::printf("%s\n", folder.c_str());
  }

  bool chosen = false;
};

void add_clock_option(CLI::App& command, double& seconds) {
  command
      .add_option("--max-clock-offset", seconds,
                  "[s] a machine whose clock is further off than that is refused; another one's times are set right")
      ->capture_default_str();
}

struct InfoCommand {
  std::vector<std::string> sessions;
  double max_clock_offset = 60;
  bool json = false, chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("info", "what sessions hold: objects, counts, rates, gaps, time span, clocks");
    command->add_option("sessions", sessions, "folders of sessions, or .mcap files; the clocks of several are compared")
        ->required();
    add_clock_option(*command, max_clock_offset);
    command->add_flag("--json", json, "report as JSON: an object for each session");
    command->callback([this] { chosen = true; });
  }

  int run() const {
    std::vector<lab::RecordedClock> clocks;
    for (const std::string& session : sessions) {
      const auto report = lab::inspect(session);
      if (!report) return fail(report.error());
      clocks.push_back(report->clock);
      tell(*report);
    }
    const auto most_ns = clock_offset_ns(max_clock_offset);
    if (!most_ns) return fail(most_ns.error());
    const auto agreements = lab::agree(clocks, *most_ns);
    if (!agreements) return fail(agreements.error());
    for (const lab::Agreement& agreement : *agreements)
      if (!agreement.sentence.empty() && !json) std::printf("%s\n", agreement.sentence.c_str());
    return kDone;
  }

  /// The session, and how well the forecasts in it came true.
  void tell(const lab::SessionReport& report) const {
    const auto scores = score_forecasts(report.session);
    if (json) {
      nlohmann::json all = to_json(report);
      for (const auto& [robot, score] : scores) all["forecasts"][robot] = foreseeing::to_json(score);
      std::printf("%s\n", all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
      return;
    }
    std::printf("%s\n", to_text(report).c_str());
    for (const auto& [robot, score] : scores) {
      const std::string text = foreseeing::to_text(score);
      if (!text.empty()) std::printf("%s foretold:\n%s\n", robot.c_str(), text.c_str());
    }
  }
};

struct PlayCommand {
  PlayOptions options;
  bool chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command = app.add_subcommand("play", "serve sessions: to browsers, Foxglove, Lichtblick");
    command
        ->add_option("sessions", options.sessions,
                     "folders of sessions, or .mcap files; those of several robots are played in one time base")
        ->required();
    command->add_option("--speed", options.speed, "0.01 .. 1000, 1 is real time")->capture_default_str();
    command->add_flag("--loop", options.loop, "begin again at the end");
    add_clock_option(*command, options.max_clock_offset);
    command->add_option(
        "--map", options.map,
        "JSON file that says which topics of others are which of our objects: robot/lab/mapping/mapping.h");
    command->add_option(
        "--rules", options.foresight.rules,
        "rules that what-if questions go by; those of a recorded simulation if not given, else spl2025");
    command
        ->add_option(
            "--strategies", options.foresight.strategies,
            "that they can be about beside those that there are, by name or path; the first is what was played")
        ->delimiter(',');
    add_server_options(*command, options.server);
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const Result<void> played = play(options);
    return played ? kDone : fail(played.error());
  }
};

struct RelayCommand {
  RelayOptions options;
  bool chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command = app.add_subcommand("relay", "serve live robots to any number of viewers, and record them");
    command
        ->add_option("robots", options.robots,
                     "addresses such as 10.0.14.22:8765, or names or players of the robots file")
        ->required();
    command->add_option("--robots", options.robots_file,
                        "the robots file; $FORESIGHT_ROBOTS or ~/.config/foresight/robots.json if not given");
    command
        ->add_option("--pictures", options.pictures,
                     "of the cameras: jpeg (what a wireless network can carry), raw or none")
        ->transform(CLI::CheckedTransformer(std::map<std::string, lab::Pictures>{
            {"jpeg", lab::Pictures::jpeg}, {"raw", lab::Pictures::raw}, {"none", lab::Pictures::none}}))
        ->default_str("jpeg");
    command->add_flag("--lossless", options.lossless,
                      "every message, or the robot ends the connection; otherwise the newest where it is too slow");
    add_clock_option(*command, options.max_clock_offset);
    command->add_flag("--record", options.record, "begin to record at once");
    command->add_option("--name", options.name, "name of the session that --record begins");
    command->add_option("--log-dir", options.log_folder, "where sessions are recorded")->capture_default_str();
    command->add_option("--log-mb", options.log_mb, "what all sessions together may take [MB]; the oldest go first")
        ->capture_default_str();
    add_server_options(*command, options.server);
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const Result<void> relayed = relay(options);
    return relayed ? kDone : fail(relayed.error());
  }
};

struct WhatIfCommand {
  WhatIfOptions options;
  std::string question = "{}";
  std::vector<std::string> strategies;
  double horizon = 0;
  std::optional<std::uint32_t> budget_ms;
  bool json = false, chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("what-if", "which strategy would have been best from a moment of a session on");
    command->add_option("session", options.session, "folder of the session, or an .mcap file")->required();
    command->add_option("--at", options.at, "[s] since the beginning; negative: before the end")->required();
    command->add_option("--robot", options.robot, "<team>/<player>, where the session has several");
    command->add_option("--strategies", strategies, "the first is what is played; all that there are if not given")
        ->delimiter(',');
    command->add_option("--horizon", horizon, "[s] how far it looks: 1 .. 1200; 30 if not given");
    command->add_option("--budget-ms", budget_ms, "[ms] for the answer: 10 .. 10000; 2000 if not given");
    command->add_option("--rules", options.foresight.rules,
                        "a year's; those of a recorded simulation if not given, else spl2025");
    command->add_option("--question", question,
                        "more of the question, as JSON: {\"until\": \"half\", \"edit\": {...}}");
    command->add_flag("--json", json, "report as JSON");
    command->callback([this] { chosen = true; });
  }

  int run() {
    const auto more = parse_json(question);
    if (!more) return fail("--question: " + more.error());
    auto parsed = foreseeing::parse_question(*more);
    if (!parsed) return fail("--question: " + parsed.error());
    options.question = *parsed;
    if (!strategies.empty()) options.question.clear_strategies();
    for (const std::string& name : strategies) options.question.add_strategies(name);
    options.foresight.strategies = {options.question.strategies().begin(), options.question.strategies().end()};
    if (horizon != 0) options.question.set_horizon(static_cast<float>(horizon));
    if (budget_ms || options.question.budget_ms() == 0) options.question.set_budget_ms(budget_ms.value_or(2000));
    const auto forecast = what_if(options);
    if (!forecast) return fail(forecast.error());
    if (!forecast->refusal().empty()) return fail(forecast->reason());
    if (json)
      std::printf("%s\n", foreseeing::to_json(*forecast, true).dump(2).c_str());
    else
      print(*forecast);
    return kDone;
  }

  /// As foresight-sim situation --strategies prints it.
  static void print(const foresight::Forecast& forecast) {
    std::printf("%-20s%9s%18s%26s%9s%9s%10s\n", "", "futures", "value", "gain, 95 % interval", "best", "scores",
                "concedes");
    for (const auto& told : forecast.strategies()) {
      std::printf("%-20s%9u%9.3f ± %-6.3f", told.strategy().c_str(), told.rollouts(), told.mean(), told.error());
      if (&told == &forecast.strategies(0))
        std::printf("%26s", "");
      else
        std::printf("%9.3f (%6.3f .. %6.3f)", told.gain(), told.gain_low(), told.gain_high());
      std::printf("%7.0f %%%7.0f %%%8.0f %%\n", 100 * told.best(), 100 * told.score(), 100 * told.concede());
    }
    std::printf("\n%s\n", forecast.reason().c_str());
  }
};

struct SynthesizeCommand {
  std::string session, robot = "14/2";
  double seconds = 20;
  bool chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command = app.add_subcommand("synthesize", "make a small session of a robot that never was");
    command->add_option("session", session, "folder of the session")->required();
    command->add_option("--seconds", seconds, "how long")->capture_default_str();
    command->add_option("--robot", robot, "<team>/<player>")->capture_default_str();
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const Result<RobotName> robot_name = parse_robot_name(robot);
    if (!robot_name) return fail(robot_name.error());
    const auto made = synthesize(session, *robot_name, seconds);
    if (!made) return fail(made.error());
    std::printf("%s\n", session.c_str());
    return kDone;
  }
};

int lab_main(int argc, char** argv) {
  CLI::App app{"Foresight on the lab machine"};
  app.set_version_flag("--version", std::string(kBuildId));
  app.require_subcommand(1);
  ImportCommand import;
  InfoCommand info;
  PlayCommand play;
  RelayCommand relay;
  WhatIfCommand what_if;
  SynthesizeCommand synthesize;
  import.add_to(app);
  info.add_to(app);
  play.add_to(app);
  relay.add_to(app);
  what_if.add_to(app);
  synthesize.add_to(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  if (import.chosen) return import.run();
  if (info.chosen) return info.run();
  if (play.chosen) return play.run();
  if (relay.chosen) return relay.run();
  if (what_if.chosen) return what_if.run();
  return synthesize.run();
}

}  // namespace
}  // namespace robot::app

int main(int argc, char** argv) { return robot::app::lab_main(argc, argv); }
