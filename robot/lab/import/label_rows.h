// The rows of a label file: boxes of ball and robots in the images of a fixed camera.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab::labels {

/// The images are this large [px].
inline constexpr double kWidth = 1920, kHeight = 1080;

/// A box in an image [px], x to the right and y down.
struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double middle() const { return (left + right) / 2; }
};

/// A robot in an image.
struct RobotBox {
  Box box;
  int colour = -1;  // of the jersey, GameController numbers; -1: not known
  int number = -1;  // of the jersey; -1: not known
};

/// The boxes of one image.
struct Frame {
  std::int64_t time_ms = 0;
  std::vector<Box> balls;  // at most one, unless the labels are wrong
  std::vector<RobotBox> robots;
};

/// The frames of a file, by time, and its damage.
struct Rows {
  std::vector<Frame> frames;
  std::string damage;  // one sentence, or empty
};

/// Reads the text of a file: a header, then a row for each box, "<time in ms>.jpg,label,x_min,y_min,x_max,y_max,color,number";
/// label 0 is a robot, 1 the ball. Rows of one image need not be neighbours. A wrong row is the damage; everything before
/// it is kept. Returns an Error if the header is another one, and for more than 1,000,000 rows.
Result<Rows> read_rows(std::string_view text);

/// Returns true if the text begins with the header of a label file.
bool is_label_file(std::string_view text);

}  // namespace robot::lab::labels
