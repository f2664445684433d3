// Helpers of several tests of robot/net.
#pragma once

#include <unistd.h>

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/memory/channel.h"
#include "robot/net/serve/backend.h"

namespace tests {

inline robot::memory::ChannelInfo channel_info(std::string topic, robot::memory::Delivery delivery) {
  return {.topic = std::move(topic),
          .schema = {.name = "test.Thing", .encoding = "protobuf", .bytes = "schema"},
          .delivery = delivery};
}

/// A channel whose versions are taken out by hand.
class TestChannel {
 public:
  explicit TestChannel(std::string topic = "/14/2/test",
                       robot::memory::Delivery delivery = robot::memory::Delivery::latest)
      : channel(std::make_shared<robot::memory::RawChannel>(channel_info(std::move(topic), delivery), clock)) {}

  robot::memory::VersionPtr write(std::string_view bytes) {
    static_cast<void>(channel->write_bytes(bytes, ++capture_ns).operator bool());
    return channel->newest();
  }

  robot::ManualClock clock{1000};
  std::uint64_t capture_ns = 0;
  std::shared_ptr<robot::memory::RawChannel> channel;
};

/// Two sessions: "old" is complete, "live" is being written. `body` is what a recording holds.
class TestBackend final : public robot::net::Backend {
 public:
  std::string status_json() override { return R"({"name":"test"})"; }
  std::string sessions_json() override {
    return R"({"sessions":[{"session":"old","name":"<b>final</b>","url":"/logs/old.mcap","size_bytes":1500000,"start_ns":"1700000000000000000","state":"complete","streams":[{"topic":"/14/2/ball","url":"/logs/old/14.2.ball.mcap","messages":3,"size_bytes":10}]}]})";
  }
  robot::Result<robot::net::LogFile> open_log(const robot::net::LogRequest& request) override {
    if (request.session == "live" && !request.until_ns) return robot::net::LogFile{.redirect_until_ns = 77};
    if (request.session != "old" && request.session != "live")
      return robot::Error{"there is no session " + request.session};
    if (request.file)
      return robot::net::LogFile{.body = std::make_shared<robot::MemorySource>(*request.file), .etag = "f1"};
    return robot::net::LogFile{.body = std::make_shared<robot::MemorySource>(body), .etag = "e1"};
  }

  robot::net::HttpResponse session_files(const std::string& session, const robot::net::ClientLeft& left) override {
    // as long as the client waits, like the checksum of a large recording
    for (begun += session == "slow"; session == "slow" && !left();) ::usleep(1000);
    ended += session == "slow";
    return robot::net::text_response(200, "application/json", R"({"session":")" + session + R"(","files":[]})");
  }
  robot::net::HttpResponse delete_session(const std::string& session) override {
    deleted += session;
    return {.status = 204};
  }
  robot::net::HttpResponse recent(const std::vector<std::string>& topics) override {
    return robot::net::text_response(200, "application/octet-stream",
                                     topics.empty() ? "all" : topics.front() + "+" + std::to_string(topics.size() - 1));
  }
  robot::net::HttpResponse played(const robot::net::PlayedRequest& request) override {
    if (request.topic != "/14/2/ball") return Backend::played(request);
    robot::net::HttpResponse response = robot::net::text_response(
        200, "application/octet-stream", std::to_string(request.from_ns) + ".." + std::to_string(request.to_ns));
    response.headers.emplace_back(robot::net::kPlayedUntil, "7");
    return response;
  }
  bool match_mode() const override { return game; }

  std::string body = "0123456789", deleted;
  std::atomic<bool> game = false;
  std::atomic<int> begun = 0, ended = 0;  // requests for the files of the session "slow"
};

}  // namespace tests
