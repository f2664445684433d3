// Changes of a strategy, in words.
#pragma once

#include <string>
#include <vector>

namespace sim::learn {

/// One change.
struct Change {
  std::string what;    // "near_ball", "shoot / free"
  std::string before;  // empty: the rule was removed
  std::string after;

  friend bool operator==(const Change&, const Change&) = default;
};

/// Returns the change as a line: "near_ball: 0.5 m → 0.62 m".
std::string text_of(const Change& change);

/// Joins the changes of one thing that follow each other, and drops those within a rule that was removed later.
std::vector<Change> merged(const std::vector<Change>& changes);

}  // namespace sim::learn
