// A process that is no robot reports the truth: through the door of a ground-truth server, and through a robot's.
#include "robot/body/attached/truth_door.h"

#include <gtest/gtest.h>

#include <string>

#include "proto/foresight/truth.pb.h"
#include "robot/client/foresight.h"
#include "robot/client/foresight_fields.h"
#include "robot/memory/memory.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

namespace robot::body {
namespace {

namespace pb = foresight;

/// A message with every field that a system may fill, written without protobuf.
std::string truth_without_protobuf() {
  unsigned char room[512], small[128], smaller[32];
  ForesightBytes covariance = foresight_bytes(smaller, sizeof smaller);
  foresight_put_float(&covariance, 1, 0.01F);
  foresight_put_float(&covariance, 2, 0.002F);
  foresight_put_float(&covariance, 3, 0.03F);
  ForesightBytes truth = foresight_bytes(room, sizeof room);
  ForesightBytes ball = foresight_bytes(small, sizeof small);
  for (int field = 1; field <= 5; ++field) foresight_put_float(&ball, field, 0.125F * static_cast<float>(field));
  foresight_put_bytes(&ball, 6, covariance.bytes, covariance.size);
  foresight_put_uint(&ball, 7, 17);
  foresight_put_uint(&ball, 8, 2);
  foresight_put_bytes(&truth, 1, ball.bytes, ball.size);
  ForesightBytes seen = foresight_bytes(small, sizeof small);
  foresight_put_uint(&seen, 1, 14);
  foresight_put_uint(&seen, 2, 3);
  for (int field = 3; field <= 5; ++field) foresight_put_float(&seen, field, 0.5F * static_cast<float>(field));
  foresight_put_uint(&seen, 6, 1);
  for (int field = 7; field <= 9; ++field) foresight_put_float(&seen, field, 0.0625F * static_cast<float>(field));
  foresight_put_bytes(&seen, 10, covariance.bytes, covariance.size);
  foresight_put_uint(&seen, 11, 18);
  foresight_put_uint(&seen, 12, 1);
  foresight_put_bytes(&truth, 2, seen.bytes, seen.size);
  foresight_put_uint(&truth, 3, 1'000'000'000'000);
  foresight_put_uint(&truth, 4, 1'000'000'000'001);
  foresight_put_bytes(&truth, 5, "apart", 5);
  EXPECT_FALSE(truth.overflow || ball.overflow || seen.overflow || covariance.overflow);
  return {reinterpret_cast<const char*>(truth.bytes), truth.size};
}

/// The same message, from protobuf.
constexpr const char* kTruth =
    R"(ball { x: 0.125 y: 0.25 velocity_x: 0.375 velocity_y: 0.5 confidence: 0.625 )"
    R"(covariance { xx: 0.01 xy: 0.002 yy: 0.03 } track: 17 sensors: 2 } )"
    R"(robots { team: 14 player: 3 x: 1.5 y: 2 heading: 2.5 fallen: true confidence: 0.4375 velocity_x: 0.5 )"
    R"(velocity_y: 0.5625 covariance { xx: 0.01 xy: 0.002 yy: 0.03 } track: 18 sensors: 1 } )"
    R"(detected_ns: 1000000000000 sent_ns: 1000000000001 disagreements: "apart")";

struct TruthDoor : testing::Test {
  void open(const std::set<std::string>& own_objects = {}) {
    auto opened = open_truth_door(path, own_objects, clock, channels, board);
    ASSERT_TRUE(opened) << opened.error();
    door = std::move(*opened);
  }

  using Writer = std::unique_ptr<ForesightWriter, decltype(&foresight_close)>;
  Writer announce(const char* topic, const char* type) {
    ForesightObject object{};
    object.topic = topic;
    object.type = type;
    object.message_encoding = "protobuf";
    return {foresight_announce_as(&object, path.c_str()), &foresight_close};
  }

