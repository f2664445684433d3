// Recorded beliefs through another tree: what would it have decided, and where does it differ from what was decided?
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proto/foresight/agent.pb.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

struct RedecideOptions {
  std::string robot;     // "14/2"; empty: the robot that recorded the session
  std::string strategy;  // name or file of a tree
  std::string rules;     // empty: those of the recorded simulation, else spl2025
  std::string models = "match";
};

/// One recorded decision and the new one from the same beliefs.
struct Redecision {
  std::uint64_t at_ns = 0;  // [ns since the epoch] capture time of the recorded one
  double seconds = 0;       // [s] since the session's first message
  foresight::DecisionTrace recorded, now;
  std::string problem;  // why the new tree could not decide; otherwise empty

  /// Reports whether the robot would do something else: another skill, or the same with other arguments.
  bool differs() const;
};

/// The decisions of one robot.
struct Redecisions {
  std::string robot, strategy, recorded_strategy;
  std::vector<Redecision> all;  // in the order of time

  std::int64_t different() const;
};

/// Decides anew at each recorded decision in which the recorded tree was asked, from the newest recorded beliefs of that
/// moment. The memory of the behaviour is that of its own decisions, so a role or a search may differ for a while.
/// Returns an Error for a session without decisions or beliefs of the robot, and for an unknown strategy.
Result<Redecisions> redecide(const logging::Session& session, const RedecideOptions& options);

/// Returns where two decisions part: "ball_distance < 0.5 (0.43): recorded no, now yes".
std::string parting(const Redecision& decision);

/// Returns the moments at which they differ, a line for each stretch of equal skills, and the share of equal decisions.
std::string to_text(const Redecisions& decisions);
/// Returns all decisions as CSV: time, recorded skill and leaf, new skill and leaf, where they part.
std::string to_csv(const Redecisions& decisions);

/// A decision that a team expects.
struct Expectation {
  // [s] since the session's first message, give or take half a frame; equal: the newest decision at that time
  double from = 0, to = 0;
  bool negated = false;
  std::vector<std::string> skills;
  std::string text;  // as it was written
  int line = 0;
};

/// Parses a file of expectations, one a line:
///
///   at 12.5 s: kick or dribble
///   12 .. 14 s: not search_ball          in no decision of these seconds
///   # a comment
///
/// Returns an Error that names the line.
Result<std::vector<Expectation>> parse_expectations(std::string_view text);

/// Returns a sentence for each expectation that the new decisions break, and for each that holds no decision.
std::vector<std::string> broken(const std::vector<Expectation>& expectations, const Redecisions& decisions);

}  // namespace robot::app
