// The camera: what is in view, how likely it is detected, and what noise in the image does to a place on the ground.
//
// Nothing here needs an angle of what is seen: directions are compared as vectors, elevations as slopes.
#pragma once

#include <array>
#include <cmath>

#include "sim/math/angles.h"
#include "sim/math/vec2.h"
#include "sim/perception/model.h"
#include "sim/world/body.h"

namespace sim::perception {

/// It stands or walks upright on the field; nobody else sees anything.
inline bool has_eyes(const Body& body) { return body.doing < Body::Doing::fallen; }

/// A point as a camera sees it, from the robot's feet.
struct Sighting {
  Vec2 to_it;    // [m, field's axes]
  float square;  // [m²] of its distance
  float height;  // [m] that the camera is above it
};
inline Sighting sighting_of(const Body& body, Vec2 point, float height) {
  const Vec2 to_it = point - body.position;
  return {to_it, squared_length(to_it), height};
}

/// Where a robot looks. [field's axes]
inline Vec2 look_of(const Body& body) { return turned(body.look, body.facing); }

/// Whether it is `angle` [rad] or more below the horizon, by sine and cosine.
bool below_by_sine(float angle, const Sighting& sighting);
/// The same; most cases are decided by bounds of the tangent.
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

/// cos² of half of `width` [rad], at most 3.1; a series of the quarter, which is below π/4, to 1e-7.
inline float squared_cosine_of_half(float width) {
  const float square = width * width * (1.f / 16);
  const float cosine = 1 - square * (0.5f - square * (1.f / 24 - square * (1.f / 720 - square * (1.f / 40320))));
  const float half = 2 * cosine * cosine - 1;
  return half * half;
}

/// Whether the camera of an upright body that looks to `look` shows it: not farther than `farthest` [m], between the
/// left and right edge, and the upper and lower one, which turn and nod with the head.
inline bool in_view(const Camera& camera, const Body& body, Vec2 look, float farthest, const Sighting& sighting) {
  const float ahead = dot(sighting.to_it, look);
  if (ahead <= 0 || sighting.square > farthest * farthest) return false;
  return ahead * ahead >= squared_cosine_of_half(camera.width) * sighting.square &&
         below(camera.upper_edge + body.head_pitch, sighting) && !below(camera.lower_edge + body.head_pitch, sighting);
}

/// The same question for many things on the ground: where there the edges of the image lie.
struct Window {
  Vec2 look;
  float squared_cosine;  // of half of the width
  float nearest;         // [m²] squared distance of the lower edge
  float farthest;        // [m²] likewise of the upper one, or of what is still told apart
};

Window window_of(const Camera& camera, const Body& body, float farthest);
inline bool in_view(const Window& window, Vec2 to_it, float square) {
  // no branch, so that several are looked at together; with the sign of `ahead` kept, behind and beside are one question
  const float ahead = dot(to_it, window.look);
  return (ahead * std::fabs(ahead) >= window.squared_cosine * square) & (window.nearest < square) &
         (square <= window.farthest);
}

/// The probability that something `range` [m] away is detected.
inline float probability(const Detection& detection, float range) {
  if (range <= detection.near_range) return detection.near;
  if (range >= detection.far_range) return range > detection.far_range ? 0 : detection.far;
  const float share = (range - detection.near_range) / (detection.far_range - detection.near_range);
  return detection.near + share * (detection.far - detection.near);
}

/// [rad²] Variances of the elevation and of the bearing under which the image shows things.
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

/// [m/rad] How far an elevation that is off moves what is d away and h below the camera: (d² + h²) / h.
inline float range_per_elevation(float squared_range, float height) {
  return (squared_range + height * height) / height;
}

/// [m²] Variance of a percept along each axis, the mean of range and bearing.
inline float percept_variance(const ImageNoise& noise, float squared_range, float height) {
  const float per_radian = range_per_elevation(squared_range, height);
  return 0.5f * (per_radian * per_radian * noise.elevation + squared_range * noise.bearing);
}

/// Where `place` [m, robot], `range` [m] away and `height` [m] below the camera, seems to be: `errors` are of the
/// elevation and of the bearing, in standard deviations. (0, 0), where nothing is ever seen, when it seems to be above
/// the horizon or farther than `farthest` [m].
inline Vec2 seen_through(const ImageNoise& noise, Vec2 place, float range, float height, float farthest,
                         std::array<float, 2> errors) {
  // tan(a + ε) of the elevation a with tan a = height / range, and its height / tan as a multiple of the range
  const float tilt = std::sqrt(noise.elevation) * errors[0];
  const float slope = height + range * tilt;
  const float share = height * (range - height * tilt);
  const float longest = farthest * slope;
  if (slope <= 0 || share <= 0 || share > longest) return {};

  const float turn = std::sqrt(noise.bearing) * errors[1];
  return share / (slope * range) * Vec2{place.x - turn * place.y, place.y + turn * place.x};
}

}  // namespace sim::perception
