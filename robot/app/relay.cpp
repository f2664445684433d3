#include "robot/app/relay.h"

#include <memory>

#include "robot/app/clock_option.h"
#include "robot/app/foxglove_download.h"
#include "robot/app/lab_objects.h"
#include "robot/app/relayed_robots.h"
#include "robot/app/runtime.h"
#include "robot/app/services/futures_service.h"
#include "robot/app/services/reasons_service.h"
#include "robot/app/signals.h"
#include "robot/core/files.h"

namespace robot::app {
namespace {

/// Returns the recording profile that keeps the images unchanged.
std::string_view profile_for(lab::Pictures pictures) {
  switch (pictures) {
    case lab::Pictures::raw: return "full";
    case lab::Pictures::jpeg: return "vision";
    case lab::Pictures::none: return "game";
  }
  return "full";
}

}  // namespace

Result<void> relay(const RelayOptions& options) {
  const auto most_offset_ns = clock_offset_ns(options.max_clock_offset);
  if (!most_offset_ns) return most_offset_ns.failure();
  const auto robots = RelayedRobots::find(options.robots, options.robots_file);
  if (!robots) return robots.failure("relay");
  block_end_signals();

  const SessionClock clock;
  const auto own = std::make_shared<LabObjects>(clock);
  const RobotName name = (*robots)->first();
  Runtime runtime({.program = "foresight-lab",
                   .body = "relay",
                   .robot = name.text(),
                   .team = name.team,
                   .player = name.player,
                   .server = options.server,
                   .log_folder = absolute_path(options.recording.log_folder),
                   .log_bytes = options.recording.log_bytes(),
                   .recent = logging::kRecentPastOfTeams,
                   .foxglove_file = foxglove_file,
                   .add_statistics = [&](auto& statistics) { (*robots)->describe(statistics); }},
                  clock, {.runtime = own->runtime, .clock = own->clock_sample, .log = own->log});
  if (Result<void> listed = list(own, runtime.channels()); !listed) return listed;
  add_reasons_service(runtime.services(), runtime.channels(), {});
  add_futures_service(runtime.services(), runtime.channels(), {});
  if (const Result<void> usable = logging::check_session_name(options.recording.name); !usable)
    return usable.failure("--name");
  if (Result<void> started = runtime.start(); !started) return started;
  if (options.recording.record)
    if (Result<void> recording = runtime.record(options.recording.name, profile_for(options.pictures)); !recording)
      return recording;
  // the rules of the first robot that reports some are those of the recording and the page
  const auto know_rules = [&runtime](const std::string& rules) { runtime.know_rules(rules); };
  const Result<void> connected = (*robots)->connect({.robot = {},
                                                     .pictures = options.pictures,
                                                     .lossless = options.lossless,
                                                     .most_offset_ns = *most_offset_ns,
                                                     .on_rules = know_rules},
                                                    runtime.channels(), clock, own->clock_sample);
  if (!connected) return connected.failure();
  runtime.run([] { return true; });
  (*robots)->stop();
  return {};
}

}  // namespace robot::app
