#include "robot/app/lab_foresight.h"

#include <mutex>
#include <utility>

#include "proto/foresight/sim.pb.h"
#include "robot/app/foresight_control.h"
#include "robot/core/clock.h"
#include "robot/logging/file_provider.h"
#include "robot/logging/session.h"

namespace robot::app {
namespace {

constexpr const char* kSimulation = "/sim/state";
constexpr const char* kNewestRules = "spl2025";

/// The rules that a recorded simulation was played by.
std::string rules_of(const memory::Channels& channels) {
  const auto channel = channels.find(kSimulation);
  const auto version = channel ? channel->newest() : nullptr;
  foresight::Simulation simulation;
  if (!version) return kNewestRules;
  const std::string_view bytes = version->bytes();
  const bool parsed = simulation.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  return parsed && !simulation.rules().empty() ? simulation.rules() : kNewestRules;
}

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

}  // namespace

Result<foreseeing::Foreseer*> LabForesight::foreseer_for(const memory::Channels& channels) {
  const std::string rules = rules_.empty() ? rules_of(channels) : rules_;
  if (foreseer_ && prepared_ == rules) return foreseer_.get();
  auto made = foreseeing::Foreseer::open({.strategies = strategies_.empty() ? default_strategies() : strategies_,
                                          .rules = rules,
                                          .share = foreseeing::Share::background});
  if (!made) return Error{made.error()};
  foreseer_ = std::move(*made);
  prepared_ = rules;
  return foreseer_.get();
}

Result<foresight::Forecast> LabForesight::ask(const memory::Channels& channels, const std::string& robot,
                                              const foresight::WhatIf& question, std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  const Result<foreseeing::Foreseer*> foreseer = foreseer_for(channels);
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
    if (stream.topic != kSimulation &&
        (!stream.topic.starts_with("/" + robot + "/") || stream.schema == "foresight.Image"))
      continue;
    if (stream.messages == 0) continue;
    if (Result<void> taken = take_over(*session, stream, at_ns, clock, channels); !taken)
      return Error{stream.topic + ": " + taken.error()};
  }
  LabForesight foresight(options.rules, {});
  return foresight.ask(channels, robot, options.question, at_ns);
}

}  // namespace robot::app
