#include "robot/net/scene/field_scene.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace robot::net {
namespace {

constexpr std::uint32_t kCarpet = 0x23523a, kLine = 0xe8efe9, kPost = 0xf5f7f5;  // as in our own viewer
constexpr double kGoalHeight = 0.8;                                              // [m] to the crossbar, rules of 2025
constexpr double kPostDiameter = 0.1;                                            // [m] rules of 2025

/// The lines of a scene, two points for each.
class Lines {
 public:
  void line(Point3 from, Point3 to) {
    points_.push_back(from);
    points_.push_back(to);
  }
  void box(double left, double bottom, double right, double top) {
    line({left, bottom}, {right, bottom});
    line({right, bottom}, {right, top});
    line({right, top}, {left, top});
    line({left, top}, {left, bottom});
  }
  void circle(double radius) {
    constexpr int kParts = 48;
    const auto at = [&](int part) {
      const double angle = 2 * std::numbers::pi * part / kParts;
      return Point3{radius * std::cos(angle), radius * std::sin(angle)};
    };
    for (int i = 0; i < kParts; ++i) line(at(i), at(i + 1));
  }
  std::vector<Point3> take() { return std::move(points_); }

 private:
  std::vector<Point3> points_;
};

/// Adds what lies at the goal line with the sign `end` of x.
void add_end(Lines& lines, const foresight::Field& field, double end) {
  const double goal_line = end * field.length() / 2;
  const auto area = [&](double length, double width) {
    if (length > 0) lines.box(goal_line, -width / 2, goal_line - end * length, width / 2);
  };
  area(field.goal_area_length(), field.goal_area_width());
  area(field.penalty_area_length(), field.penalty_area_width());
  constexpr double kArm = 0.05;  // [m] of the cross
  const double mark = goal_line - end * field.penalty_mark();
  lines.line({mark - kArm, 0}, {mark + kArm, 0});
  lines.line({mark, -kArm}, {mark, kArm});
}

void add_goal(std::vector<Shape>& shapes, const foresight::Field& field, double end) {
  const Colour colour = colour_of(kPost);
  const double x = end * field.length() / 2, half = field.goal_width() / 2.0;
  for (const double y : {-half, half})
    shapes.push_back({.kind = Shape::Kind::cylinder,
                      .place = {x, y, kGoalHeight / 2},
                      .size = {kPostDiameter, kPostDiameter, kGoalHeight},
                      .colour = colour});
  shapes.push_back({.kind = Shape::Kind::box,
                    .place = {x, 0, kGoalHeight},
                    .size = {kPostDiameter, 2 * half, kPostDiameter},
                    .colour = colour});
  // the frame of the net on the ground
  const double depth = end * field.goal_depth();
  shapes.push_back({.kind = Shape::Kind::lines,
                    .place = {x, 0},
                    .size = {0, 0, 0.03},
                    .colour = colour,
                    .points = {{0, -half}, {depth, -half}, {depth, -half}, {depth, half}, {depth, half}, {0, half}}});
}

}  // namespace

Scene field_scene(const foresight::Field& field) {
  const double length = field.length(), width = field.width(), border = 2 * field.border();
  constexpr double kThick = 0.02, kBelow = 0.003;  // [m] the carpet ends below the lines, so that both do not flicker
  Entity carpet{"carpet", {}};
  carpet.shapes.push_back({.kind = Shape::Kind::box,
                           .place = {0, 0, -kBelow - kThick / 2},
                           .size = {length + border, width + border, kThick},
                           .colour = colour_of(kCarpet)});

  Lines lines;
  lines.box(-length / 2, -width / 2, length / 2, width / 2);
  lines.line({0, -width / 2}, {0, width / 2});
  lines.circle(field.centre_circle_radius());
  for (const double end : {-1.0, 1.0}) add_end(lines, field, end);
  Entity marks{"lines", {}};
  marks.shapes.push_back({.kind = Shape::Kind::lines,
                          .size = {0, 0, field.line_width()},
                          .colour = colour_of(kLine),
                          .points = lines.take()});

  Entity goals{"goals", {}};
  for (const double end : {-1.0, 1.0}) add_goal(goals.shapes, field, end);
  return {std::move(carpet), std::move(marks), std::move(goals)};
}

}  // namespace robot::net
