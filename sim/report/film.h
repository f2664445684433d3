// A simulated game as a camera beside the field would film it: windows of positions at 30 Hz.
#pragma once

#include <vector>

#include "sim/match/state.h"
#include "sim/statistics/window.h"

namespace sim::report {

/// The positions in a game while it is in play. Frames out of play are empty. A window is complete after
/// statistics::kWindowFrames frames in play.
///
/// Each position has noise as in the real recordings: 1 cm of the ball and 1.5 cm of a robot, along each axis. It is a
/// function of the game's seed, the robot and the tick.
class Film {
 public:
  /// Adds the next tick. Call it once for each tick of the game.
  void look(const State& state);

  /// Returns the complete windows. The last, incomplete one is left out.
  const std::vector<statistics::Window>& windows() const { return windows_; }

 private:
  void begin(int players);
  void add_empty_frame();
  void add_frame(const World& world);

  std::vector<statistics::Window> windows_;
  statistics::Window now_;
  std::size_t in_play_ = 0;  // frames of `now_`
};

}  // namespace sim::report
