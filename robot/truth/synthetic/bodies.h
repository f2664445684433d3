// The bodies of a scene as capsules, in the frame `field`.
#pragma once

#include <vector>

#include "robot/truth/synthetic/cast.h"
#include "robot/truth/synthetic/scene.h"

namespace robot::truth {

/// The height of a standing robot [m].
inline constexpr double kRobotHeight = 0.58;

/// Adds the capsules of one thing to `bodies`.
void add(const SceneRobot& robot, std::vector<Capsule>& bodies);
void add(const SceneBall& ball, std::vector<Capsule>& bodies);
void add(const ScenePerson& person, std::vector<Capsule>& bodies);

}  // namespace robot::truth
