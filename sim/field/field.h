// The field: lines, goals and areas, as data.
#pragma once

#include "sim/math/vec2.h"

namespace sim::field {

/// The sizes of a field [m], measured between the middles of lines as in the rule book.
/// Frame `field`: origin at the centre, +x towards the goal that the home team attacks in the
/// first half, +y to the left of that.
struct Field {
  float length;  // between the goal lines
  float width;   // between the touch lines
  float border;  // carpet beyond the lines
  float line_width;
  float centre_circle_radius;
  float goal_area_length;  // from the goal line into the field
  float goal_area_width;
  float penalty_area_length;  // 0: the field has none
  float penalty_area_width;
  float penalty_mark;  // distance from the goal line
  float goal_width;    // between the middles of the posts
  float goal_depth;
  float post_radius;

  /// Calls see(name, value, unit, least, most) for each value.
  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("length", self.length, "m", 2.f, 30.f);
    see("width", self.width, "m", 2.f, 20.f);
    see("border", self.border, "m", 0.f, 3.f);
    see("line_width", self.line_width, "m", 0.01f, 0.2f);
    see("centre_circle_radius", self.centre_circle_radius, "m", 0.1f, 3.f);
    see("goal_area_length", self.goal_area_length, "m", 0.f, 5.f);
    see("goal_area_width", self.goal_area_width, "m", 0.f, 10.f);
    see("penalty_area_length", self.penalty_area_length, "m", 0.f, 8.f);
    see("penalty_area_width", self.penalty_area_width, "m", 0.f, 16.f);
    see("penalty_mark", self.penalty_mark, "m", 0.3f, 6.f);
    see("goal_width", self.goal_width, "m", 0.5f, 4.f);
    see("goal_depth", self.goal_depth, "m", 0.1f, 2.f);
    see("post_radius", self.post_radius, "m", 0.01f, 0.2f);
  }
};

/// The marks by which a robot can localise itself: 4 posts, L and T corners of lines, the centre circle, the penalty
/// marks. They are symmetric about both axes. The arrays are packed because each look tests all marks.
struct Marks {
  enum class Kind : unsigned char { post, corner, circle, penalty_mark };
  static constexpr int kBlock = 4;  // marks tested together, in vector registers
  static constexpr int kMost = 40;

  int count = 0;
  float x[kMost];  // [m, field]; the last block is filled up with places far from everything
  float y[kMost];
  Kind kind[kMost];

  Vec2 position(int i) const { return {x[i], y[i]}; }
};
Marks marks_of(const Field& field);

inline constexpr int kPosts = 4;
/// Returns the middle of post 0..3 [m, field]: the goal at +x comes first, and of each goal the post at +y.
constexpr Vec2 post_of(const Field& field, int post) {
  return {(post < 2 ? 0.5f : -0.5f) * field.length, (post % 2 == 0 ? 0.5f : -0.5f) * field.goal_width};
}

/// Reports whether the point is on the field, lines included, or at most `margin` [m] outside.
constexpr bool inside_field(const Field& field, Vec2 point, float margin = 0) {
  const float x = 0.5f * (field.length + field.line_width) + margin;
  const float y = 0.5f * (field.width + field.line_width) + margin;
  return -x <= point.x && point.x <= x && -y <= point.y && point.y <= y;
}

/// Return the place of the ball at a set play [m, field]. `end` +1 or -1 is the sign of x of the goal line with that
/// corner or goal area. `line` is the sign of y of the side where the ball went out; `x` is where it crossed the line.
constexpr Vec2 corner_kick_place(const Field& field, float end, float line) {
  return {end * (field.length / 2), line * (field.width / 2)};
}
constexpr Vec2 goal_kick_place(const Field& field, float end, float line) {
  return {end * (field.length / 2 - field.goal_area_length), line * (field.goal_area_width / 2)};
}
constexpr Vec2 kick_in_place(const Field& field, float x, float line) {
  const float end = field.length / 2;
  return {x < -end ? -end : x > end ? end : x, line * (field.width / 2)};
}

/// Returns the goal that a ball enters on the straight way from `from` to `to` [m, field]: +1 or -1 is the sign of the
/// goal's x, 0 is none. The ball is in as soon as the whole of it is behind the line, between the posts.
float goal_entered(const Field& field, Vec2 from, Vec2 to, float ball_radius);

}  // namespace sim::field
