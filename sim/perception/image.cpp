#include "sim/perception/image.h"

#include <cfloat>

namespace sim::perception {
namespace {

/// Returns the squared distance of the ground `angle` [rad] below the horizon, seen from `height` [m]. [m²]
float squared_ground(float height, float angle) {
  if (angle <= 0) return FLT_MAX;
  if (angle >= kPi / 2) return 0;
  const SinCos edge = sin_cos(angle);
  const float cotangent = edge.cos / edge.sin;
  return height * height * cotangent * cotangent;
}

}  // namespace

bool below_by_sine(float angle, const Sighting& sighting) {
  if (angle >= kPi / 2) return false;
  const SinCos edge = sin_cos(angle);
  return sighting.height * sighting.height * edge.cos * edge.cos >= sighting.square * edge.sin * edge.sin;
}

Window window_of(const Camera& camera, const Body& body, float farthest) {
  const float horizon = squared_ground(camera.height, camera.upper_edge + body.head_pitch);
  const float range = farthest * farthest;
  return {look_of(body), squared_cosine_of_half(camera.width),
          squared_ground(camera.height, camera.lower_edge + body.head_pitch), horizon < range ? horizon : range};
}

}  // namespace sim::perception
