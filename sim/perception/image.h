// The camera: which things are in view, how likely they are detected, and how noise in the image displaces them on the
// ground.
//
// No angle of a seen thing is computed: directions are compared as vectors, elevations as slopes.
#pragma once

#include <array>
#include <cmath>

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
inline Sighting sighting_of(const Body& body, Vec2 point, float height) {
  const Vec2 to_it = point - body.position;
  return {to_it, squared_length(to_it), height};
}

/// Returns the direction in which a robot looks [unit vector, field's axes].
inline Vec2 look_of(const Body& body) { return turned(body.look, body.facing); }

/// Reports whether a point is `angle` [rad] or more below the horizon, by sine and cosine.
bool below_by_sine(float angle, const Sighting& sighting);
/// Reports the same. Bounds of the tangent decide most cases.
inline bool below(float angle, const Sighting& sighting) {
  if (angle <= 0) return true;
  const float height = sighting.height * sighting.height;
  if (angle >= kPi / 4) return height >= sighting.square && below_by_sine(angle, sighting);
  // angle <= tan(angle), and up to 0.6 at most angle (1 + 0.4 angle²)
  const float square = angle * angle, more = 1 + 0.4f * square;
  const float least = square * sighting.square;
  if (height < least) return false;
  return (square <= 0.36f && height >= more * more * least) || below_by_sine(angle, sighting);
}

/// Returns cos² of half of `width` [rad], for width <= 3.1, within 1e-7: a series of a
/// quarter of it, which is below π/4.
inline float squared_cosine_of_half(float width) {
  const float square = width * width * (1.f / 16);
  const float cosine = 1 - square * (0.5f - square * (1.f / 24 - square * (1.f / 720 - square * (1.f / 40320))));
  const float half = 2 * cosine * cosine - 1;
  return half * half;
}

/// Reports whether the camera of an upright body that looks along `look` shows a point. The point is not farther than
/// `farthest` [m], and it is between the edges of the image, which move with the head.
inline bool in_view(const Camera& camera, const Body& body, Vec2 look, float farthest, const Sighting& sighting) {
  const float ahead = dot(sighting.to_it, look);
  if (ahead <= 0 || sighting.square > farthest * farthest) return false;
  return ahead * ahead >= squared_cosine_of_half(camera.width) * sighting.square &&
         below(camera.upper_edge + body.head_pitch, sighting) && !below(camera.lower_edge + body.head_pitch, sighting);
}

/// The edges of the image on the ground, for tests of many points.
struct Window {
  Vec2 look;             // unit vector
  float squared_cosine;  // of half the width
  float nearest;         // [m²] squared distance of the lower edge
  float farthest;        // [m²] squared distance of the upper edge, or of the detection's range if that is nearer
};

/// Returns the window of a body's camera. `farthest` [m] is the detection's range.
Window window_of(const Camera& camera, const Body& body, float farthest);
/// Reports whether a point on the ground is in the window.
inline bool in_view(const Window& window, Vec2 to_it, float square) {
  // no branch, so that several points are tested together; the kept sign of `ahead` excludes points behind the robot
  const float ahead = dot(to_it, window.look);
  return (ahead * std::fabs(ahead) >= window.squared_cosine * square) & (window.nearest < square) &
         (square <= window.farthest);
}

/// Returns the probability that something `range` [m] away is detected.
inline float probability(const Detection& detection, float range) {
  if (range <= detection.near_range) return detection.near;
  if (range >= detection.far_range) return range > detection.far_range ? 0 : detection.far;
  const float share = (range - detection.near_range) / (detection.far_range - detection.near_range);
  return detection.near + share * (detection.far - detection.near);
}

/// The variances of the elevation and of the bearing in the image [rad²].
struct ImageNoise {
  float elevation;
  float bearing;
};
inline ImageNoise image_noise(const Model& model, const Body& body) {
  const Noise& noise = model.noise;
  const float pixels = noise.pixels * model.camera.pixel_angle;
  const float tilt = body.doing == Body::Doing::standing ? noise.tilt : noise.tilt_walking;
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

/// Returns where a thing at `place` [m, robot], `range` [m] away and `height` [m] below the camera, seems to be.
/// `errors` are those of elevation and bearing, in standard deviations. Returns (0, 0), which no real percept has, if
/// the thing seems to be above the horizon or farther than `farthest` [m].
inline Vec2 seen_through(const ImageNoise& noise, Vec2 place, float range, float height, float farthest,
                         std::array<float, 2> errors) {
  // tan(a + ε) for the elevation a with tan a = height / range; then height / tan(a + ε) is the seen range
  const float tilt = std::sqrt(noise.elevation) * errors[0];
  const float slope = height + range * tilt;
  const float share = height * (range - height * tilt);
  const float longest = farthest * slope;
  if (slope <= 0 || share <= 0 || share > longest) return {};

  const float turn = std::sqrt(noise.bearing) * errors[1];
  return share / (slope * range) * Vec2{place.x - turn * place.y, place.y + turn * place.x};
}

}  // namespace sim::perception
