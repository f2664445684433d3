#include "robot/truth/calibration/landmarks.h"

#include <algorithm>

namespace robot::truth {
namespace {

constexpr const char* kSides[] = {"+", "-"};

double sign_of(std::string_view side) { return side == "+" ? 1 : -1; }

/// A list that grows by symmetric landmarks.
struct LandmarkList {
  std::vector<Landmark> landmarks;

  void add(std::string name, double x, double y, double deviation = 0) {
    landmarks.push_back({std::move(name), {x, y, 0}, deviation});
  }
  void add_two_along_x(const std::string& name, double x) {
    for (const char* side : kSides) add(name + " " + side + "x", sign_of(side) * x, 0);
  }
  void add_two_along_y(const std::string& name, double y) {
    for (const char* side : kSides) add(name + " " + side + "y", 0, sign_of(side) * y);
  }
  void add_four(const std::string& name, double x, double y, const std::string& part = "", double deviation = 0) {
    for (const char* end : kSides)
      for (const char* side : kSides) {
        std::string whole = name;
        whole.append(" ").append(end).append("x ").append(side).append("y").append(part);
        add(std::move(whole), sign_of(end) * x, sign_of(side) * y, deviation);
      }
  }
  /// Adds the corners of a rectangle in front of each goal: those in the field and those on the goal line.
  void add_area(const std::string& name, double goal_line, double length, double width) {
    if (length <= 0 || width <= 0) return;
    add_four(name, goal_line - length, width / 2);
    add_four(name, goal_line, width / 2, ", goal line");
  }
};

}  // namespace

std::vector<Landmark> landmarks_of(const sim::field::Field& field) {
  const double goal_line = static_cast<double>(field.length) / 2, touch_line = static_cast<double>(field.width) / 2;
  LandmarkList list;
  list.add_four("corner", goal_line, touch_line);
  list.add_two_along_y("halfway line, touch line", touch_line);
  list.add_area("goal area", goal_line, static_cast<double>(field.goal_area_length),
                static_cast<double>(field.goal_area_width));
  list.add_area("penalty area", goal_line, static_cast<double>(field.penalty_area_length),
                static_cast<double>(field.penalty_area_width));
  list.add_two_along_y("centre circle, halfway line", static_cast<double>(field.centre_circle_radius));
  list.add_two_along_x("penalty mark", goal_line - static_cast<double>(field.penalty_mark));
  list.add("centre mark", 0, 0);
  list.add_four("post", goal_line, static_cast<double>(field.goal_width) / 2, ", foot",
                static_cast<double>(field.post_radius) / 2);
  return std::move(list.landmarks);
}

const Landmark* find_landmark(const std::vector<Landmark>& landmarks, std::string_view name) {
  const auto found = std::find_if(landmarks.begin(), landmarks.end(), [&](const auto& it) { return it.name == name; });
  return found == landmarks.end() ? nullptr : &*found;
}

}  // namespace robot::truth
