#include "robot/truth/detection/surface_to_centre.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/detection/watched.h"

namespace robot::truth {
namespace {

TEST(SurfaceToCentre, FiveMarksGiveTheDefaultForRobotsLikeANao) {
  const SensorPose pose = mast(kField2012, -1, 0, kHalf);
  Renderer renderer(pose, kHall, {.colour = false});
  std::vector<MarkedFrame> frames;
  for (const auto& [x, y] : {std::pair{0., 0.}, {-1., -0.5}, {1., -0.5}, {-1., 1.}, {1., 1.}})
    for (const double heading : {0., 3.1})
      frames.push_back(
          {renderer.render(Scene{.robots = {{.x = x, .y = y, .heading = heading + x}}}, frames.size()), {x, y}});
  const Result<double> fitted = fit_surface_to_centre(pose, kField2012, {}, frames);
  ASSERT_TRUE(fitted) << fitted.error();
  EXPECT_NEAR(*fitted, DetectorOptions{}.surface_to_centre, 0.005);
}

TEST(SurfaceToCentre, OfImagesWithoutARobotIsOneSentence) {
  const SensorPose pose = mast(kField2012, -1, 0, kHalf);
  Renderer renderer(pose, kHall);
  const std::vector<MarkedFrame> frames{{renderer.render(Scene{.robots = {{.x = 1}}}, 0), {0, 0}}};
  const Result<double> fitted = fit_surface_to_centre(pose, kField2012, {}, frames);
  ASSERT_FALSE(fitted);
  EXPECT_EQ(fitted.error(),
            "distance from surface to centre: expected images of a robot within 0.5 m of its mark, got 1 without one");
}

}  // namespace
}  // namespace robot::truth
