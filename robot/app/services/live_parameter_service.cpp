#include "robot/app/services/live_parameter_service.h"

#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "robot/app/services/announced_parameter.h"
#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/memory/schema.h"

namespace robot::app {

using foresight::LiveParameter;
using foresight::LiveParameters;

/// The announcements of all processes. The table of parameters holds the values.
class LiveParameterService::Core : public std::enable_shared_from_this<Core> {
 public:
  Core(net::Parameters& parameters, std::string topic, const Clock& clock)
      : parameters_(parameters),
        topic_(std::move(topic)),
        clock_(clock),
        channel_(std::make_shared<memory::RawChannel>(
            memory::ChannelInfo{.topic = topic_, .schema = memory::schema_of(*LiveParameters::descriptor())}, clock)) {}

  const std::shared_ptr<memory::RawChannel>& channel() const { return channel_; }

  void follow(const std::shared_ptr<memory::Channel>& channel);
  void leave();
  void ended(const std::string& topic);
  void write();

 private:
  struct Process : memory::Listener {
    Process(Core& core_to_tell, std::string its_name, std::shared_ptr<memory::Channel> its_channel)
        : core(core_to_tell), name(std::move(its_name)), channel(std::move(its_channel)) {}
    void on_version(const memory::VersionPtr& version) override { core.announced(*this, version->bytes()); }

    Core& core;
    const std::string name;
    const std::shared_ptr<memory::Channel> channel;

    // guarded by the core's lock
    std::vector<LiveParameter> parameters;  // that were accepted, with their full names
    std::string problem;                    // one sentence; empty: none
    std::string reported;                   // the problem that was reported last
    bool gone = false;
  };

  void announced(Process& process, std::string_view bytes);
  std::vector<net::OfferedParameter> accept(Process& process, std::string_view bytes);
  Result<net::OfferedParameter> offered(const Process& process, const LiveParameter& announced,
                                        const std::set<std::string>& names);
  std::size_t others_than(const Process& process) const;
  LiveParameters all() const;

  net::Parameters& parameters_;
  const std::string topic_;
  const Clock& clock_;
  const std::shared_ptr<memory::RawChannel> channel_;

  mutable Mutex lock_;
  std::map<std::string, std::unique_ptr<Process>> processes_;  // by name

