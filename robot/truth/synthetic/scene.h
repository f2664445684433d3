// The things that move in the picture of a synthetic sensor.
#pragma once

#include <optional>
#include <vector>

namespace robot::truth {

/// A robot like a Nao, 0.58 m high when it stands. Frame `field`.
struct SceneRobot {
  double x = 0, y = 0;  // [m] the middle between the feet; of a lying robot, the middle of its body
  double heading = 0;   // [rad] of a lying robot: from its feet to its head
  bool fallen = false;  // it lies on its back or its belly
  double stride = 0;    // [m] the left foot is this far ahead of the right one
  double arms = 0.5;    // [rad] of both upper arms, from hanging to stretched forward
};

enum class BallColour { orange, black_and_white };

/// A ball. Frame `field`.
struct SceneBall {
  double x = 0, y = 0, z = 0.05;  // [m] its centre
  double radius = 0.05;           // [m]
  BallColour colour = BallColour::orange;
};

/// A standing or walking person, 1.75 m high, such as a referee. Frame `field`.
struct ScenePerson {
  double x = 0, y = 0;  // [m] the middle between the feet
  double heading = 0;   // [rad]
  double stride = 0;    // [m] the left foot is this far ahead of the right one
};

struct Scene {
  std::vector<SceneRobot> robots;
  std::optional<SceneBall> ball;
  std::vector<ScenePerson> people;
};

}  // namespace robot::truth
