#include "robot/app/relay.h"

#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "robot/app/clock_option.h"
#include "robot/app/foxglove_download.h"
#include "robot/app/lab_objects.h"
#include "robot/app/robot_name.h"
#include "robot/app/runtime.h"
#include "robot/app/services/futures_service.h"
#include "robot/app/services/reasons_service.h"
#include "robot/app/signals.h"
#include "robot/core/files.h"
#include "robot/lab/relay/robot_address.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kAskNs = 2 * kSecond;

using Link = foresight::RuntimeStatistics::Link;

Link::State state_of(lab::LinkStatus::State state) {
  switch (state) {
    case lab::LinkStatus::State::connecting: return Link::STATE_CONNECTING;
    case lab::LinkStatus::State::connected: return Link::STATE_CONNECTED;
    case lab::LinkStatus::State::refused: return Link::STATE_REFUSED;
  }
  return Link::STATE_UNSPECIFIED;
}

void describe(const lab::LinkStatus& status, Link& link) {
  link.set_state(state_of(status.state));
  link.set_name(status.name);
  link.set_address(status.address);
  link.set_robot(status.robot);
  link.set_received(status.received);
  link.set_lost(status.lost);
  link.set_connections(status.connections);
  if (status.clock) {
    link.set_clock_offset_ns(status.clock->offset_ns);
    link.set_clock_error_ns(status.clock->error_ns);
  }
  link.set_shift_ns(status.shift_ns);
  link.set_message(status.problem);
}

/// Asks all robots for their names at the same time, for 2 s. A robot that does not answer has no name in the result.
std::vector<std::optional<RobotName>> ask_names(const std::vector<lab::RobotAddress>& robots) {
  // with both policies a robot is asked later, by this thread, if the system allows no more threads
  constexpr auto kPolicy = std::launch::async | std::launch::deferred;
  std::vector<std::future<Result<std::string>>> answers;
  for (const lab::RobotAddress& robot : robots)
    answers.push_back(std::async(kPolicy, [&robot] { return lab::ask_name(robot, kAskNs); }));
  std::vector<std::optional<RobotName>> names;
  for (auto& answer : answers) {
    const Result<std::string> text = answer.get();
    const Result<RobotName> name = text ? parse_robot_name(*text) : Result<RobotName>(text.failure());
    names.push_back(name ? std::optional(*name) : std::nullopt);
  }
  return names;
}

/// Returns the name of the first robot that answered. Session and page get this name.
RobotName first_of(const std::vector<std::optional<RobotName>>& names) {
  for (const auto& name : names)
    if (name) return *name;
  return {.team = 0, .player = 1};
}

foresight::ClockSample sample_of(const std::string& robot, const lab::ClockOffset& offset) {
  foresight::ClockSample sample;
  sample.set_source(foresight::ClockSample::SOURCE_PEER);
  sample.set_monotonic_ns(monotonic_ns());
  sample.set_system_ns(system_ns());
  sample.set_peer(robot);
  sample.set_offset_ns(offset.offset_ns);
  sample.set_round_trip_ns(2 * offset.error_ns);
  return sample;
}

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
  const auto robots =
      lab::find_robots(options.robots, options.robots_file.empty() ? lab::default_robots_file() : options.robots_file);
  if (!robots) return robots.failure("relay");
  block_end_signals();

  const SessionClock clock;
  const auto own = std::make_shared<LabObjects>(clock);
  const std::vector<std::optional<RobotName>> names = ask_names(*robots);
  const RobotName name = first_of(names);
  lab::TopicClaims claims;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i]) claims.introduce(names[i]->text(), static_cast<int>(i) + 1);
  Mutex lock;  // guards `links`: the statistics read it while links are added
  std::vector<std::unique_ptr<lab::RobotLink>> links;
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
                   .add_statistics =
                       [&](foresight::RuntimeStatistics& statistics) {
                         const std::lock_guard guard(lock);
                         for (const auto& link : links) describe(link->status(), *statistics.add_links());
                       }},
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
  for (const lab::RobotAddress& robot : *robots) {
    const std::lock_guard guard(lock);
    links.push_back(std::make_unique<lab::RobotLink>(static_cast<int>(links.size()) + 1,
                                                     lab::LinkOptions{.robot = robot,
                                                                      .pictures = options.pictures,
                                                                      .lossless = options.lossless,
                                                                      .most_offset_ns = *most_offset_ns,
                                                                      .on_rules = know_rules},
                                                     runtime.channels(), claims, clock,
                                                     [&](const std::string& peer, const lab::ClockOffset& offset) {
                                                       own->clock_sample.write(sample_of(peer, offset), clock.now_ns());
                                                     }));
    if (Result<void> begun = links.back()->start(); !begun) return begun;
  }
  runtime.run([] { return true; });
  for (const auto& link : links) link->stop();
  return {};
}

}  // namespace robot::app
