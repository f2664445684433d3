// Pictures as a camera sees a field with tagged robots, bodies and balls: antialiased, blurred, noisy, distorted.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/tags/camera.h"

namespace tests {

/// The light that a surface sends back: red, green, blue [0..1], linear.
using Light = Eigen::Vector3f;

/// A thing in the scene.
class Thing {
 public:
  struct Hit {
    double distance;  // along the ray
    Light light;
  };
  virtual ~Thing() = default;
  virtual std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const = 0;

  /// The middle [m, field] and radius [m] of a sphere around it.
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double extent = 0;
};
using Things = std::vector<std::unique_ptr<Thing>>;

/// A printed tag of the family tag36h11 with a white margin, as libapriltag draws it. Frame `tag`: +x to the right edge
/// of the print, +y to its upper edge, +z towards the reader. `edge` [m] of the black square.
std::unique_ptr<Thing> printed_tag(int id, const Eigen::Isometry3d& field_from_tag, double edge);
std::unique_ptr<Thing> sphere(const Eigen::Vector3d& middle, double radius, const Light& light);

/// A cylinder that stands on the carpet: a robot's body.
std::unique_ptr<Thing> cylinder(const Eigen::Vector2d& place, double radius, double height, const Light& light);

/// The light of a room and the weaknesses of a camera.
struct Conditions {
  double brightness = 1;   // of the light in the middle of the picture
  double slope = 0.2;      // part of the brightness that is lost from the left to the right
  double blur = 0.7;       // [px] standard deviation
  double noise = 2.5;      // [1 of 255] standard deviation
  std::uint32_t seed = 1;  // of the noise
};

/// A camera that looks at an empty field of green carpet with white lines, 1 m apart along x and 1.5 m along y.
class Renderer {
 public:
  /// The width and height of the picture are multiples of 8.
  explicit Renderer(const robot::truth::tags::Camera& camera);

  robot::truth::DepthFrame render(const Things& things, const Conditions& conditions) const;

 private:
  Light trace(const Things& things, std::uint64_t which, const Eigen::Vector3d& way) const;
  Light pixel(const Things& things, std::uint64_t which, int x, int y) const;
  std::vector<std::uint64_t> things_of_pixels(const Things& things) const;
  const Eigen::Vector3d& way(int x, int y) const;

  robot::truth::tags::Camera camera_;
  int width_, height_;
  std::vector<Eigen::Vector3d> ways_;  // through the corners of all pixels [field]
  std::vector<Light> empty_;           // the picture of the empty field
};

}  // namespace tests
