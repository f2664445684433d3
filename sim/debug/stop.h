// Conditions at which the debugger stops, about truth, events, beliefs and decisions:
//
//   stop := term { ("and" | "or") term }                      "and" binds closer
//   term := ["not"] [ROBOT] fact                              ROBOT: "14/3" or "home/3"
//
// A fact about the game is one of sim/check/condition.h: "our goal", "ball_x > 1 m". A fact about a robot is
//
//   a comparison of a feature       "14/3 ball_distance < 0.5 m"   as in a tree, with its beliefs in its newest decision
//   ball_error, pose_error          "14/3 ball_error > 0.5 m"      distance of the belief from the truth
//   skill, leaf, role and changes   "skill changes"                from one tick to the next
//   skill is NAME                   "skill is pass"
//   decides, falls                  in this tick
//
// Without ROBOT a word that is both means the game. Facts about a robot are then about the robot in focus.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/check/condition.h"
#include "sim/debug/timeline.h"
#include "sim/io/condition.h"
#include "sim/io/situation.h"

namespace sim::debug {

/// A fact about one robot in one tick.
struct RobotFact {
  enum class Kind {
    feature,
    ball_error,
    pose_error,
    skill_is,
    skill_changes,
    leaf_changes,
    role_changes,
    decides,
    falls
  };
  Kind kind = Kind::decides;
  int robot = 0;
  io::Term term{};  // of a feature; of the errors: comparison and threshold
  agent::Skill skill{};
};

struct Term {
  bool negated = false;
  std::optional<check::Fact> game;  // otherwise `robot`
  RobotFact robot;
  std::string text;  // as it was typed, with the name of its robot
};

/// A condition: all terms of one alternative hold.
struct Stop {
  std::vector<std::vector<Term>> alternatives;
};

/// Parses a condition of at most io::kMaxConditionBytes. `focus` is the robot of facts without one.
robot::Result<Stop> parse_stop(std::string_view text, int players, const io::SituationTeams& teams, int focus);

/// Returns a text that parses to the same condition, whichever robot is in focus.
std::string text_of(const Stop& stop);

/// Returns the robot of a fact that only a decision tree has, and that plays none; or nothing.
std::optional<int> robot_without_tree(const Stop& stop, const Params& params);

/// Finds the first tick behind `now` at which the condition has become true, up to the end of the game. The tick is the
/// one of the state after it.
std::optional<Tick> next_stop(Timeline& timeline, const Stop& stop, Tick now);
/// Finds the last tick before `now` at which it has become true.
std::optional<Tick> previous_stop(Timeline& timeline, const Stop& stop, Tick now);

}  // namespace sim::debug
