// The plan of the printed tags: the robot that carries each, and the place where it is fixed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "robot/core/result.h"

namespace robot::truth::tags {

/// The place of a tag on a standing robot. The tag lies flat and looks up. Frame `robot`: origin between the feet,
/// +x forward, +y left.
struct Mounting {
  double edge = 0;     // [m] of the black square
  double height = 0;   // [m] above the carpet
  double forward = 0;  // [m] of the tag's centre
  double left = 0;     // [m] likewise
  double turn = 0;     // [rad] from the robot's forward direction to the upper edge of the print, counter-clockwise
};

struct TaggedRobot {
  std::uint32_t team = 0, player = 0;
  Mounting mounting;
};

/// A robot may carry several tags.
struct TagPlan {
  std::string family = "tag36h11";
  std::map<int, TaggedRobot> tags;  // by id
};

/// Reads a plan that a person wrote:
///
///   {"family": "tag36h11", "teams": [5, 18],
///    "tags": [{"id": 0, "team": 5, "player": 1, "edge": 0.14, "height": 0.56,
///              "forward": 0, "left": 0, "turn_deg": 90}]}
///
/// "family", "forward", "left" and "turn_deg" may be absent. Returns an Error that names the first fault and its place.
/// Faults are an unknown key, an id that is used twice or that the family lacks, a team not among the teams, a wrong size.
Result<TagPlan> parse_tag_plan(std::string_view text);

/// Reads the plan from a file of at most 1 MB.
Result<TagPlan> read_tag_plan(const std::filesystem::path& file);

}  // namespace robot::truth::tags