  /// Writes until the door refuses, and returns its sentence.
  static std::string refusal_of(const Writer& writer) {
    std::string problem;
    EXPECT_TRUE(tests::eventually([&] {
      foresight_write(writer.get(), 1, "", 0);
      problem = foresight_problem(writer.get());
      return problem.find("refuses") != problem.npos;
    }));
    return problem;
  }

  /// Writes the message, and returns it as it is in memory.
  std::string written(const Writer& writer) {
    const std::string bytes = truth_without_protobuf();
    EXPECT_TRUE(foresight_write(writer.get(), kSecond, bytes.data(), bytes.size())) << foresight_problem(writer.get());
    const auto world = channels.find("/truth/world");
    if (!world || !tests::eventually([&] { return world->newest() != nullptr; })) return "nothing";
    EXPECT_EQ(world->newest()->capture_ns(), 6 * kSecond);  // on the clock of the server
    pb::GroundTruth truth;
    EXPECT_TRUE(truth.ParseFromString(std::string(world->newest()->bytes())));
    return truth.ShortDebugString();
  }

  const tests::TemporaryFolder folder;
  const std::filesystem::path path = folder / "door";
  const SessionClock clock{5 * kSecond};
  memory::Channels channels;
  logging::LoggingBoard board;
  std::unique_ptr<Door> door;
};

TEST_F(TruthDoor, AProcessThatIsNoRobotWritesTheWorldWithAllFields) {
  open();
  EXPECT_EQ(written(announce("/truth/world", "foresight.GroundTruth")), kTruth);
}

TEST_F(TruthDoor, TheNameWorldMeansTheWorld) {
  open();
  EXPECT_EQ(written(announce("world", "foresight.GroundTruth")), kTruth);
}

TEST_F(TruthDoor, ARobotsDoorTakesTheWorldAsAWholeTopic) {
  const auto memory = std::make_shared<memory::Memory>("14/2", clock);
  ASSERT_TRUE(list(memory, channels));
  door = *Door::open({.path = path, .robot = "14/2"}, clock, channels, board);
  EXPECT_EQ(written(announce("/truth/world", "foresight.GroundTruth")), kTruth);
  EXPECT_EQ(memory->truth.read()->value().ball().track(), 17u);
}

TEST_F(TruthDoor, AnyOtherTopicBelowTruthIsListedForTheServer) {
  open();
  const auto camera = announce("/truth/1/picture", "foresight.Image");
  EXPECT_TRUE(foresight_write(camera.get(), 1, "", 0));
  ASSERT_TRUE(tests::eventually([&] { return channels.find("/truth/1/picture") != nullptr; }));
  EXPECT_EQ(channels.find("/truth/1/picture")->info().schema.name, "foresight.Image");
}

TEST_F(TruthDoor, TopicsOfRobotsAreRefusedForWriting) {
  open();
  EXPECT_EQ(refusal_of(announce("/14/2/ball", "foresight.Ball")),
            "the runtime refuses: /14/2/ball: expected a topic below /truth/, got another one");
}

TEST_F(TruthDoor, AWrongTypeIsRefused) {
  open();
  EXPECT_EQ(refusal_of(announce("/truth/world", "foresight.Ball")),
            "the runtime refuses: /truth/world: expected protobuf messages of type 'foresight.GroundTruth', got "
            "'protobuf' of type 'foresight.Ball'");
}

TEST_F(TruthDoor, AWorldOfTheServersOwnSensorsIsWrittenByNoProcess) {
  open({"world"});
  EXPECT_EQ(
      refusal_of(announce("/truth/world", "foresight.GroundTruth")),
      "the runtime refuses: /truth/world: expected an object of the team's, got one that only the runtime writes");
}

TEST_F(TruthDoor, IsNotTakenFromAnotherServer) {
  open();
  const auto second = open_truth_door(path, {}, clock, channels, board);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().find("another runtime does"), std::string::npos) << second.error();
}

}  // namespace
}  // namespace robot::body
