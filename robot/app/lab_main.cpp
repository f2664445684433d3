// foresight-lab: recordings in, described and shown, on the lab's machine.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "robot/app/build_id.h"
#include "robot/app/import.h"
#include "robot/app/play.h"
#include "robot/lab/session_report.h"
#include "robot/logging/session.h"

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

struct InfoCommand {
  std::string session;
  bool json = false, chosen = false;

  void add_to(CLI::App& app) {
    CLI::App* command = app.add_subcommand("info", "what a session holds: objects, counts, rates, gaps, time span");
    command->add_option("session", session, "folder of the session")->required();
    command->add_flag("--json", json, "report as JSON");
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const auto report = lab::inspect(session);
    if (!report) return fail(report.error());
    std::printf("%s\n", (json ? to_json(*report) : to_text(*report)).c_str());
    return kDone;
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
    add_server_options(*command, options.server);
    command->callback([this] { chosen = true; });
  }

  int run() const {
    const Result<void> played = play(options);
    return played ? kDone : fail(played.error());
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
  SynthesizeCommand synthesize;
  import.add_to(app);
  info.add_to(app);
  play.add_to(app);
  synthesize.add_to(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  if (import.chosen) return import.run();
  if (info.chosen) return info.run();
  if (play.chosen) return play.run();
  return synthesize.run();
}

}  // namespace
}  // namespace robot::app

int main(int argc, char** argv) { return robot::app::lab_main(argc, argv); }
