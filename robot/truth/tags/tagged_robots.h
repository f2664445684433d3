// Robots by their printed tags.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/truth/frame/detections.h"
#include "robot/truth/tags/camera.h"
#include "robot/truth/tags/seen_tag.h"
#include "robot/truth/tags/tag_plan.h"

namespace robot::truth::tags {

/// Counts of tags that gave no robot.
struct RefusedTags {
  std::uint64_t unknown = 0;        // the plan lacks the id
  std::uint64_t repeated = 0;       // the same id twice in one picture: nobody knows the real one
  std::uint64_t implausible = 0;    // on no standing or lying robot: carried, partly hidden, a wrong size in the plan
  std::uint64_t contradictory = 0;  // two tags of one robot at different places
};

/// Returns the robots that carry the tags. Several tags of a robot give one robot.
///
/// A standing robot has the height of its tag and a heading. A lying robot has a height below half of the mounting height,
/// the place of its tag, and no heading. A tag that gives no robot is counted in `refused`.
std::vector<SeenRobot> tagged_robots(const Camera& camera, const TagPlan& plan, const std::vector<SeenTag>& tags,
                                     RefusedTags& refused);

}  // namespace robot::truth::tags
