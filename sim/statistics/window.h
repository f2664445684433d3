// A window of a game: positions of ball and robots at 30 Hz, as a camera beside the field sees them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/math/vec2.h"

namespace sim::statistics {

inline constexpr int kFramesPerSecond = 30;
/// The length of a window: 167 s, as long as each of the real recordings.
inline constexpr std::size_t kWindowFrames = 5000;

/// A robot in one frame.
struct Sighting {
  Vec2 position;      // [m, field]
  bool down = false;  // on the ground
};

/// A robot through the window.
struct Robot {
  int side = 0;                                 // 0 or 1
  int player = 1;                               // jersey number; 1 is the goalkeeper
  std::vector<std::optional<Sighting>> frames;  // absent: not seen in this frame
};

/// The ball through the window [m, field]; absent: not seen in this frame.
using Path = std::vector<std::optional<Vec2>>;

/// All frames of a window. Frames out of play are empty, so that the index of a frame is its time in 1/30 s.
struct Window {
  Path ball;
  std::vector<Robot> robots;  // each with as many frames as the ball

  std::size_t size() const { return ball.size(); }
};

}  // namespace sim::statistics
