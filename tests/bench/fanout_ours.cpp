#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/thread.h"
#include "robot/net/serve/server.h"
#include "tests/bench/fanout.h"

namespace bench {
namespace {

using robot::memory::Channel;
using robot::memory::VersionPtr;
namespace net = robot::net;

/// A version of bytes that exist already.
class PremadeVersion final : public robot::memory::Version {
 public:
  explicit PremadeVersion(std::string_view bytes) : bytes_(bytes) {}
  std::string_view bytes() const override { return bytes_; }

 private:
  std::string_view bytes_;
};

/// Makes its versions once and sends them repeatedly, each time with the next number.
class PremadeChannel final : public Channel {
 public:
  PremadeChannel(std::size_t versions, std::size_t payload_bytes, const robot::Clock& clock)
      : payload_(payload_bytes, 'x') {
    announce({.topic = "/14/2/fanout",
              .schema = {.name = "bench.Bytes", .encoding = "", .bytes = ""},
              .delivery = robot::memory::Delivery::fifo},
             clock);
    for (std::size_t i = 0; i < versions; ++i) versions_.push_back(std::make_shared<PremadeVersion>(payload_));
  }

  /// Returns nothing if the oldest is not sent yet.
  VersionPtr next() {
    std::shared_ptr<PremadeVersion>& version = versions_[at_];
    if (version.use_count() > 1) return nullptr;
    at_ = (at_ + 1) % versions_.size();
    publish(version, 1, payload_.size());
    return version;
  }

  robot::Result<void> write_bytes(std::string_view, std::uint64_t) override { return {}; }

 private:
  const std::string payload_;
  std::vector<std::shared_ptr<PremadeVersion>> versions_;
  std::size_t at_ = 0;
};

/// Replaces the logging board: sends without end, but never more than the clients' queues hold.
class SaturatingStreams final : public net::Streams {
 public:
  SaturatingStreams(PremadeChannel& channel, const FanoutLoad& load, FanoutShared& shared)
      : channel_(channel), load_(load), shared_(shared), window_(window(load)) {}
  ~SaturatingStreams() override { stop(1); }

  static constexpr std::size_t kBatch = 1024;

  /// [messages] most that are not yet at the slowest client.
  static std::size_t window(const FanoutLoad& load) {
    return std::min<std::size_t>(32768, (8u << 20) / load.payload_bytes);
  }

  Id start(std::shared_ptr<Channel>, std::unique_ptr<robot::logging::OutProvider> provider) override {
    provider_ = std::move(provider);
    thread_ = std::thread([this] { produce(); });
    return 1;
  }

  void stop(Id) override {
    stopped_ = true;
    if (provider_) provider_->cancel();
    if (thread_.joinable()) thread_.join();
    provider_.reset();
  }

 private:
  void produce() {
    robot::become_background_thread("producer");
    // all clients connect before it begins, so each gets every message
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    for (std::uint64_t sent = 0; !stopped_;) {
      const std::vector<VersionPtr> batch = make_batch();
      if (batch.empty() || sent + batch.size() > shared_.least(load_.clients) + window_) {
        wait_for_room(sent + batch.size());
        if (batch.empty()) continue;
      }
      for (const VersionPtr& version : batch)
        if (!provider_->write(version)) return;
      sent += batch.size();
    }
  }

  /// Versions as the robot's threads make them: their cost is not the server's.
  std::vector<VersionPtr> make_batch() {
    const std::uint64_t cpu_before = robot::thread_cpu_ns();
    std::vector<VersionPtr> batch;
    batch.reserve(kBatch);
    while (batch.size() < kBatch) {
      VersionPtr version = channel_.next();
      if (!version) break;
      batch.push_back(std::move(version));
    }
    shared_.making_ns += robot::thread_cpu_ns() - cpu_before;
    return batch;
  }

  void wait_for_room(std::uint64_t sent) const {
    do std::this_thread::sleep_for(std::chrono::microseconds(100));
    while (!stopped_ && sent > shared_.least(load_.clients) + window_);
  }

  PremadeChannel& channel_;
  const FanoutLoad load_;
  FanoutShared& shared_;
  const std::size_t window_;
  std::unique_ptr<robot::logging::OutProvider> provider_;
  std::atomic<bool> stopped_ = false;
  std::thread thread_;
};

class NoApplication final : public net::Backend {
 public:
  std::string status_json() override { return "{}"; }
  std::string sessions_json() override { return "{}"; }
  robot::Result<net::LogFile> open_log(const net::LogRequest&) override { return robot::Error{"there are none"}; }
  net::HttpResponse session_files(const std::string&, const net::ClientLeft&) override { return {.status = 404}; }
  net::HttpResponse delete_session(const std::string&) override { return {.status = 404}; }
  bool match_mode() const override { return false; }
};

}  // namespace

void serve_ours(const FanoutLoad& load, FanoutShared& shared) {
  const robot::SessionClock clock;
  const auto channel = std::make_shared<PremadeChannel>(2 * SaturatingStreams::window(load), load.payload_bytes, clock);
  robot::memory::Channels channels;
  static_cast<void>(channels.add(channel).operator bool());
  SaturatingStreams streams(*channel, load, shared);
  net::Parameters parameters;
  const net::Services services;
  NoApplication application;
  net::Server server(
      {.port = 0}, channels, [](const auto&) { return std::vector<net::Derived>(); }, streams, clock, parameters,
      services, application);
  if (auto started = server.start(); !started) {
    std::fprintf(stderr, "bench_fanout: %s\n", started.error().c_str());
    return;
  }
  shared.port = server.port();
  while (!shared.ended) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  server.stop();
}

}  // namespace bench
