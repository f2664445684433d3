// A link to a robot's server on loopback.
#include "robot/lab/relay/robot_link.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/camera.pb.h"
#include "robot/core/report.h"
#include "robot/image/image_codec.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/schema.h"
#include "robot/net/foxglove/derived_channels.h"
#include "robot/net/serve/board_streams.h"
#include "robot/net/serve/server.h"
#include "tests/robot/net/net_support.h"
#include "tests/robot/net/scripted_server.h"
#include "tests/support/eventually.h"

namespace robot::lab {
namespace {

using memory::Delivery;

/// Longest wait for a name. Only a failure takes this long.
constexpr std::uint64_t kPatience = 60 * kSecond;

/// A clock with an offset that can be corrected.
class SettableClock final : public Clock {
 public:
  explicit SettableClock(std::int64_t ahead_ns) : ahead_ns_(ahead_ns) {}
  std::uint64_t now_ns() const override { return right_.now_ns() + static_cast<std::uint64_t>(ahead_ns_.load()); }
  void set_right() { ahead_ns_ = 0; }

 private:
  const SessionClock right_;
  std::atomic<std::int64_t> ahead_ns_;
};

/// The server, the channels and the clock of a robot's runtime.
class Robot {
 public:
  explicit Robot(const std::string& name, std::int64_t ahead_ns = 0, std::uint16_t port = 0,
                 std::map<std::string, std::string> metadata = {})
      : clock(ahead_ns), name_(name), metadata_(std::move(metadata)) {
    metadata_["robots"] = name;
    net::declare_image_parameters(parameters);
    net::add_clock_sync(services, clock, [this](const net::PeerClock& peer) {
      const std::lock_guard guard(lock_);
      measured_.push_back(peer);
    });
    port_ = port;
  }

  std::shared_ptr<memory::RawChannel> add(memory::ChannelInfo info) {
    auto channel = std::make_shared<memory::RawChannel>(std::move(info), clock);
    EXPECT_TRUE(channels.add(channel));
    return channel;
  }
  void start() {
    server = std::make_unique<net::Server>(
        net::ServerOptions{.port = port_, .hub = {.metadata = metadata_, .queues = {}}}, channels,
        [this](const memory::ChannelInfo& info) { return net::derived_channels(info, parameters); }, streams, clock,
        parameters, services, application);
    const auto started = server->start();
    ASSERT_TRUE(started) << started.error();
    port_ = server->port();
  }
  RobotAddress address() const {
    return {.name = name_, .addresses = {"ws://127.0.0.1:" + std::to_string(port_) + "/"}};
  }
  std::vector<net::PeerClock> measured() {
    const std::lock_guard guard(lock_);
    return measured_;
  }

  SettableClock clock;
  memory::Channels channels;
  logging::LoggingBoard board;
  net::BoardStreams streams{board};
  net::Parameters parameters;
  net::Services services;
  tests::TestBackend application;
  std::unique_ptr<net::Server> server;

 private:
  const std::string name_;
  std::map<std::string, std::string> metadata_;
  std::uint16_t port_ = 0;
  std::mutex lock_;
  std::vector<net::PeerClock> measured_;
};

/// A listener that keeps all versions of a channel.
class Kept final : public memory::Listener {
 public:
  explicit Kept(memory::Channel& channel) : channel_(channel) { channel.attach(*this); }
  ~Kept() override { channel_.detach(*this); }
  void on_version(const memory::VersionPtr& version) override {
    const std::lock_guard guard(lock_);
    versions_.push_back(version);
  }
  std::vector<memory::VersionPtr> versions() const {
    const std::lock_guard guard(lock_);
    return versions_;
  }

 private:
  memory::Channel& channel_;
  mutable std::mutex lock_;
  std::vector<memory::VersionPtr> versions_;
};

struct Relaying : testing::Test {
  const SessionClock clock;
  memory::Channels channels;
  TopicClaims claims;
  std::mutex lock;
  std::vector<ClockOffset> offsets;

