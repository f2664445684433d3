#include "robot/app/services/statistics_service.h"

#include <algorithm>
#include <utility>

namespace robot::app {
namespace {

using foresight::RuntimeStatistics;

float per_second(std::uint64_t now, std::uint64_t before, double seconds) {
  return seconds > 0 && now >= before ? static_cast<float>(static_cast<double>(now - before) / seconds) : 0;
}

void add_logger(RuntimeStatistics& to, const logging::StreamStatus& stream) {
  auto& logger = *to.add_loggers();
  logger.set_topic(stream.topic);
  logger.set_written(stream.messages);
  logger.set_dropped(stream.dropped);
  logger.set_queued_bytes(stream.queued_bytes);
}

void add_client(RuntimeStatistics& to, const net::ClientStatistics& from) {
  auto& client = *to.add_clients();
  client.set_id(static_cast<std::uint32_t>(from.id));
  client.set_address(from.address);
  client.set_user_agent(from.user_agent);
  client.set_subprotocol(from.subprotocol);
  if (from.round_trip_ns) client.set_round_trip_ns(*from.round_trip_ns);
  client.set_lossless(from.lossless);
  for (const net::ClientChannelStatistics& watched : from.channels) {
    auto& channel = *client.add_channels();
    channel.set_topic(watched.topic);
    channel.set_sent(watched.sent);
    channel.set_dropped(watched.dropped);
    channel.set_queued_messages(static_cast<std::uint32_t>(watched.queued_messages));
    channel.set_queued_bytes(watched.queued_bytes);
  }
}

RuntimeStatistics::Recording::State state_of(logging::RecordingStatus::State state) {
  switch (state) {
    case logging::RecordingStatus::State::off: return RuntimeStatistics::Recording::STATE_OFF;
    case logging::RecordingStatus::State::recording: return RuntimeStatistics::Recording::STATE_RECORDING;
    case logging::RecordingStatus::State::disk_full: return RuntimeStatistics::Recording::STATE_DISK_FULL;
  }
  return RuntimeStatistics::Recording::STATE_UNSPECIFIED;
}

}  // namespace

RuntimeStatistics StatisticsService::collect(const net::ServerStatistics& server) {
  const std::uint64_t now_ns = monotonic_ns();
  const double seconds = last_ns_ == 0 ? 0 : static_cast<double>(now_ns - last_ns_) * 1e-9;
  last_ns_ = now_ns;
  RuntimeStatistics statistics;
  add_streams(statistics, seconds);
  for (const logging::StreamStatus& stream : board_.statuses()) add_logger(statistics, stream);
  add_recording(statistics, seconds);
  for (const net::ClientStatistics& client : server.clients) add_client(statistics, client);
  add_process(statistics, seconds);
  return statistics;
}

void StatisticsService::add_streams(RuntimeStatistics& to, double seconds) {
  for (const auto& channel : channels_.all()) {
    auto& stream = *to.add_streams();
    stream.set_topic(channel->info().topic);
    const memory::VersionPtr newest = channel->newest();
    if (!newest) continue;
    std::uint64_t& before = counts_[channel->info().topic];
    stream.set_count(newest->sequence());
    stream.set_rate_hz(per_second(newest->sequence(), before, seconds));
    stream.set_size_bytes(newest->size_bytes());
    stream.set_age_ns(clock_.now_ns() - std::min(clock_.now_ns(), newest->capture_ns()));
    before = newest->sequence();
  }
}

void StatisticsService::add_recording(RuntimeStatistics& to, double seconds) {
  auto& recording = *to.mutable_recording();
  const logging::RecordingStatus status = recorder_ ? recorder_->status() : logging::RecordingStatus{};
  recording.set_state(state_of(status.state));
  recording.set_session(status.session);
  recording.set_profile(status.profile);
  recording.set_size_bytes(status.size_bytes);
  recording.set_bytes_per_second(per_second(status.size_bytes, recorded_bytes_, seconds));
  recording.set_message(status.message);
  recorded_bytes_ = status.size_bytes;
}

void StatisticsService::add_process(RuntimeStatistics& to, double seconds) {
  const ProcessUsage usage = process_usage();
  auto& process = *to.mutable_process();
  process.set_cpu(per_second(usage.cpu_ns, cpu_ns_, seconds) * 1e-9f);
  process.set_resident_bytes(usage.resident_bytes);
  process.set_disk_free_bytes(store_.disk_free_bytes());
  process.set_log_dir_bytes(store_.size_bytes());
  process.set_uptime_ns(last_ns_ - started_ns_);
  cpu_ns_ = usage.cpu_ns;
}

}  // namespace robot::app
