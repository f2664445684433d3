#include "robot/truth/tracks/usable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/robot/truth/tracks/images.h"

namespace robot::truth {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Usable, RefusesPlacesThatAreNoneAndCountsThem) {
  std::uint64_t refused = 0;
  const SensorImage image = image_of(0, {{kNan, 0}, {0, std::numeric_limits<double>::infinity()}, {101, 0}, {1, 1}});
  const Detections result = usable(with_ball(image, {kNan, 0}).detections, refused);
  ASSERT_EQ(result.robots.size(), 1u);
  EXPECT_EQ(result.robots[0].place.position.x(), 1);
  EXPECT_FALSE(result.ball);
  EXPECT_EQ(refused, 4u);
}

TEST(Usable, RefusesCovariancesThatAreNone) {
  Eigen::Matrix2d negative, flat, skew, huge;
  negative << -1, 0, 0, 1;
  flat << 1, 1, 1, 1;
  skew << 1, 0.5, 0, 1;
  huge << 1e9, 0, 0, 1;
  const Eigen::Matrix2d zero = Eigen::Matrix2d::Zero(), none = kNan * Eigen::Matrix2d::Identity();
  for (const Eigen::Matrix2d& covariance : {negative, flat, skew, huge, zero, none}) {
    std::uint64_t refused = 0;
    SensorImage image = image_of(0, {{1, 1}});
    image.detections.robots[0].place.covariance = covariance;
    EXPECT_TRUE(usable(image.detections, refused).robots.empty()) << covariance;
    EXPECT_EQ(refused, 1u);
  }
}

TEST(Usable, ACovarianceThatIsAsymmetricByRoundingBecomesSymmetric) {
  Detections detections = image_of(0, {{1, 1}}).detections;
  detections.robots[0].place.covariance << 1e-6, 3.0000001e-7, 3e-7, 2e-6;
  std::uint64_t refused = 0;
  const Detections used = usable(detections, refused);
  ASSERT_EQ(used.robots.size(), 1u);
  EXPECT_EQ(used.robots[0].place.covariance(0, 1), used.robots[0].place.covariance(1, 0));
  EXPECT_EQ(refused, 0u);
}

TEST(Usable, LimitsTheCountOfRobots) {
  std::uint64_t refused = 0;
  const std::vector<Eigen::Vector2d> many(100, Eigen::Vector2d(1, 1));
  EXPECT_EQ(usable(image_of(0, many).detections, refused).robots.size(), kMostSeenRobots);
  EXPECT_EQ(refused, 100 - kMostSeenRobots);
}

TEST(Usable, LeavesOutAHeadingThatIsNotFinite) {
  std::uint64_t refused = 0;
  SensorImage image = image_of(0, {{1, 1}});
  image.detections.robots[0].heading = kNan;
  EXPECT_FALSE(usable(image.detections, refused).robots[0].heading);
  image.detections.robots[0].heading = 1;
  EXPECT_EQ(usable(image.detections, refused).robots[0].heading, 1);
}

TEST(Usable, OrdersRobotsByTheirPlaces) {
  std::uint64_t refused = 0;
  SensorImage image = image_of(0, {{2, 0}, {1, 3}, {1, 2}});
  const Detections one = usable(image.detections, refused);
  std::reverse(image.detections.robots.begin(), image.detections.robots.end());
  const Detections other = usable(image.detections, refused);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(one.robots[i].place.position, other.robots[i].place.position);
}

}  // namespace
}  // namespace robot::truth
