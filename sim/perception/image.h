// The camera: which things are in view, how likely they are detected, and how noise in the image displaces them on the
// ground.
//
// No angle of a seen thing is computed: directions are compared as vectors, elevations as slopes.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>

#include "sim/math/angles.h"
#include "sim/math/vec2.h"
#include "sim/perception/model.h"
#include "sim/world/body.h"

namespace sim::perception {

/// Reports whether the robot sees anything: only upright robots on the field do.
inline bool has_eyes(const Body& body) { return body.doing < Body::Doing::fallen; }

/// A point relative to a robot's camera.
struct Sighting {
  Vec2 to_it;    // [m, field's axes] from the robot's feet
  float square;  // [m²] squared distance
  float height;  // [m] of the camera above the point
};
inline Sighting sighting_of(Vec2 to_it, float height) { return {to_it, squared_length(to_it), height}; }

/// Returns the direction in which a robot looks [unit vector, field's axes].
inline Vec2 look_of(const Body& body) { return turned(body.look, body.facing); }

/// Reports whether a point is `angle` [rad] or more below the horizon.
inline bool below(float angle, const Sighting& sighting) {
  const float height = sighting.height * sighting.height;
  const SinCos edge = sin_cos(angle);
  const bool by_sine = (angle < kPi / 2) & (height * edge.cos * edge.cos >= sighting.square * edge.sin * edge.sin);
  // Bounds of the tangent decide most cases: angle <= tan(angle), and up to 0.6 at most angle (1 + 0.4 angle²). Rounding
  // makes no difference to them, so a ball rolls into view at the same tick as without them.
  const float square = angle * angle, more = 1 + 0.4f * square;
  const float least = square * sighting.square;
  const bool by_bound = (square <= 0.36f) & (height >= more * more * least);
  const bool flat = (height >= least) & (by_bound | by_sine), steep = (height >= sighting.square) & by_sine;
  return (angle <= 0) | ((angle >= kPi / 4) & steep) | ((angle < kPi / 4) & flat);
}

/// Returns cos² of half of `width` [rad], for width <= 3.1, within 1e-7: a series of a
/// quarter of it, which is below π/4.
inline float squared_cosine_of_half(float width) {
  const float square = width * width * (1.f / 16);
  const float cosine = 1 - square * (0.5f - square * (1.f / 24 - square * (1.f / 720 - square * (1.f / 40320))));
  const float half = 2 * cosine * cosine - 1;
  return half * half;
}

/// Reports whether the camera of an upright robot that looks along `look` shows a point. The point is not farther than
/// `farthest` [m], and it is between the edges of the image, which move with the head.
inline bool in_view(const Camera& camera, float head_pitch, Vec2 look, float farthest, const Sighting& sighting) {
  const float ahead = dot(sighting.to_it, look);
  const bool near = (ahead > 0) & (sighting.square <= farthest * farthest);
  const bool beside = ahead * ahead < squared_cosine_of_half(camera.width) * sighting.square;
  return near & !beside & below(camera.upper_edge + head_pitch, sighting) &
         !below(camera.lower_edge + head_pitch, sighting);
}

/// The edges of the image on the ground, for tests of many points.
struct Window {
  Vec2 look;             // unit vector
  float squared_cosine;  // of half the width
  float nearest;         // [m²] squared distance of the lower edge
  float farthest;        // [m²] squared distance of the upper edge, or of the detection's range if that is nearer
};

/// Returns the squared distance of the ground `angle` [rad] below the horizon, seen from `height` [m]. [m²]
inline float squared_ground(float height, float angle) {
  const SinCos edge = sin_cos(angle);
  const float cotangent = edge.cos / edge.sin;
  const float square = height * height * cotangent * cotangent;
  return angle <= 0 ? FLT_MAX : angle >= kPi / 2 ? 0 : square;
}

/// Returns the window of a camera that looks along `look` [unit vector]. `farthest` [m] is the detection's range.
inline Window window_of(const Camera& camera, Vec2 look, float head_pitch, float farthest) {
  const float horizon = squared_ground(camera.height, camera.upper_edge + head_pitch);
  const float range = farthest * farthest;
  return {look, squared_cosine_of_half(camera.width), squared_ground(camera.height, camera.lower_edge + head_pitch),
          horizon < range ? horizon : range};
}
/// Reports whether a point on the ground is in the window.
inline bool in_view(const Window& window, Vec2 to_it, float square) {
  // no branch, so that several points are tested together; the kept sign of `ahead` excludes points behind the robot
  const float ahead = dot(to_it, window.look);
  return (ahead * std::fabs(ahead) >= window.squared_cosine * square) & (window.nearest < square) &
         (square <= window.farthest);
}

/// Returns the probability that something `range` [m] away is detected.
inline float probability(const Detection& detection, float range) {
  const float share = (range - detection.near_range) / (detection.far_range - detection.near_range);
  const float between = detection.near + share * (detection.far - detection.near);
  const float beyond = range > detection.far_range ? 0 : detection.far;
  return range <= detection.near_range ? detection.near : range >= detection.far_range ? beyond : between;
}

/// The variances of the elevation and of the bearing in the image [rad²].
struct ImageNoise {
  float elevation;
  float bearing;
};
/// Returns `a` if `first` is true, `b` otherwise, without a branch.
constexpr ImageNoise select(bool first, const ImageNoise& a, const ImageNoise& b) {
  return {first ? a.elevation : b.elevation, first ? a.bearing : b.bearing};
}
inline ImageNoise image_noise(const Model& model, bool stands) {
  const Noise& noise = model.noise;
  const float pixels = noise.pixels * model.camera.pixel_angle;
  const float tilt = stands ? noise.tilt : noise.tilt_walking;
  return {tilt * tilt + pixels * pixels, noise.roll * noise.roll + pixels * pixels};
}

/// Returns the displacement on the ground per error of the elevation [m/rad]: (d² + h²) / h at distance d and height h.
inline float range_per_elevation(float squared_range, float height) {
  return (squared_range + height * height) / height;
}

/// Returns the variance of a percept along each axis [m²]: the mean of those along range and bearing.
inline float percept_variance(const ImageNoise& noise, float squared_range, float height) {
  const float per_radian = range_per_elevation(squared_range, height);
  return 0.5f * (per_radian * per_radian * noise.elevation + squared_range * noise.bearing);
}

/// The place of a thing in an image.
struct Seen {
  Vec2 place;             // [m, robot]
  std::int32_t is_valid;  // 0: above the horizon, or beyond the farthest percept; no bool, which lanes do not like
};

/// Returns where a thing at `place` [m, robot], `range` [m] away and `height` [m] below the camera, seems to be.
/// `errors` are those of elevation and bearing, in standard deviations. A percept farther than `farthest` [m] is not
/// valid.
inline Seen seen_through(const ImageNoise& noise, Vec2 place, float range, float height, float farthest,
                         std::array<float, 2> errors) {
  // tan(a + ε) for the elevation a with tan a = height / range; then height / tan(a + ε) is the seen range
  const float tilt = std::sqrt(noise.elevation) * errors[0];
  const float slope = height + range * tilt;
  const float share = height * (range - height * tilt);
  const float longest = farthest * slope;
  const bool beyond = (slope <= 0) | (share <= 0) | (share > longest);

  const float turn = std::sqrt(noise.bearing) * errors[1];
  return {share / (slope * range) * Vec2{place.x - turn * place.y, place.y + turn * place.x}, beyond ? 0 : 1};
}

}  // namespace sim::perception
