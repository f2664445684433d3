#include "robot/net/scene/scene_channels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <set>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/memory/memory.h"
#include "tests/robot/net/scene/decoded.h"

namespace robot::net {
namespace {

using nlohmann::json;

/// A robot's memory and the channels that are derived from it, as a server offers them.
class SceneChannels : public testing::Test {
 protected:
  ManualClock clock{1};
  std::shared_ptr<memory::Memory> memory = std::make_shared<memory::Memory>("14/2", clock);
  memory::Channels channels;
  foresight::Field field;  // of the rules
  SceneSources sources{.channels = channels, .each_second = "/14/2/runtime", .field = [this] { return field; }};

  void SetUp() override {
    ASSERT_TRUE(memory::list(memory, channels));
    field.set_length(9);
    field.set_width(6);
    field.set_penalty_mark(1.3F);
  }

  std::map<std::string, std::string> offered() const {
    std::map<std::string, std::string> topics;
    for (const auto& channel : channels.all())
      for (const Derived& derived : scene_channels(channel->info(), sources))
        topics[derived.info.topic] = derived.info.schema.name;
    return topics;
  }

  /// Returns the derived message of `topic` for the newest version of its source, or null if there is none.
  json message(const std::string& topic) const {
    for (const auto& channel : channels.all())
      for (const Derived& derived : scene_channels(channel->info(), sources)) {
        if (derived.info.topic != topic || !channel->newest()) continue;
        const auto bytes = derived.make_convert()(*channel->newest());
        if (!bytes || !*bytes) return nullptr;
        return tests::decoded(derived.info.schema, **bytes);
      }
    return nullptr;
  }

