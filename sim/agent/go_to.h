// The skill that goes to a point of the field.
#pragma once

#include <cstdint>

#include "sim/agent/skills.h"
#include "sim/agent/target.h"
#include "sim/motion/command.h"

namespace sim::agent {

/// The thing that the robot faces at its place.
enum class Face : std::uint8_t { ball, goal };
inline constexpr const char* kFaces[] = {"ball", "goal", nullptr};  // by Face
inline constexpr Range kFaceRange{.unit = "", .least = 0, .most = 1, .names = kFaces, .alternative = true};

struct GoTo {
  float x = 0;  // [m, team_field]
  float y = 0;  // [m, team_field]
  Face face = Face::ball;
  float direction = kNotGiven;  // [rad, team_field]
  float gain = 1;

  template <class Self, class See>
  static constexpr void visit(Self& self, See&& see) {
    see("point_x", self.x, point_x("point", "[-1.5, 0.5]", false), "the place, x towards the opponents' goal");
    see("point_y", self.y, point_y("point", "[-1.5, 0.5]", false), "the place, y to the left");
    see("face", self.face, kFaceRange, "faces the ball or the opponents' goal");
    see("direction", self.direction, kDirectionRange, "faces this way instead: 0 along x, > 0 to the left");
    see("gain", self.gain, kGainRange, "share of the greatest speed");
  }
};
/// Goes to a point of the field, round other robots, and stays there. A point outside the lines is moved onto them.
motion::Command go_to(const View& view, Mind& mind, const GoTo& with);

}  // namespace sim::agent
