#include "robot/truth/calibration/landmarks.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/ground_picture.h"

namespace robot::truth {
namespace {

sim::field::Field field_with_penalty_areas() {
  sim::field::Field field = tests::mast_scene().field;
  field.penalty_area_length = 1.65f;
  field.penalty_area_width = 3.2f;
  return field;
}

TEST(Landmarks, AreCrossingsMarksAndFeetOfPosts) {
  const auto landmarks = landmarks_of(field_with_penalty_areas());
  EXPECT_EQ(landmarks.size(), 31u);
  const auto place = [&](const char* name) {
    const Landmark* landmark = find_landmark(landmarks, name);
    return landmark ? landmark->position : Eigen::Vector3d(99, 99, 99);
  };
  EXPECT_TRUE(place("corner +x +y").isApprox(Eigen::Vector3d(3, 2, 0), 1e-6));
  EXPECT_TRUE(place("halfway line, touch line -y").isApprox(Eigen::Vector3d(0, -2, 0), 1e-6));
  EXPECT_TRUE(place("goal area -x +y").isApprox(Eigen::Vector3d(-2.4, 1.1, 0), 1e-6));
  EXPECT_TRUE(place("goal area -x +y, goal line").isApprox(Eigen::Vector3d(-3, 1.1, 0), 1e-6));
  EXPECT_TRUE(place("penalty area +x -y").isApprox(Eigen::Vector3d(1.35, -1.6, 0), 1e-6));
  EXPECT_TRUE(place("penalty area +x -y, goal line").isApprox(Eigen::Vector3d(3, -1.6, 0), 1e-6));
  EXPECT_TRUE(place("centre circle, halfway line +y").isApprox(Eigen::Vector3d(0, 0.6, 0), 1e-6));
  EXPECT_TRUE(place("penalty mark -x").isApprox(Eigen::Vector3d(-1.7, 0, 0), 1e-6));
  EXPECT_TRUE(place("centre mark").isApprox(Eigen::Vector3d(0, 0, 0), 1e-6));
  EXPECT_TRUE(place("post +x -y, foot").isApprox(Eigen::Vector3d(3, -0.7, 0), 1e-6));
}

TEST(Landmarks, HaveNoAreaThatTheFieldLacks) { EXPECT_EQ(landmarks_of(tests::mast_scene().field).size(), 23u); }

TEST(Landmarks, HaveNamesThatDifferAndPlacesThatTheSignsMirror) {
  const auto landmarks = landmarks_of(field_with_penalty_areas());
  std::set<std::string> names;
  for (const Landmark& landmark : landmarks) {
    EXPECT_TRUE(names.insert(landmark.name).second) << landmark.name;
    std::string mirrored = landmark.name;
    const auto sign = mirrored.find("+y");
    if (sign == std::string::npos) continue;
    mirrored[sign] = '-';
    const Landmark* twin = find_landmark(landmarks, mirrored);
    ASSERT_TRUE(twin) << mirrored;
    EXPECT_EQ(twin->position, landmark.position.cwiseProduct(Eigen::Vector3d(1, -1, 1)));
  }
}

TEST(Landmarks, AreHiddenOnlyByPosts) {
  for (const Landmark& landmark : landmarks_of(field_with_penalty_areas()))
    EXPECT_EQ(landmark.deviation > 0, landmark.name.starts_with("post")) << landmark.name;
}

TEST(Landmarks, WithAnUnknownNameAreNotFound) {
  EXPECT_EQ(find_landmark(landmarks_of(field_with_penalty_areas()), "corner"), nullptr);
}

}  // namespace
}  // namespace robot::truth
