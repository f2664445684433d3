// A scene of simple shapes, and the messages that carry it to other viewers.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace robot::net {

inline constexpr const char* kFieldFrame = "field";

/// All parts 0 .. 1.
struct Colour {
  double red = 1, green = 1, blue = 1, alpha = 1;
};

/// Returns the colour 0xRRGGBB.
constexpr Colour colour_of(std::uint32_t rgb, double alpha = 1) {
  return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0, alpha};
}

struct Point3 {
  double x = 0, y = 0, z = 0;  // [m]
};

/// A simple shape around its place.
struct Shape {
  enum class Kind {
    box,
    ball,
    cylinder,  // along its z
    arrow,     // from its place along its x; size.x is the length, size.y the diameter
    words,     // face the viewer; size.z is the height of a line
    lines,     // two of `points` for each; size.z is the thickness
  };
  Kind kind = Kind::box;
  Point3 place;                     // [m, field]
  Point3 size;                      // [m]
  double heading = 0;               // [rad] counter-clockwise about z
  double pitch = 0;                 // [rad] then about the own y: π/2 turns the own z to the front
  Colour colour = {};               //
  std::string words = {};           //
  std::vector<Point3> points = {};  // [m] from `place`
};

/// One thing of the scene: a robot, the ball.
struct Entity {
  std::string id;
  std::vector<Shape> shapes;
};

/// All things at one time, in the frame `field`.
using Scene = std::vector<Entity>;

/// The scenes of one topic as foxglove.SceneUpdate. Each update deletes all entities that were shown before and are gone,
/// so that a client that missed some updates agrees with one that missed none. Used by one thread.
class SceneStream {
 public:
  /// Returns the serialised update from the earlier scenes to `scene`. Leaves out what is not finite or far away.
  std::string update(const Scene& scene, std::uint64_t capture_ns);

 private:
  static constexpr std::size_t kMostIds = 256;  // remembered: made-up numbers of robots must not fill the memory

  std::set<std::string> shown_;
};

/// Reports whether a place can be drawn: finite and within a kilometre.
bool can_be_drawn(double x, double y);
bool can_be_drawn(const Entity& entity);

}  // namespace robot::net
