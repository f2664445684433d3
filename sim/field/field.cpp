#include "sim/field/field.h"

namespace sim::field {

namespace {

using Kind = Marks::Kind;

void add(Marks& marks, Kind kind, float x, float y) {
  marks.kind[marks.count] = kind;
  marks.x[marks.count] = x;
  marks.y[marks.count] = y;
  ++marks.count;
}

/// Adds one mark in each half, on the long axis.
void add_two(Marks& marks, Kind kind, float x) {
  add(marks, kind, x, 0);
  add(marks, kind, -x, 0);
}

/// Adds one mark in each quarter of the field.
void add_four(Marks& marks, Kind kind, float x, float y) {
  add(marks, kind, x, y);
  add(marks, kind, x, -y);
  add(marks, kind, -x, y);
  add(marks, kind, -x, -y);
}

/// Adds the corners of a rectangle in front of each goal: two in the field and two on the goal line.
void add_area(Marks& marks, const Field& field, float length, float width) {
  if (length <= 0) return;
  add_four(marks, Kind::corner, 0.5f * field.length, 0.5f * width);
  add_four(marks, Kind::corner, 0.5f * field.length - length, 0.5f * width);
}

}  // namespace

Marks marks_of(const Field& field) {
  Marks marks;
  add_four(marks, Kind::post, 0.5f * field.length, 0.5f * field.goal_width);
  add_four(marks, Kind::corner, 0.5f * field.length, 0.5f * field.width);

  // the T corners where the halfway line meets the touch lines
  add(marks, Kind::corner, 0, 0.5f * field.width);
  add(marks, Kind::corner, 0, -0.5f * field.width);

  add_area(marks, field, field.goal_area_length, field.goal_area_width);
  add_area(marks, field, field.penalty_area_length, field.penalty_area_width);
  add(marks, Kind::circle, 0, 0);
  add_two(marks, Kind::penalty_mark, 0.5f * field.length - field.penalty_mark);

  // fill the last block with places far from everything
  for (int i = marks.count; i % Marks::kBlock != 0; ++i) marks.x[i] = marks.y[i] = 1e6f;
  return marks;
}

float goal_entered(const Field& field, Vec2 from, Vec2 to, float ball_radius) {
  const float side = to.x < 0 ? -1.f : 1.f;
  const float line = 0.5f * (field.length + field.line_width) + ball_radius;
  const float before = side * from.x, after = side * to.x;
  if (!(before <= line && line < after)) return 0;

  // where the ball was when it had just passed the line
  const float share = (line - before) / (after - before);
  const float y = from.y + share * (to.y - from.y);
  return std::fabs(y) < 0.5f * field.goal_width ? side : 0.f;
}

}  // namespace sim::field
