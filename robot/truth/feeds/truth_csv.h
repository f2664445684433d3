// A CSV file of positions as ground truth: of a motion capture system, a tracker, a simulator.
//
// The first line names the columns; blanks, quotes and a '#' before the first name are allowed. Columns are separated by
// commas, semicolons or tabs. They come in any order, and other columns are ignored.
//
//   wide form, one line for each moment:     t,ball_x,ball_y,x_14_2,y_14_2,heading_14_2
//   long form, one line for each thing:      t,team,player,x,y,heading
//
//   t, time               time in seconds; t_ms, t_us and t_ns in other units. A cell may be an ISO 8601 text instead.
//                         Times never decrease. From 10^9 s (the year 2001) on they count from the epoch.
//   ball_x, ball_y        the ball [m]
//   x_14_2, y_14_2        robot 2 of team 14 [m]; heading_14_2 [rad], counter-clockwise from +x, may be absent
//   team, player, x, y, heading   long form. Team "ball" is the ball. Without team or player the robot is not identified.
//                         Lines with the same time are one moment.
//
// A name may end with its unit: ball_x_mm, x_14_2_cm, heading_deg. Frame: field, as in proto/foresight/truth.proto.
// An empty cell or nan is a thing that was not seen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/feeds/timed_truth.h"

namespace robot::truth {

/// The moments of a file.
struct TruthCsv {
  std::vector<TimedTruth> moments;   // their times never decrease
  bool dated = false;                // false: the times count from some start, not from the epoch
  std::vector<std::string> ignored;  // names of columns of other data
  std::string damage;                // a sentence about the first wrong line, with line and column; or empty
};

/// Reads the text of a file. A wrong line is the damage; every line before it is kept. Returns an Error if the header is
/// wrong.
Result<TruthCsv> read_truth_csv(std::string_view text);

/// Reports whether the first line of `text` is a header that read_truth_csv() can read.
bool is_truth_csv(std::string_view text);

}  // namespace robot::truth
