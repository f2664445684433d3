// A moment of a running game that is kept as a situation.
#pragma once

#include <string>

#include "robot/core/result.h"
#include "sim/match/state.h"

namespace sim::io {

/// A named moment, and its description once the game has reached it.
class SavedMoment {
 public:
  /// Parses the moment. "312" is 312 s after the first tick, dead time included. "2:05:12" is the first tick with that
  /// time on the clock of half 2, as in the list of events.
  static robot::Result<SavedMoment> parse(const std::string& when);

  /// Keeps the situation if this is the first state that has reached the moment. `about` says from which game it comes.
  void see(const State& state, const std::string& about);

  /// Returns whether the state is at the moment or behind it.
  bool comes_with(const State& state) const;

  bool reached() const { return !text_.empty(); }
  /// Returns the description for parse_situation, or "" before the moment.
  const std::string& text() const { return text_; }

 private:
  int half_ = 0;  // 0: the time since the first tick
  float seconds_ = 0;
  std::string text_;
};

}  // namespace sim::io