  std::unique_ptr<RobotLink> link(const Robot& robot, LinkOptions options = {}, int id = 1) {
    options.robot = robot.address();
    auto made = std::make_unique<RobotLink>(id, options, channels, claims, clock,
                                            [this](const std::string&, const ClockOffset& offset) {
                                              const std::lock_guard guard(lock);
                                              offsets.push_back(offset);
                                            });
    EXPECT_TRUE(made->start());
    return made;
  }
  /// Waits until `topic` has a message of these bytes.
  void wait_for(const std::string& topic, std::string_view bytes) {
    const auto newest = [&]() -> std::string {
      const auto channel = channels.find(topic);
      const auto version = channel ? channel->newest() : nullptr;
      return version ? std::string(version->bytes()) : "no message";
    };
    ASSERT_TRUE(tests::eventually_equal(newest, bytes)) << topic;
  }
};

TEST_F(Relaying, KeepsTopicsSchemasAndEveryMessageAlsoOfUnknownObjects) {
  Robot robot("14/2");
  const auto ball = robot.add({.topic = "/14/2/ball", .schema = memory::schema_of(*foresight::Ball::descriptor())});
  const auto vortex = robot.add({.topic = "/14/2/vortex",
                                 .message_encoding = "json",
                                 .schema = {.name = "Vortex", .encoding = "jsonschema", .bytes = "{}"},
                                 .delivery = Delivery::reliable});
  robot.start();
  const auto relayed = link(robot, {.lossless = true});
  EXPECT_TRUE(ball->write_bytes("\x08\x01", 1));
  EXPECT_TRUE(vortex->write_bytes("0", 1));
  wait_for("/14/2/ball", "\x08\x01");
  wait_for("/14/2/vortex", "0");
  const Kept kept(*channels.find("/14/2/vortex"));
  for (std::uint64_t i = 1; i <= 500; ++i) EXPECT_TRUE(vortex->write_bytes(std::to_string(i), i * 1000));
  // an object that is offered later is relayed too
  const auto late =
      robot.add({.topic = "/14/2/late", .message_encoding = "json", .schema = {}, .delivery = Delivery::fifo});
  EXPECT_TRUE(late->write_bytes("{}", 7));
  wait_for("/14/2/vortex", "500");
  wait_for("/14/2/late", "{}");

  for (const auto& channel : robot.channels.all())
    EXPECT_EQ(channels.find(channel->info().topic)->info(), channel->info());
  const auto versions = kept.versions();
  ASSERT_EQ(versions.size(), 501u);
  for (std::uint64_t i = 1; i <= 500; ++i) {
    EXPECT_EQ(versions[i]->bytes(), std::to_string(i));
    EXPECT_EQ(versions[i]->capture_ns(), i * 1000);
    EXPECT_EQ(versions[i]->sequence(), versions[0]->sequence() + i);
  }
  EXPECT_EQ(versions.back()->publish_ns(), vortex->newest()->publish_ns());
  const LinkStatus status = relayed->status();
  EXPECT_EQ(status.state, LinkStatus::State::connected);
  EXPECT_EQ(status.robot, "14/2");
  EXPECT_EQ(status.lost, 0u);
  EXPECT_EQ(status.received, 503u);
}

TEST_F(Relaying, ReportsTheRulesOfTheRobotsGameBeforeItsFirstMessage) {
  Robot robot("14/2", 0, 0, {{"rules", "spl2012:4"}});
  const auto channel = robot.add({.topic = "/14/2/x", .message_encoding = "json", .schema = {}});
  EXPECT_TRUE(channel->write_bytes("{}", 1));
  robot.start();
  std::string rules, carried;  // before the first message
  const auto relayed = link(robot, {.on_rules = [&](const std::string& reported) {
                              const std::lock_guard guard(lock);
                              rules = reported;
                              if (channels.find("/14/2/x")) carried = "a channel before the rules";
                            }});
  wait_for("/14/2/x", "{}");
  const std::lock_guard guard(lock);
  EXPECT_EQ(rules, "spl2012:4");
  EXPECT_EQ(carried, "");
}

// "relay: ws://127.0.0.1:1/: ws://127.0.0.1:1/: Connection refused" once named it twice
TEST_F(Relaying, ASentenceNamesAnAddressOnce) {
  std::string said;
  set_report_listener([&](const Report& report) {
    const std::lock_guard guard(lock);
    if (said.empty()) said = report.sentence;
  });
  const std::string address = "ws://127.0.0.1:1/";
  RobotLink refused(1, {.robot = {.name = address, .addresses = {address}}}, channels, claims, clock,
                    [](const std::string&, const ClockOffset&) {});
  ASSERT_TRUE(refused.start());
  const auto sentence = [&] {
    const std::lock_guard guard(lock);
    return said;
  };
  ASSERT_TRUE(tests::eventually([&] { return !sentence().empty(); }));
  set_report_listener({});
  EXPECT_EQ(sentence(), address + ": Connection refused; connecting again");
}

TEST_F(Relaying, ConnectsAgainAndCountsTheLostMessages) {
  auto robot = std::make_unique<Robot>("14/2");
  const memory::ChannelInfo info{
      .topic = "/14/2/x", .message_encoding = "json", .schema = {}, .delivery = Delivery::reliable};
  auto channel = robot->add(info);
  robot->start();
  const std::uint16_t port = robot->server->port();
  const auto relayed = link(*robot);
  EXPECT_TRUE(channel->write_bytes("before", 1));
  wait_for("/14/2/x", "before");
  robot.reset();
  ASSERT_TRUE(tests::eventually([&] { return relayed->status().state == LinkStatus::State::connecting; }))
      << "the end of the connection";
  EXPECT_FALSE(relayed->status().problem.empty());

  robot = std::make_unique<Robot>("14/2", 0, port);
  channel = robot->add(info);
  for (const char* text : {"missed", "missed, too", "after"}) EXPECT_TRUE(channel->write_bytes(text, 2));
  robot->start();
  wait_for("/14/2/x", "after");
  ASSERT_TRUE(tests::eventually([&] { return relayed->status().lost == 2; })) << "the lost messages";
  EXPECT_EQ(relayed->status().connections, 2u);
  EXPECT_EQ(channels.find("/14/2/x")->newest()->sequence(), 4u);
}

TEST_F(Relaying, AWrongClockIsCorrectedAndBothSidesGetTheMeasurement) {
  Robot robot("14/2", 2'000'000'000);
  const auto ball = robot.add({.topic = "/14/2/ball", .schema = memory::schema_of(*foresight::Ball::descriptor())});
  robot.start();
  const auto relayed = link(robot);
  ASSERT_TRUE(tests::eventually([&] { return relayed->status().state == LinkStatus::State::connected; }))
      << "the connection";
  const LinkStatus status = relayed->status();
  ASSERT_TRUE(status.clock);
  EXPECT_LE(std::abs(status.clock->offset_ns - 2'000'000'000),
            static_cast<std::int64_t>(status.clock->error_ns + kMillisecond));
  EXPECT_EQ(status.shift_ns, -status.clock->offset_ns);

  foresight::Ball seen;
  const std::uint64_t at_ns = robot.clock.now_ns();
  seen.set_seen_ns(at_ns);
  EXPECT_TRUE(ball->write_bytes(seen.SerializeAsString(), at_ns));
  const std::uint64_t shown_ns = at_ns + static_cast<std::uint64_t>(status.shift_ns);
  seen.set_seen_ns(shown_ns);
  wait_for("/14/2/ball", seen.SerializeAsString());
  EXPECT_EQ(channels.find("/14/2/ball")->newest()->capture_ns(), shown_ns);
  // the robot receives the measurement, to record it
  ASSERT_FALSE(robot.measured().empty());
  const net::PeerClock peer = robot.measured().back();
  EXPECT_LE(std::abs(peer.offset_ns + 2'000'000'000),
            static_cast<std::int64_t>(*peer.round_trip_ns / 2 + kMillisecond));
  const std::lock_guard guard(lock);
  EXPECT_FALSE(offsets.empty());
}

TEST_F(Relaying, AClockWithATooLargeOffsetIsRefusedWithTheOffset) {
  Robot robot("14/2", 5'000'000'000);
  const auto channel = robot.add({.topic = "/14/2/x", .message_encoding = "json", .schema = {}});
  robot.start();
  EXPECT_TRUE(channel->write_bytes("{}", 1));
  const auto relayed = link(robot, {.most_offset_ns = kSecond});
  ASSERT_TRUE(tests::eventually([&] {
    return relayed->status().state == LinkStatus::State::refused && !relayed->status().problem.empty();
  })) << "the refusal";
  // the offset is as exact as the round trip was short
  const std::string problem = relayed->status().problem;
  double ahead = 0, error_ms = 0;
  ASSERT_EQ(std::sscanf(problem.c_str(), "its clock is %lf s ahead (± %lf ms)", &ahead, &error_ms), 2) << problem;
  EXPECT_LE(std::abs(ahead - 5), 1e-3 * (error_ms + 1)) << problem;
  EXPECT_NE(problem.find("), more than the 1 s of --max-clock-offset: set the clock right, or allow more"),
            std::string::npos)
      << problem;
  EXPECT_EQ(channels.find("/14/2/x"), nullptr);
}

TEST_F(Relaying, ARunThatWasRefusedFirstIsStillANewRun) {
  auto robot = std::make_unique<Robot>("14/2");
  const memory::ChannelInfo info{
      .topic = "/14/2/x", .message_encoding = "json", .schema = {}, .delivery = Delivery::reliable};
  auto channel = robot->add(info);
  robot->start();
  const std::uint16_t port = robot->server->port();
  const auto relayed = link(*robot, {.most_offset_ns = kSecond});
  for (const char* text : {"1", "2", "3", "4"}) EXPECT_TRUE(channel->write_bytes(text, 1));
  wait_for("/14/2/x", "4");
  robot.reset();
  robot = std::make_unique<Robot>("14/2", 5'000'000'000, port);
  channel = robot->add(info);
  robot->start();
  ASSERT_TRUE(tests::eventually([&] { return relayed->status().state == LinkStatus::State::refused; }))
      << "the refusal";
  robot->clock.set_right();
  EXPECT_TRUE(channel->write_bytes("of the new run", 2));
  wait_for("/14/2/x", "of the new run");
}

TEST_F(Relaying, ImagesArriveAsJpegUnderTheirOwnTopicOrRawOrNotAtAll) {
  Robot robot("14/2");
  const memory::ChannelInfo info{.topic = "/14/2/camera_top",
                                 .schema = memory::schema_of(*foresight::Image::descriptor())};
  const auto camera = robot.add(info);
  robot.start();
  foresight::Image image;
  image.set_encoding(foresight::Image::ENCODING_YUYV);
  image.set_width(64);
  image.set_height(48);
  image.set_data(std::string(64 * 48 * 2, '\x80'));
  EXPECT_TRUE(camera->write_bytes(image.SerializeAsString(), 1'700'000'000 * kSecond));

  {
    const auto relayed = link(robot);
    ASSERT_TRUE(tests::eventually([&] {
      return channels.find("/14/2/camera_top") && channels.find("/14/2/camera_top")->newest();
    })) << "a picture";
    EXPECT_EQ(channels.find("/14/2/camera_top")->info(), info);
    EXPECT_EQ(channels.all().size(), 1u) << "derived channels are left out";
    const auto newest = channels.find("/14/2/camera_top")->newest();
    foresight::Image jpeg;
    ASSERT_TRUE(jpeg.ParseFromString(std::string(newest->bytes())));
    EXPECT_EQ(jpeg.encoding(), foresight::Image::ENCODING_JPEG);
    EXPECT_EQ(jpeg.width(), 64u);
    EXPECT_EQ(jpeg.height(), 48u);
    EXPECT_EQ(newest->capture_ns(), 1'700'000'000 * kSecond);
    const auto decoded = image::decode_jpeg(jpeg.data());
    ASSERT_TRUE(decoded);
    EXPECT_NEAR(static_cast<unsigned char>(decoded->yuyv[0]), 0x80, 3);
  }
  {
    memory::Channels others;
    TopicClaims anew;
    RobotLink raw(1, {.robot = robot.address(), .pictures = Pictures::raw}, others, anew, clock, [](auto&&...) {});
    ASSERT_TRUE(raw.start());
    ASSERT_TRUE(tests::eventually([&] {
      return others.find("/14/2/camera_top") && others.find("/14/2/camera_top")->newest();
    })) << "a picture";
    EXPECT_EQ(others.find("/14/2/camera_top")->newest()->bytes(), image.SerializeAsString());
  }
  {
    memory::Channels others;
    TopicClaims anew;
    const auto last = robot.add({.topic = "/14/2/last", .message_encoding = "json", .schema = {}});
    RobotLink none(1, {.robot = robot.address(), .pictures = Pictures::none}, others, anew, clock, [](auto&&...) {});
    ASSERT_TRUE(none.start());
    ASSERT_TRUE(tests::eventually([&] { return others.find("/14/2/last") != nullptr; })) << "the other channel";
    EXPECT_EQ(others.find("/14/2/camera_top"), nullptr);
  }
}

TEST_F(Relaying, OnlyTheWantedObjectsAreFetched) {
  Robot robot("14/2");
  const auto ball = robot.add({.topic = "/14/2/ball", .message_encoding = "json", .schema = {}});
  const auto pose = robot.add({.topic = "/14/2/pose", .message_encoding = "json", .schema = {}});
  robot.start();
  const auto relayed = link(robot, {.objects = {"pose"}});
  EXPECT_TRUE(ball->write_bytes("a ball", 1));
  EXPECT_TRUE(pose->write_bytes("a pose", 1));
  wait_for("/14/2/pose", "a pose");
  EXPECT_EQ(channels.all().size(), 1u);
}

TEST_F(Relaying, ARobotsOwnTopicsComeFromThatRobot) {
  Robot two("14/2"), three("14/3");
  const memory::ChannelInfo info{
      .topic = "/14/3/x", .message_encoding = "json", .schema = {}, .delivery = Delivery::reliable};
  const auto rumour = two.add(info), truth = three.add(info);
  two.start();
  three.start();
  const auto first = link(two);
  EXPECT_TRUE(rumour->write_bytes("rumour", 1));
  wait_for("/14/3/x", "rumour");
  const auto second = link(three, {}, 2);
  EXPECT_TRUE(truth->write_bytes("truth", 2));
  wait_for("/14/3/x", "truth");
  const Kept kept(*channels.find("/14/3/x"));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(rumour->write_bytes("rumour", 3));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(truth->write_bytes(std::to_string(i), 4));
  wait_for("/14/3/x", "19");
  for (const auto& version : kept.versions()) EXPECT_NE(version->bytes(), "rumour");
}

TEST_F(Relaying, AnotherSchemaUnderTheSameTopicIsLeftOut) {
  Robot robot("14/2");
  robot.add({.topic = "/14/2/x",
             .message_encoding = "json",
             .schema = {.name = "New", .encoding = "jsonschema", .bytes = "{}"}});
  const auto other = robot.add({.topic = "/14/2/y", .message_encoding = "json", .schema = {}});
  const auto known = std::make_shared<memory::RawChannel>(
      memory::ChannelInfo{.topic = "/14/2/x", .message_encoding = "json", .schema = {.name = "Old"}}, clock);
  ASSERT_TRUE(channels.add(known));
  robot.start();
  EXPECT_TRUE(robot.channels.find("/14/2/x")->write_bytes("new", 1));
  EXPECT_TRUE(other->write_bytes("{}", 1));
  const auto relayed = link(robot);
  wait_for("/14/2/y", "{}");
  EXPECT_EQ(known->newest(), nullptr);
}

/// Returns the frames of a server that offers /1/2/good among items that are wrong in every way.
std::string wrong_items() {
  std::string truncated;
  net::foxglove::append_numbered_data_header(truncated, 1, 5, {.sequence = 1, .publish_ns = 5});
  truncated.pop_back();
  std::string frames = tests::server_frame(
      net::Opcode::text, net::foxglove::server_info({.name = "x", .metadata = {{"robots", "1/2"}}, .session_id = "1"}));
  for (const char* text :
       {R"({"op":"parameterValues","parameters":[{"name":"x","value":NaN}]})", R"({"op":"status","level":"bad"})",
        R"({"op":"dance","id":[]})", "no JSON", R"({"op":"advertise","channels":7})",
        R"({"op":"advertiseServices","services":[{"id":"one","name":"clock_sync"},7]})",
        R"({"op":"advertise","channels":[{"id":1,"topic":"/1/2/bad","schemaEncoding":"protobuf","schema":"%%%"},
           {"id":"two","topic":"/1/2/worse"},{"id":NaN,"topic":"/1/2/worst"},
           {"id":3,"topic":"/1/2/good","encoding":"json","metadata":{"rate":Infinity}}]})"})
    frames += tests::server_frame(net::Opcode::text, text);
  return frames + tests::server_frame(net::Opcode::binary, truncated) +
         tests::server_frame(net::Opcode::binary, "\x03\x01");
}

TEST_F(Relaying, AWrongItemIsLeftOutAndReportedOnceAndTheRestGoesOn) {
  std::vector<std::string> reports;
  set_report_listener([&](const Report& report) {
    const std::lock_guard guard(lock);
    reports.push_back(report.sentence);
  });
  {
    tests::ScriptedServer server([](tests::ScriptedPeer& peer) {
      peer.send(peer.read_request() + wrong_items() + wrong_items());
      EXPECT_NE(peer.next_frame().find(R"({"channelId":3,"id":1})"), std::string::npos);
      std::string message;
      net::foxglove::append_message_data_header(message, 1, 7);
      peer.send(tests::server_frame(net::Opcode::binary, message + "fine"));
      peer.wait_closed();
    });
    RobotLink link(1, {.robot = {.name = "tim", .addresses = {server.url()}}}, channels, claims, clock,
                   [](auto&&...) {});
    ASSERT_TRUE(link.start());
    wait_for("/1/2/good", "fine");
    EXPECT_EQ(link.status().connections, 1u);
    EXPECT_EQ(link.status().problem, "");
  }
  set_report_listener({});
  for (const char* part :
       {"the schema of \"/1/2/bad\"", "'id' of \"/1/2/worse\", got \"two\"", "'id' of \"/1/2/worst\"",
        "'channels', got 7", "'id' of \"clock_sync\"", "server message: expected JSON",
        "message data: expected a header", "service response: it is cut short"})
    EXPECT_EQ(std::ranges::count_if(reports,
                                    [&](const std::string& said) {
                                      return said.find(part) != said.npos && said.starts_with("tim: ") &&
                                             said.ends_with("; it is left out");
                                    }),
              1)
        << part;
}

TEST_F(Relaying, ARobotWhoseClockServiceFailsIsRelayedWithoutIt) {
  for (const bool answers : {true, false}) {
    tests::ScriptedServer server([answers](tests::ScriptedPeer& peer) {
      using namespace net::foxglove;
      peer.send(peer.read_request() + tests::server_frame(net::Opcode::text, server_info({.name = "x"})) +
                tests::server_frame(net::Opcode::text, advertise_services({{7, "clock_sync"}})) +
                tests::server_frame(net::Opcode::text, R"({"op":"advertise","channels":[{"id":3,"topic":"/x"}]})"));
      peer.next_frame();  // the call
      peer.send(answers ? tests::server_frame(net::Opcode::binary, service_response(7, 1, "json", "{\"ok\":false}"))
                        : tests::server_frame(net::Opcode::text, service_call_failure(7, 1, "broken")));
      EXPECT_NE(peer.next_frame().find("subscribe"), std::string::npos);
      std::string message;
      append_message_data_header(message, 1, 7);
      peer.send(tests::server_frame(net::Opcode::binary, message + (answers ? "after an answer" : "after a failure")));
      peer.wait_closed();
    });
    RobotLink link(1, {.robot = {.name = "tim", .addresses = {server.url()}}}, channels, claims, clock,
                   [](auto&&...) {});
    ASSERT_TRUE(link.start());
    wait_for("/x", answers ? "after an answer" : "after a failure");
    EXPECT_EQ(link.status().state, LinkStatus::State::connected);
    EXPECT_EQ(link.status().clock, std::nullopt);
  }
}

TEST(AskName, ReturnsTheNameOfTheRobotOrAnError) {
  Robot robot("14/7");
  robot.start();
  const auto name = ask_name(robot.address(), kPatience);
  ASSERT_TRUE(name) << name.error();
  EXPECT_EQ(*name, "14/7");
  EXPECT_FALSE(ask_name({.name = "nobody", .addresses = {"ws://127.0.0.1:1/"}}, kPatience));
}

}  // namespace
}  // namespace robot::lab
