#include "robot/app/lab_foresight.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/app/foresight_control.h"
#include "robot/core/clock.h"
#include "robot/logging/file_provider.h"
#include "robot/logging/session.h"
#include "sim/foresight/tally.h"
#include "sim/io/source.h"

namespace robot::app {
namespace {

/// Puts the newest message of a stream at or before `at_ns` into a channel of its topic.
Result<void> take_over(const logging::Session& session, const logging::StreamFile& file, std::uint64_t at_ns,
                       const Clock& clock, memory::Channels& channels) {
  const auto stream = logging::provider_of(session, file);
  const Result<memory::ChannelInfo> info = stream->open();
  if (!info) return Error{info.error()};
  if (Result<void> moved = stream->seek(at_ns); !moved) return moved;
  const auto record = stream->read();
  if (!record) return Error{record.error()};
  if (!*record || (*record)->capture_ns > at_ns) return {};
  const auto channel = std::make_shared<memory::RawChannel>(*info, clock);
  if (Result<void> written = channel->write_bytes((*record)->bytes, (*record)->capture_ns); !written) return written;
  return channels.add(channel);
}

/// Models of a recording that are none of ours any more cannot be had.
std::string models_called(const std::string& name) {
  const auto names = sim::io::names_of("models");
  return std::ranges::find(names, name) == names.end() ? "match" : name;
}

/// Of that list: what is asked of first, then those that there are anyway.
std::vector<std::string> with_default_strategies(std::vector<std::string> strategies) {
  for (const std::string& name : default_strategies())
    if (std::ranges::find(strategies, name) == strategies.end() && strategies.size() < sim::foresight::kMaxStrategies)
      strategies.push_back(name);
  return strategies;
}

}  // namespace

LabForesight::Setting LabForesight::setting_of(const memory::Channels& channels, const std::string& robot) const {
  Setting setting{.rules = foreseeing::kNewestRules, .models = "match", .opponent_models = "match"};
  const auto simulation = foreseeing::simulation_of(channels);
  if (simulation && !simulation->value.rules().empty()) {
    const foresight::SimulatedTeam &home = simulation->value.home(), &away = simulation->value.away();
    const bool is_home = robot.starts_with(std::to_string(home.number()) + "/");
    setting = {.rules = simulation->value.rules(),
               .models = models_called((is_home ? home : away).models()),
               .opponent_models = models_called((is_home ? away : home).models())};
  }
  if (!options_.rules.empty()) setting.rules = options_.rules;
  return setting;
}

Result<foreseeing::Foreseer*> LabForesight::foreseer_for(const Setting& setting) {
  if (foreseer_ && prepared_ == setting) return foreseer_.get();
  auto made = foreseeing::Foreseer::open({.strategies = with_default_strategies(options_.strategies),
                                          .rules = setting.rules,
                                          .models = setting.models,
                                          .opponent_models = setting.opponent_models,
                                          .share = foreseeing::Share::background});
  if (!made) return Error{made.error()};
  foreseer_ = std::move(*made);
  prepared_ = setting;
  return foreseer_.get();
}

Result<foresight::Forecast> LabForesight::ask(const memory::Channels& channels, const std::string& robot,
                                              const foresight::WhatIf& question, std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  const Result<foreseeing::Foreseer*> foreseer = foreseer_for(setting_of(channels, robot));
  if (!foreseer) return Error{foreseer.error()};
  return ask_for(**foreseer, channels, robot, question, now_ns);
}

Result<foresight::Forecast> what_if(const WhatIfOptions& options) {
  const Result<logging::Session> session = logging::open_session(options.session);
  if (!session) return Error{session.error()};
  const auto at = static_cast<std::int64_t>(options.at * 1e9);
  const std::uint64_t at_ns = (at < 0 ? session->end_ns : session->start_ns) + static_cast<std::uint64_t>(at);
  if (at_ns < session->start_ns || at_ns > session->end_ns)
    return Error{"--at: the session is " +
                 std::to_string(static_cast<double>(session->end_ns - session->start_ns) / 1e9) + " s long, got " +
                 std::to_string(options.at)};
  const std::string robot = options.robot.empty() ? session->info.robot : options.robot;

  const SessionClock clock;
  memory::Channels channels;
  for (const logging::StreamFile& stream : session->streams) {
    // nothing else is asked for, and images are large
    if (stream.topic != foreseeing::kSimulationTopic &&
        (!stream.topic.starts_with("/" + robot + "/") || stream.schema == "foresight.Image"))
      continue;
    if (stream.messages == 0) continue;
    if (Result<void> taken = take_over(*session, stream, at_ns, clock, channels); !taken)
      return Error{stream.topic + ": " + taken.error()};
  }
  LabForesight foresight(options.foresight);
  return foresight.ask(channels, robot, options.question, at_ns);
}

}  // namespace robot::app
