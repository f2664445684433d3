#include "sim/field/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using sim::Vec2;
using sim::field::Field;
using sim::field::Marks;
using Kind = Marks::Kind;

/// The fields of 2012 (without penalty areas) and 2025.
const Field kFields[] = {
    {6, 4, 0.71f, 0.05f, 0.6f, 0.6f, 2.2f, 0, 0, 1.3f, 1.4f, 0.4f, 0.05f},
    {9, 6, 0.7f, 0.05f, 0.75f, 0.6f, 2.2f, 1.65f, 4, 1.3f, 1.6f, 0.5f, 0.05f},
};

struct Mark {
  Kind kind;
  Vec2 position;
};

std::vector<Mark> marks_in(const Field& field) {
  const Marks marks = sim::field::marks_of(field);
  std::vector<Mark> list;
  for (int i = 0; i < marks.count; ++i) list.push_back({marks.kind[i], marks.position(i)});
  return list;
}

int count(const std::vector<Mark>& marks, Kind kind) {
  return static_cast<int>(
      std::count_if(marks.begin(), marks.end(), [=](const Mark& mark) { return mark.kind == kind; }));
}

bool contains(const std::vector<Mark>& marks, Kind kind, Vec2 position) {
  return std::any_of(marks.begin(), marks.end(),
                     [=](const Mark& mark) { return mark.kind == kind && mark.position == position; });
}

TEST(Field, HasAllItsMarks) {
  const auto old = marks_in(kFields[0]), present = marks_in(kFields[1]);
  for (const auto& marks : {old, present}) {
    EXPECT_EQ(count(marks, Kind::post), 4);
    EXPECT_EQ(count(marks, Kind::circle), 1);
    EXPECT_EQ(count(marks, Kind::penalty_mark), 2);
  }
  EXPECT_EQ(count(old, Kind::corner), 4 + 2 + 8);
  EXPECT_EQ(count(present, Kind::corner), 4 + 2 + 8 + 8);

  EXPECT_TRUE(contains(present, Kind::corner, {4.5f, 3}));
  EXPECT_TRUE(contains(present, Kind::corner, {0, -3}));
  EXPECT_TRUE(contains(present, Kind::corner, {4.5f - 1.65f, 2}));
  EXPECT_TRUE(contains(present, Kind::corner, {-4.5f, -1.1f}));
  EXPECT_TRUE(contains(present, Kind::penalty_mark, {-3.2f, 0}));
}

TEST(Field, MarksAreSymmetricAboutBothAxesToTheBit) {
  for (const Field& field : kFields) {
    const auto marks = marks_in(field);
    for (const Mark& mark : marks) {
      EXPECT_TRUE(contains(marks, mark.kind, {mark.position.x, -mark.position.y}));
      EXPECT_TRUE(contains(marks, mark.kind, {-mark.position.x, mark.position.y}));
      EXPECT_EQ(
          std::count_if(marks.begin(), marks.end(), [&](const Mark& other) { return other.position == mark.position; }),
          1);
    }
  }
}

TEST(Field, PostsAreMarksAndStandByTheGoal) {
  for (const Field& field : kFields)
    for (int post = 0; post < sim::field::kPosts; ++post) {
      const Vec2 position = sim::field::post_of(field, post);
      EXPECT_TRUE(contains(marks_in(field), Kind::post, position));
      EXPECT_EQ(position.x > 0, post < 2);
    }
}

TEST(Field, LinesBelongToTheField) {
  const Field& field = kFields[1];
  EXPECT_TRUE(sim::field::inside_field(field, {4.5f, 3}));
  EXPECT_TRUE(sim::field::inside_field(field, {-4.52f, -3.02f}));
  EXPECT_FALSE(sim::field::inside_field(field, {4.53f, 0}));
  EXPECT_FALSE(sim::field::inside_field(field, {0, -3.03f}));
  EXPECT_TRUE(sim::field::inside_field(field, {4.57f, 0}, 0.05f));
}

TEST(Field, AGoalIsAGoalOnlyWhenTheWholeBallIsBehindTheLine) {
  const Field& field = kFields[1];
  EXPECT_EQ(sim::field::goal_entered(field, {4.4f, 0}, {4.57f, 0}, 0.05f), 0);
  EXPECT_EQ(sim::field::goal_entered(field, {4.4f, 0}, {4.58f, 0}, 0.05f), 1);
  EXPECT_EQ(sim::field::goal_entered(field, {-4.57f, 0.3f}, {-4.6f, 0.3f}, 0.05f), -1);
  EXPECT_EQ(sim::field::goal_entered(field, {4.58f, 0}, {4.6f, 0}, 0.05f), 0) << "the ball was behind the line before";
  EXPECT_EQ(sim::field::goal_entered(field, {4.6f, 0}, {4.5f, 0}, 0.05f), 0) << "the ball comes out";
  EXPECT_EQ(sim::field::goal_entered(field, {4.5f, 0.9f}, {4.6f, 0.9f}, 0.05f), 0) << "beside the post";
}

TEST(Field, AGoalIsDecidedWhereTheBallCrossedTheLine) {
  const Field& field = kFields[1];
  // the line is at 4.575: the first ball crosses it between the posts and ends beside them, the second does the opposite
  EXPECT_EQ(sim::field::goal_entered(field, {4.5f, 0.7f}, {4.65f, 0.86f}, 0.05f), 1);
  EXPECT_EQ(sim::field::goal_entered(field, {4.5f, 0.9f}, {4.65f, 0.74f}, 0.05f), 0);
}

TEST(Field, GoalsAreTheSameAtBothEndsAndInTheMirror) {
  const Field& field = kFields[1];
  int goals = 0;
  for (int i = 0; i < 4000; ++i) {
    const float step = static_cast<float>(i);
    const Vec2 from{4.4f + 0.00005f * step, -1 + 0.0005f * step}, to{from.x + 0.1f, from.y + 0.0000333f * step};
    const float entered = sim::field::goal_entered(field, from, to, 0.05f);
    goals += entered != 0;
    EXPECT_EQ(sim::field::goal_entered(field, {from.x, -from.y}, {to.x, -to.y}, 0.05f), entered);
    EXPECT_EQ(sim::field::goal_entered(field, -from, -to, 0.05f), -entered);
  }
  EXPECT_GT(goals, 500);
  EXPECT_LT(goals, 3500);
}

}  // namespace
