// A hub whose streams, playback and background a test moves by hand.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/json_library.h"
#include "robot/net/foxglove/hub.h"
#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/frames.h"
#include "tests/robot/net/net_support.h"

namespace robot::net {

using Json = nlohmann::json;
using memory::Delivery;
using tests::TestChannel;

/// Streams whose providers the test writes to by hand.
class HandStreams final : public Streams {
 public:
  Id start(std::shared_ptr<memory::Channel> channel, std::unique_ptr<logging::OutProvider> provider) override {
    const std::lock_guard guard(lock_);
    log_ += "+" + channel->info().topic + " ";
    providers_[++last_] = std::move(provider);
    changed_.notify_all();
    return last_;
  }
  void stop(Id id) override {
    const std::lock_guard guard(lock_);
    log_ += "-" + std::to_string(id) + " ";
    providers_.erase(id);
    changed_.notify_all();
  }
  /// Waits until `count` streams were started in all; returns the last one's provider.
  logging::OutProvider& wait_started(Id count) {
    std::unique_lock guard(lock_);
    while (last_ < count) changed_.wait(lock_);
    return *providers_.at(count);
  }
  void wait_log(const std::string& expected) {
    std::unique_lock guard(lock_);
    while (log_ != expected) changed_.wait(lock_);  // a failure shows as the test's time-out
  }

 private:
  Mutex lock_;
  Condition changed_;
  std::map<Id, std::unique_ptr<logging::OutProvider>> providers_;
  Id last_ = 0;
  std::string log_;
};

/// "base" and its derived channel "base/twice", whose bytes are twice those of the source; "skip" has none.
inline std::vector<Derived> derive_twice(const memory::ChannelInfo& source) {
  if (!source.topic.ends_with("base")) return {};
  std::vector<Derived> derived(1);
  derived[0].info = tests::channel_info(source.topic + "/twice", Delivery::latest);
  derived[0].make_convert = []() -> Convert {
    return [](const memory::Version& version) -> Result<std::optional<std::string>> {
      if (version.bytes() == "skip") return std::optional<std::string>();
      if (version.bytes() == "fail") return Error{"told to fail"};
      return std::optional(std::string(version.bytes()) + std::string(version.bytes()));
    };
  };
  return derived;
}

class HandPlayhead;

/// Puts a playhead into the state that `wish` asks for. Returns whether that is another place.
inline bool obey(const foxglove::PlaybackControl& wish, Playhead::State& now) {
  now = {.status = wish.play ? foxglove::Playback::playing : foxglove::Playback::paused,
         .time_ns = wish.seek_ns.value_or(now.time_ns),
         .speed = wish.speed};
  return wish.seek_ns.has_value();
}

/// A recording from 1000 to 9000 that obeys every request.
class HandPlayback final : public Playback {
 public:
  std::uint64_t start_ns() const override { return 1000; }
  std::uint64_t end_ns() const override { return 9'000'000'005; }
  State state() const override { return now; }
  bool control(const foxglove::PlaybackControl& wish) override { return obey(wish, now); }
  Result<std::unique_ptr<OwnPlayhead>> own_playhead(std::optional<std::uint64_t> from_ns) override;
  State now;
  std::map<std::uint64_t, HandPlayhead*> own;  // by the time at which each was made
  bool has_room = true;
};

/// A playhead of one client's own that obeys every request. It has the channel "/14/2/base" of the recording.
class HandPlayhead final : public OwnPlayhead {
 public:
  HandPlayhead(HandPlayback& of, std::uint64_t from_ns) : of_(of), made_ns_(from_ns) {
    now = {.status = foxglove::Playback::paused, .time_ns = from_ns, .speed = 1};
    of_.own[made_ns_] = this;
  }
  ~HandPlayhead() override { of_.own.erase(made_ns_); }

  State state() const override { return now; }
  bool control(const foxglove::PlaybackControl& wish) override { return obey(wish, now); }
  std::shared_ptr<memory::Channel> watch(const memory::ChannelInfo& info) override {
    if (info.topic != "/14/2/base") return nullptr;
    ++watches;
    return base.channel;
  }
  void unwatch(const std::string& topic) override { watches -= topic == "/14/2/base"; }
  bool loop() override { return std::exchange(loops, false); }

  State now;
  TestChannel base{"/14/2/base", Delivery::latest};
  int watches = 0;
  bool loops = false;

 private:
  HandPlayback& of_;
  const std::uint64_t made_ns_;
};

inline Result<std::unique_ptr<OwnPlayhead>> HandPlayback::own_playhead(std::optional<std::uint64_t> from_ns) {
  if (!has_room) return Error{"there are too many"};
  const std::uint64_t begin_ns = from_ns && *from_ns >= start_ns() ? *from_ns : start_ns();
  return std::unique_ptr<OwnPlayhead>(std::make_unique<HandPlayhead>(*this, begin_ns));
}

class HubTest : public testing::Test {
 protected:
  TestChannel base{"/14/2/base", Delivery::latest}, events{"/14/2/events", Delivery::reliable},
      world{"/truth/world", Delivery::latest};
  ManualClock clock{1000};
  Parameters parameters;
  Services services;
  HandStreams streams;
  std::shared_ptr<Inbox> inbox = std::make_shared<Inbox>(1 << 20, [] {});
  StreamControl control{streams, inbox};
  std::unique_ptr<Hub> hub;
  std::vector<std::string> thought_about;