  void write_pose(float x, float y, float heading) {
    foresight::Pose pose;
    pose.set_x(x);
    pose.set_y(y);
    pose.set_heading(heading);
    memory->pose.write(pose, kSecond);
  }
  void write_matrix(std::initializer_list<float> rotation, float focal) {
    foresight::CameraMatrix matrix;
    for (const float value : rotation) matrix.add_rotation(value);
    matrix.set_z(0.5F);
    matrix.set_width(640);
    matrix.set_height(480);
    matrix.set_focal_x(focal);
    matrix.set_focal_y(focal + 1);
    matrix.set_centre_x(320);
    matrix.set_centre_y(240);
    memory->camera_top_matrix.write(matrix, kSecond);
  }
};

// the camera looks along the robot's x, its x to the robot's right
constexpr std::initializer_list<float> kAhead = {0, 0, 1, -1, 0, 0, 0, -1, 0};

TEST_F(SceneChannels, BelongToTruthPoseCamerasAndTheProcess) {
  const std::map<std::string, std::string> expected = {
      {"/14/2/camera_bottom_matrix/calibration", "foxglove.CameraCalibration"},
      {"/14/2/camera_bottom_matrix/transforms", "foxglove.FrameTransforms"},
      {"/14/2/camera_top_matrix/calibration", "foxglove.CameraCalibration"},
      {"/14/2/camera_top_matrix/transforms", "foxglove.FrameTransforms"},
      {"/14/2/pose/scene", "foxglove.SceneUpdate"},
      {"/14/2/pose/transforms", "foxglove.FrameTransforms"},
      {"/field/scene", "foxglove.SceneUpdate"},
      {"/truth/world/scene", "foxglove.SceneUpdate"}};
  EXPECT_EQ(offered(), expected);
}

TEST_F(SceneChannels, EveryFrameIsAnnouncedInTheTransforms) {
  write_pose(1, 2, 0);
  write_matrix(kAhead, 600);
  memory->truth.write(foresight::GroundTruth(), kSecond);
  memory->runtime.write(foresight::RuntimeStatistics(), kSecond);
  std::set<std::string> announced, used;
  for (const auto& [topic, schema] : offered()) {
    const json found = message(topic);
    if (topic.find("camera_bottom") != std::string::npos) continue;
    ASSERT_FALSE(found.is_null()) << topic;
    if (found.contains("transforms"))
      for (const json& transform : found["transforms"]) {
        announced.insert(transform["child_frame_id"]);
        announced.insert(transform["parent_frame_id"]);
      }
    if (found.contains("entities"))
      for (const json& entity : found["entities"]) used.insert(entity["frame_id"]);
    if (found.contains("frame_id")) used.insert(found["frame_id"]);
  }
  EXPECT_EQ(announced, (std::set<std::string>{"field", "robot 14/2", "robot 14/2 camera_top"}));
  for (const std::string& frame : used) EXPECT_TRUE(announced.contains(frame)) << frame;
}

TEST_F(SceneChannels, TheRobotsFrameIsAtItsBelievedPose) {
  write_pose(1, 2, static_cast<float>(std::numbers::pi / 2));
  const json transform = message("/14/2/pose/transforms")["transforms"][0];
  EXPECT_EQ(transform["parent_frame_id"], "field");
  EXPECT_EQ(transform["child_frame_id"], "robot 14/2");
  EXPECT_EQ(transform["translation"], (json{{"x", 1.0}, {"y", 2.0}, {"z", 0.0}}));
  EXPECT_NEAR(transform["rotation"]["z"], std::sqrt(0.5), 1e-6);
  foresight::GameState game;
  game.set_attacks_positive_x(false);
  memory->game.write(game, kSecond);
  const json turned = message("/14/2/pose/transforms")["transforms"][0];
  EXPECT_EQ(turned["translation"], (json{{"x", -1.0}, {"y", -2.0}, {"z", 0.0}}));
}

TEST_F(SceneChannels, ACamerasFrameAndProjectionAreThoseOfItsMatrix) {
  write_matrix(kAhead, 600);
  const json transform = message("/14/2/camera_top_matrix/transforms")["transforms"][0];
  EXPECT_EQ(transform["parent_frame_id"], "robot 14/2");
  EXPECT_EQ(transform["child_frame_id"], "robot 14/2 camera_top");
  EXPECT_EQ(transform["translation"]["z"], 0.5);
  // a point 2 m ahead of the camera and 1 m to its right is ahead and to the right of the robot
  const json turn = transform["rotation"];
  const double x = turn["x"], y = turn["y"], z = turn["z"], w = turn["w"];
  const double ahead = 2 * (x * z + w * y) * 2 + (1 - 2 * (y * y + z * z)) * 1;
  const double left = 2 * (y * z - w * x) * 2 + 2 * (x * y + w * z) * 1;
  EXPECT_NEAR(ahead, 2, 1e-6);
  EXPECT_NEAR(left, -1, 1e-6);
  const json calibration = message("/14/2/camera_top_matrix/calibration");
  EXPECT_EQ(calibration["frame_id"], "robot 14/2 camera_top");
  EXPECT_EQ(calibration["width"], 640);
  EXPECT_EQ(calibration["K"], (json{600.0, 0.0, 320.0, 0.0, 601.0, 240.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(calibration["P"], (json{600.0, 0.0, 320.0, 0.0, 0.0, 601.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0}));
  EXPECT_EQ(calibration["R"], (json{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}));
}

TEST_F(SceneChannels, EachRotationKeepsItsLengthAndDirection) {
  for (int step = 0; step < 64; ++step) {
    const double angle = step * std::numbers::pi / 32;
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    const std::initializer_list<float> about[] = {
        {1, 0, 0, 0, c, -s, 0, s, c}, {c, 0, s, 0, 1, 0, -s, 0, c}, {c, -s, 0, s, c, 0, 0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis) {
      write_matrix(about[axis], 600);
      const json turn = message("/14/2/camera_top_matrix/transforms")["transforms"][0]["rotation"];
      const double part[] = {turn["x"], turn["y"], turn["z"]}, w = turn["w"];
      // a quaternion and its negative are the same rotation
      const double sign = w * std::cos(angle / 2) + part[axis] * std::sin(angle / 2) < 0 ? -1 : 1;
      EXPECT_NEAR(sign * w, std::cos(angle / 2), 1e-5) << step << " about " << axis;
      for (int other = 0; other < 3; ++other)
        EXPECT_NEAR(sign * part[other], other == axis ? std::sin(angle / 2) : 0, 1e-5) << step << " about " << axis;
    }
  }
}

TEST_F(SceneChannels, WhatIsNoPoseAndNoCameraHasNoFrame) {
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  write_pose(nan, 0, 0);
  EXPECT_TRUE(message("/14/2/pose/transforms").is_null());
  EXPECT_TRUE(message("/14/2/pose/scene")["entities"].empty());
  write_pose(0, 0, nan);
  EXPECT_TRUE(message("/14/2/pose/transforms").is_null());
  for (const std::initializer_list<float> rotation : {std::initializer_list<float>{},
                                                      {1, 0, 0},
                                                      {1, 0, 0, 0, 1, 0, 0, 0, -1},
                                                      {0, 0, 0, 0, 0, 0, 0, 0, 0},
                                                      {nan, 0, 0, 0, 1, 0, 0, 0, 1}}) {
    write_matrix(rotation, 600);
    EXPECT_TRUE(message("/14/2/camera_top_matrix/transforms").is_null());
  }
  for (const float focal : {0.F, -5.F, nan}) {
    write_matrix(kAhead, focal);
    EXPECT_TRUE(message("/14/2/camera_top_matrix/calibration").is_null());
  }
}

TEST_F(SceneChannels, TheFieldIsThatOfTheRulesUntilASimulationSaysAnother) {
  memory->runtime.write(foresight::RuntimeStatistics(), 7 * kSecond);
  const auto length = [&] {
    const json found = message("/field/scene");
    double most = 0;
    for (const json& entity : found["entities"])
      if (entity["id"] == "lines")
        for (const json& point : entity["lines"][0]["points"]) most = std::max(most, point["x"].get<double>());
    return 2 * most;
  };
  EXPECT_EQ(length(), 9);
  foresight::Simulation simulation;
  simulation.mutable_field()->set_length(6);
  simulation.mutable_field()->set_width(4);
  simulation.mutable_field()->set_penalty_mark(1);
  memory->simulation.write(simulation, kSecond);
  EXPECT_EQ(length(), 6);
  simulation.mutable_field()->set_length(std::numeric_limits<float>::quiet_NaN());
  memory->simulation.write(simulation, kSecond);
  EXPECT_EQ(length(), 9);
}

TEST_F(SceneChannels, BytesThatAreNoPoseAreAnError) {
  memory::RawChannel other(memory->pose.info(), clock);
  ASSERT_TRUE(other.write_bytes("\xff\xff", kSecond));
  for (const Derived& derived : scene_channels(other.info(), sources))
    EXPECT_FALSE(derived.make_convert()(*other.newest())) << derived.info.topic;
  memory::ChannelInfo foreign = memory->pose.info();
  foreign.message_encoding = "json";
  EXPECT_TRUE(scene_channels(foreign, sources).empty());
}

}  // namespace
}  // namespace robot::net