  Mutex writing_;  // held from reading the values to writing them, so that the newest message is right
  std::string written_;
};

/// Listens to `channel` if a process announces its parameters there.
void LiveParameterService::Core::follow(const std::shared_ptr<memory::Channel>& channel) {
  const std::string& topic = channel->info().topic;
  if (!topic.starts_with(topic_ + "/")) return;
  const std::string name = topic.substr(topic_.size() + 1);
  Process* process = nullptr;
  {
    const std::lock_guard guard(lock_);
    auto& place = processes_[name];
    place = std::make_unique<Process>(*this, name, channel);
    process = place.get();
  }
  channel->attach(*process);
}

void LiveParameterService::Core::leave() {
  // no process is added any more
  for (const auto& [name, process] : processes_) process->channel->detach(*process);
}

std::size_t LiveParameterService::Core::others_than(const Process& process) const {
  std::size_t count = 0;
  for (const auto& [name, other] : processes_)
    if (other.get() != &process) count += other->parameters.size();
  return count;
}

Result<net::OfferedParameter> LiveParameterService::Core::offered(const Process& process,
                                                                  const LiveParameter& announced,
                                                                  const std::set<std::string>& names) {
  auto checked = offered_parameter(announced, process.name);
  if (!checked) return checked;
  if (names.contains(checked->name))
    return Error{"parameter '" + announced.name() + "': expected each name once, got it again"};
  if (others_than(process) + names.size() >= kMaxParameters)
    return Error{"parameter '" + announced.name() + "': expected at most " + std::to_string(kMaxParameters) +
                 " parameters of all processes, got one more"};
  // the table asks before it takes a value
  checked->rule.apply = [core = weak_from_this(), name = process.name,
                         full = checked->name](const net::ParameterValue& value) -> Result<void> {
    if (const auto* text = std::get_if<std::string>(&value); text && text->size() > kMaxTextBytes)
      return Error{"parameter '" + full + "': expected a text of at most " + std::to_string(kMaxTextBytes) +
                   " bytes, got " + std::to_string(text->size())};
    const auto alive = core.lock();
    if (!alive) return {};
    const std::lock_guard guard(alive->lock_);
    if (!alive->processes_.at(name)->gone) return {};
    return Error{"parameter '" + full + "': expected a process that runs, but '" + name + "' has disconnected"};
  };
  return checked;
}

/// Keeps the announcement's parameters that are right, and one sentence about the first that is not.
std::vector<net::OfferedParameter> LiveParameterService::Core::accept(Process& process, std::string_view bytes) {
  const std::lock_guard guard(lock_);
  process.gone = false;
  process.problem.clear();
  process.parameters.clear();
  std::vector<net::OfferedParameter> accepted;
  const auto complain = [&](const std::string& sentence) {
    if (process.problem.empty()) process.problem = sentence;
  };

  LiveParameters announcement;
  const memory::ChannelInfo& info = process.channel->info();
  if (!is_process_name(process.name)) {
    complain("expected a name of a process of 1 to " + std::to_string(kMaxProcessBytes) +
             " letters, digits, '_' and '-'");
  } else if (info.message_encoding != "protobuf" || info.schema.name != LiveParameters::descriptor()->full_name() ||
             !announcement.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    complain("expected a message foresight.LiveParameters, got something else");
  }
  std::set<std::string> names;
  for (LiveParameter& parameter : *announcement.mutable_parameter()) {
    auto entry = offered(process, parameter, names);
    if (!entry) {
      complain(entry.error());
      continue;
    }
    names.insert(entry->name);
    parameter.set_name(entry->name);
    parameter.clear_gone();
    process.parameters.push_back(std::move(parameter));
    accepted.push_back(std::move(*entry));
  }
  return accepted;
}

/// Called by the thread that reads the process's messages.
void LiveParameterService::Core::announced(Process& process, std::string_view bytes) {
  std::vector<net::OfferedParameter> accepted = accept(process, bytes);
  // the table calls its listeners, and so write(): without our lock
  for (const std::string& problem : parameters_.offer(process.name + ".", std::move(accepted)))
    report(Level::warning, "parameters", problem);
  std::string news;
  {
    const std::lock_guard guard(lock_);
    if (process.problem != process.reported) news = process.reported = process.problem;
  }
  if (!news.empty()) report(Level::warning, "parameters", process.name + ": " + news);
  write();
}

void LiveParameterService::Core::ended(const std::string& topic) {
  if (!topic.starts_with(topic_ + "/")) return;
  {
    const std::lock_guard guard(lock_);
    const auto process = processes_.find(topic.substr(topic_.size() + 1));
    if (process == processes_.end()) return;
    process->second->gone = true;
    process->second->problem.clear();
  }
  write();
}

LiveParameters LiveParameterService::Core::all() const {
  LiveParameters message;
  const std::lock_guard guard(lock_);
  for (const auto& [name, process] : processes_) {
    for (const LiveParameter& parameter : process->parameters) {
      LiveParameter& added = *message.add_parameter() = parameter;
      if (const auto value = parameters_.get(parameter.name())) put_value(added, *value);
      if (process->gone) added.set_gone(true);
    }
    if (!process->problem.empty()) message.add_problem(name + ": " + process->problem);
  }
  return message;
}

void LiveParameterService::Core::write() {
  const std::lock_guard guard(writing_);
  std::string bytes = all().SerializeAsString();
  if (bytes == written_ && channel_->newest()) return;
  written_ = std::move(bytes);
  [[maybe_unused]] const Result<void> written = channel_->write_bytes(written_, clock_.now_ns());
}

Result<std::unique_ptr<LiveParameterService>> LiveParameterService::open(net::Parameters& parameters,
                                                                         const std::string& robot,
                                                                         memory::Channels& channels,
                                                                         const Clock& clock) {
  const auto core = std::make_shared<Core>(parameters, "/" + robot + "/live_parameters", clock);
  if (Result<void> added = channels.add(core->channel()); !added) return added.failure();
  core->write();
  // the table outlives the service
  parameters.listen([weak = std::weak_ptr(core)](const std::vector<std::string>&) {
    if (const auto alive = weak.lock()) alive->write();
  });
  return std::unique_ptr<LiveParameterService>(new LiveParameterService(core, channels));
}

LiveParameterService::LiveParameterService(std::shared_ptr<Core> core, memory::Channels& channels)
    : core_(std::move(core)), channels_(channels) {
  watcher_ = channels_.watch([core = core_.get()](const auto& channel) { core->follow(channel); });
}

LiveParameterService::~LiveParameterService() {
  channels_.unwatch(watcher_);
  core_->leave();
}

void LiveParameterService::ended(const std::string& topic) { core_->ended(topic); }

}  // namespace robot::app
