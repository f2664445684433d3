// Conditions about the course of a game: "our touch then our touch within 5 s and never their goal".
//
//   condition := clauses, joined by "and" and "or"; "and" binds closer
//   clause    := ["not"] ["eventually"] sequence | "always" fact | "never" fact
//   sequence  := fact ["within" N "s"] { "then" fact ["within" N "s"] }
//   fact      := a happening: "our touch"; or a quantity and a value: "ball_x > 1 m"
//
// A sequence holds if its facts come true in different ticks, in this order. "within" limits the time since the fact
// before, or since the start. Happenings and quantities are listed in glance.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/agent/tree.h"
#include "sim/check/glance.h"
#include "sim/check/words.h"

namespace sim::check {

/// A statement about one tick.
struct Fact {
  int happening = -1;  // its number, or -1 for a comparison
  int quantity = -1;
  agent::Comparison comparison{};
  float threshold = 0;
};

bool holds(const Fact& fact, const Glance& glance);

/// A fact, and the most ticks since the fact before.
struct Step {
  Fact fact;
  Tick within = kNever;
};

struct Clause {
  bool always = false;   // the only fact must hold in every tick; otherwise the sequence must occur
  bool negated = false;  // and the clause holds if that is not so
  std::vector<Step> steps;
};

/// Holds if all clauses of one alternative hold. No alternative is empty.
struct Condition {
  std::vector<std::vector<Clause>> alternatives;
};

inline constexpr std::size_t kMaxConditionBytes = 1000;

/// Parses a fact from the next words. The Error is a whole sentence without its place.
robot::Result<Fact> take_fact(Words& words);
/// Parses the number of a quantity from the next word.
robot::Result<int> take_quantity(Words& words);
/// Parses a condition from all remaining words.
robot::Result<Condition> take_condition(Words& words);
/// Parses a whole text of at most kMaxConditionBytes.
robot::Result<Condition> parse_condition(std::string_view text);

/// Watches one game and knows whether the condition holds for the game so far.
class Watch {
 public:
  /// `condition` outlives the watch.
  explicit Watch(const Condition& condition);

  /// Call with the glance of each tick.
  void see(const Glance& glance);
  bool holds() const;

 private:
  struct Progress {
    const Clause* clause;
    // newest tick in which the first 0, 1, … steps were complete, kNever: never; the newest leaves most time for the next
    std::vector<Tick> complete;
    bool broken = false;  // of "always"
  };

  static bool holds(const Progress& progress);

  std::vector<std::vector<Progress>> alternatives_;
};

}  // namespace sim::check
