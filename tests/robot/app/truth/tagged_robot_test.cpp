// A robot with a printed tag, from pictures in a folder to /truth/world.
#include <gtest/gtest.h>

#include <fstream>

#include "robot/app/truth/finder.h"
#include "robot/app/truth/sensor_watch.h"
#include "robot/truth/sensor/open_source.h"
#include "tests/support/camera_above.h"
#include "tests/support/eventually.h"
#include "tests/support/rendered_pictures.h"
#include "tests/support/temporary_folder.h"

namespace robot::app {
namespace {

constexpr int kTag = 3;

truth::tags::Camera small_camera() { return tests::camera_above({0, -0.8, 1.7}, {0, 0}, {480, 320}, 420); }

truth::tags::TagPlan plan_of_one() {
  truth::tags::TagPlan plan;
  plan.tags[kTag] = {.team = 5, .player = 2, .mounting = {.edge = 0.14, .height = 0.5}};
  return plan;
}

/// Writes a picture of a robot at (0.1, 0.05), and of a tag that the plan lacks, some times.
void write_pictures(const std::filesystem::path& folder, int count) {
  tests::Things things;
  things.push_back(tests::printed_tag(kTag, tests::flat_tag({0.1, 0.05, 0.5}, 0.3), 0.14));
  things.push_back(tests::printed_tag(kTag + 1, tests::flat_tag({-0.3, -0.05, 0.5}, 0.3), 0.14));
  const auto picture = tests::Renderer(small_camera()).render(things, {});
  for (int i = 0; i < count; ++i) {
    std::ofstream file(folder / ("picture_" + std::to_string(100 + i) + ".ppm"), std::ios::binary);
    file << "P6\n" << picture.intrinsics.width << " " << picture.intrinsics.height << "\n255\n";
    file.write(reinterpret_cast<const char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size()));
  }
}

PlacedSensor placed() {
  PlacedSensor sensor;
  sensor.pose.intrinsics = small_camera().projection.intrinsics;
  sensor.pose.field_from_sensor = small_camera().field_from_camera;
  return sensor;
}

TEST(TaggedRobot, IsNamedInTheTruthAndOtherTagsAreCounted) {
  const tests::TemporaryFolder folder;
  write_pictures(folder.path(), 12);
  const SessionClock clock(1'000'000'000 - monotonic_ns());  // the first picture is of 1 s after the epoch
  auto source = truth::open_source("pictures:" + folder.path().string());
  ASSERT_TRUE(source) << source.error();
  const auto calibrations = Calibrations::open({}, "spl2012");
  ASSERT_TRUE(calibrations);
  memory::MemoryObject<foresight::GroundTruth> world;
  world.announce("/truth/world", memory::Delivery::latest, clock);
  TruthWriter writer(1, clock, world);
  SensorWatch watch({.finder = tag_finder(plan_of_one(), truth::tags::BallLook{.radius = 0.0325}), .paced = true},
                    std::move(*source), clock, *calibrations, writer);
  memory::Channels channels;
  ASSERT_TRUE(watch.list(channels));
  watch.place(placed());
  ASSERT_TRUE(watch.start());
  ASSERT_TRUE(tests::eventually([&] { return world.read() && world.read()->value().robots_size() == 1; }));
  watch.stop();
  const auto newest = world.read();
  const auto& robot = newest->value().robots(0);
  EXPECT_EQ(robot.team(), 5u);
  EXPECT_EQ(robot.player(), 2u);
  EXPECT_NEAR(robot.x(), 0.1, 0.02);
  EXPECT_NEAR(robot.y(), 0.05, 0.02);
  EXPECT_TRUE(robot.has_heading());
  foresight::TruthSensor told;
  const auto report = channels.find("/truth/1/sensor")->newest();
  ASSERT_TRUE(told.ParseFromArray(report->bytes().data(), static_cast<int>(report->bytes().size())));
  EXPECT_GE(told.refused_tags().unknown(), 1u);
  EXPECT_EQ(told.refused_tags().implausible(), 0u);
  const auto color = channels.find("/truth/1/color")->newest();
  ASSERT_TRUE(color);
  EXPECT_FALSE(channels.find("/truth/1/depth")->newest()) << "an ordinary camera measures no depth";
}

}  // namespace
}  // namespace robot::app
