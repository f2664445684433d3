#include "robot/app/lab_foresight.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/app/recorded_moment.h"
#include "robot/app/services/foresight_service.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/sessions/session_provider.h"
#include "sim/foresight/rollout_statistics.h"

namespace robot::app {
namespace {

/// Adds a channel of that topic. It holds the newest message of the stream at or before `at_ns`, if there is one.
Result<void> take_over(logging::InProvider& stream, const std::string& topic, std::uint64_t at_ns, const Clock& clock,
                       memory::Channels& channels) {
  Result<memory::ChannelInfo> info = stream.open();
  if (!info) return info.failure();
  info->topic = topic;  // a robot may be played under another name than the recorded one
  const auto channel = std::make_shared<memory::RawChannel>(*info, clock);
  if (Result<void> moved = stream.seek(at_ns); !moved) return moved;
  const auto record = stream.read();
  if (!record) return record.failure();
  if (*record && (*record)->capture_ns <= at_ns)
    if (Result<void> written = channel->write_bytes((*record)->bytes, (*record)->capture_ns); !written) return written;
  return channels.add(channel);
}

/// Returns the topics that a question about `robot` needs.
std::vector<std::string> topics_of(const std::string& robot) {
  std::vector<std::string> topics{memory::kSimulationTopic};
  const bridge::Recollection none;
  bridge::Recollection::visit(none, [&](const char* name, const auto&) { topics.push_back("/" + robot + "/" + name); });
  return topics;
}

/// Appends the default strategies to the given ones, without repetition, up to the greatest number of a question.
std::vector<std::string> with_default_strategies(std::vector<std::string> strategies) {
  for (const std::string& name : default_strategies())
    if (std::ranges::find(strategies, name) == strategies.end() && strategies.size() < sim::foresight::kMaxStrategies)
      strategies.push_back(name);
  return strategies;
}

}  // namespace

std::vector<std::string> LabForesight::strategies() const { return with_default_strategies(options_.strategies); }

Result<std::shared_ptr<foreseeing::Foreseer>> LabForesight::foreseer_for(const foreseeing::GameSetting& setting) {
  const std::lock_guard guard(lock_);
  if (foreseer_ && prepared_ == setting) return foreseer_;
  auto made = foreseeing::Foreseer::open({.strategies = strategies(),
                                          .rules = setting.rules,
                                          .models = setting.models,
                                          .opponent_models = setting.opponent_models,
                                          .share = foreseeing::Share::background});
  if (!made) return made.failure();
  foreseer_ = std::move(*made);
  if (hurries_) foreseer_->hurry();
  prepared_ = setting;
  return foreseer_;
}

void LabForesight::hurry() {
  const std::lock_guard guard(lock_);
  hurries_ = true;
  if (foreseer_) foreseer_->hurry();
}

Result<foresight::Forecast> LabForesight::ask(const logging::StreamOf& stream_of, const std::string& robot,
                                              const foresight::WhatIf& question, std::uint64_t now_ns) {
  const SessionClock clock;
  memory::Channels channels;
  for (const std::string& topic : topics_of(robot)) {
    const auto stream = stream_of(topic);
    if (!stream) continue;
    if (Result<void> taken = take_over(*stream, topic, now_ns, clock, channels); !taken) return taken.failure(topic);
  }
  const auto simulation = bridge::simulation_of(channels);
  const auto foreseer =
      foreseer_for(foreseeing::setting_of(simulation ? &simulation->value : nullptr, robot, options_.rules));
  if (!foreseer) return foreseer.failure();
  return ask_for(**foreseer, channels, robot, question, now_ns);
}

Result<foresight::Forecast> what_if(const WhatIfOptions& options) {
  const Result<logging::Session> session = logging::open_session(options.session);
  if (!session) return session.failure();
  const Result<std::uint64_t> at_ns = time_in(*session, options.at);
  if (!at_ns) return at_ns.failure();
  const std::string robot = options.robot.empty() ? session->info.robot : options.robot;

  LabForesight foresight(options.foresight);
  const auto stream_of = [&](const std::string& topic) -> std::unique_ptr<logging::InProvider> {
    const auto file = std::ranges::find(session->streams, topic, &logging::StreamFile::topic);
    if (file == session->streams.end() || file->messages == 0) return nullptr;
    return logging::provider_of(*session, *file);
  };
  return foresight.ask(stream_of, robot, options.question, *at_ns);
}

}  // namespace robot::app
