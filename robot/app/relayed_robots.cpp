#include "robot/app/relayed_robots.h"

#include <future>
#include <mutex>
#include <utility>

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

void fill(const lab::LinkStatus& status, Link& link) {
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

}  // namespace

Result<std::unique_ptr<RelayedRobots>> RelayedRobots::find(const std::vector<std::string>& words,
                                                           const std::filesystem::path& robots_file) {
  auto robots = lab::find_robots(words, robots_file.empty() ? lab::default_robots_file() : robots_file);
  if (!robots) return robots.failure();
  std::unique_ptr<RelayedRobots> found(new RelayedRobots);
  found->robots_ = std::move(*robots);
  found->names_ = ask_names(found->robots_);
  for (std::size_t i = 0; i < found->names_.size(); ++i)
    if (found->names_[i]) found->claims_.introduce(found->names_[i]->text(), static_cast<int>(i) + 1);
  return found;
}

RobotName RelayedRobots::first() const {
  for (const auto& name : names_)
    if (name) return *name;
  return {.team = 0, .player = 1};
}

Result<void> RelayedRobots::connect(const lab::LinkOptions& options, memory::Channels& channels, const Clock& clock,
                                    memory::MemoryObject<foresight::ClockSample>& clock_samples) {
  const auto on_clock = [&clock, &clock_samples](const std::string& peer, const lab::ClockOffset& offset) {
    clock_samples.write(sample_of(peer, offset), clock.now_ns());
  };
  const std::lock_guard guard(lock_);
  for (const lab::RobotAddress& robot : robots_) {
    lab::LinkOptions own = options;
    own.robot = robot;
    const int id = static_cast<int>(links_.size()) + 1;
    links_.push_back(std::make_unique<lab::RobotLink>(id, std::move(own), channels, claims_, clock, on_clock));
    const Result<void> begun = links_.back()->start();
    if (begun) continue;
    for (const auto& link : links_) link->stop();
    return begun.failure();
  }
  return {};
}

void RelayedRobots::describe(foresight::RuntimeStatistics& statistics) const {
  const std::lock_guard guard(lock_);
  for (const auto& link : links_) fill(link->status(), *statistics.add_links());
}

void RelayedRobots::stop() {
  const std::lock_guard guard(lock_);
  for (const auto& link : links_) link->stop();
}

}  // namespace robot::app