  void SetUp() override {
    ASSERT_TRUE(control.start_thread());
    parameters.declare("quality", std::int64_t{75}, {.min = 1, .max = 100});
    add_clock_sync(services, clock, {});
    services.add("think", Services::For::questions, [this](const Json& request, const ClientContext& asker) -> Json {
      EXPECT_GT(asker.asked_ns, 0u);
      thought_about.push_back(request["about"]);
      return {{"ok", true}, {"about", request["about"]}};
    });
    make_hub(nullptr);
  }
  void make_hub(Playback* playback) {
    hub = std::make_unique<Hub>(HubOptions{.metadata = {{"robots", "14/2"}},
                                           .queues = {.reliable_bytes = 10, .lossless_bytes = 10},
                                           .playback = playback},
                                parameters, services, clock, control,
                                [this](Hub::Kind kind, const auto& work, const auto& then) {
                                  background.push_back([work, then] { work(), then(); });
                                  if (kind == Hub::Kind::order || !holds_questions) do_next();
                                });
    hub->add_channel(base.channel, derive_twice);
    hub->add_channel(events.channel, derive_twice);
    hub->add_channel(world.channel, derive_twice);
  }
  void TearDown() override { inbox->close(); }

  /// Runs the last background task.
  void do_next() {
    const auto work = std::move(background.back());
    background.pop_back();
    work();
  }
  bool holds_questions = false;
  std::vector<std::function<void()>> background;

  std::shared_ptr<Client> join(bool lossless = false, bool may_control = true) {
    auto client = hub->join({.context = {.address = "10.0.0.9:1", .may_control = may_control}, .lossless = lossless});
    said(*client);
    return client;
  }

  /// Returns the messages that wait for a client: JSON texts, and data as {"op":"data"…}, "time", "ping", "close".
  static std::vector<Json> said(Client& client) {
    std::vector<Json> all;
    std::string bytes;
    Batch batch;
    while (client.queue.fill(batch)) bytes.append(batch.bytes).append(batch.large);
    FrameParser parser(Sender::server, 64 << 20);
    parser.feed(bytes, [&](Opcode opcode, const std::string& payload) {
      if (opcode == Opcode::text) return all.push_back(Json::parse(payload)), true;
      if (opcode == Opcode::ping) return all.push_back({{"op", "ping"}}), true;
      if (opcode == Opcode::close) return all.push_back({{"op", "close"}, {"code", parse_close(payload).code}}), true;
      const auto data = foxglove::parse_message_data(payload);
      if (*data)
        return all.push_back({{"op", "data"}, {"sub", (*data)->subscription}, {"text", (*data)->payload}}), true;
      all.push_back({{"op", payload[0] == 2 ? "time" : "response"}, {"bytes", payload.substr(1)}});
      return true;
    });
    return all;
  }
  /// As above, only op and the most important field: "status:the sentence data:abc".
  static std::string gist(Client& client) {
    std::string log;
    for (const Json& message : said(client)) {
      log += (log.empty() ? "" : " ") + message["op"].get<std::string>();
      for (const char* key : {"message", "text"})
        if (message.contains(key)) log += ":" + message[key].get<std::string>();
    }
    return log;
  }
  void drain() {
    Inbox::Contents contents;
    inbox->take(contents);
    for (const auto& item : contents.items) hub->deliver(item);
  }
  void ask(Client& client, const std::string& about) {
    hub->on_binary(client, foxglove::to_bytes(foxglove::ServiceCall{2, 5, "json", R"({"about":")" + about + "\"}"}));
  }
  /// The answers of services that wait for a client, as JSON.
  static std::vector<Json> answered(Client& client) {
    std::vector<Json> all;
    for (const Json& message : said(client)) {
      const auto& bytes = message["bytes"].get_ref<const std::string&>();
      all.push_back(Json::parse(bytes.substr(bytes.find('{'))));
    }
    return all;
  }
  void subscribe(Client& client, std::uint32_t channel, std::uint32_t subscription = 1) {
    hub->on_text(client, foxglove::to_text(foxglove::Subscribe{{{subscription, channel}}}));
  }

  /// Writes that many messages at once. The client receives the newest one; the others are dropped for it.
  void send(Client& client, logging::OutProvider& provider, int messages) {
    for (int i = 0; i < messages; ++i) EXPECT_TRUE(provider.write(base.write("x")));
    drain();
    gist(client);
  }
};

}  // namespace robot::net
