#include "robot/truth/synthetic/cast.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector3f;

/// The part of an image in which something may be, without its end.
struct Rectangle {
  int left, right, top, bottom;  // [px]
};

/// The range of a coordinate [px].
struct Range {
  float least, most;
};

/// Returns the range of the image coordinate of a ball at `side` and `depth` [m], by its two tangents.
Range shadow_of_ball(float side, float depth, float radius, double focal, double centre) {
  const float middle = std::atan2(side, depth), half = std::asin(radius / std::hypot(side, depth));
  const auto f = static_cast<float>(focal), c = static_cast<float>(centre);
  return {c + f * std::tan(middle - half), c + f * std::tan(middle + half)};
}

/// Returns the pixels whose centres lie within the union of two ranges.
std::pair<int, int> pixels_of(Range a, Range b, int size) {
  const float least = std::min(a.least, b.least) - 0.5F, most = std::max(a.most, b.most) + 0.5F;
  const auto end = static_cast<float>(size);
  return {static_cast<int>(std::clamp(least, 0.F, end)), static_cast<int>(std::clamp(most, 0.F, end))};
}

Rectangle rectangle_of(const Capsule& capsule, const Intrinsics& image) {
  const auto across = [&](const Vector3f& end, int axis) {
    return shadow_of_ball(end[axis], end.z(), capsule.radius, axis == 0 ? image.focal_x : image.focal_y,
                          axis == 0 ? image.centre_x : image.centre_y);
  };
  const auto [left, right] = pixels_of(across(capsule.from, 0), across(capsule.to, 0), image.width);
  const auto [top, bottom] = pixels_of(across(capsule.from, 1), across(capsule.to, 1), image.height);
  return {left, right, top, bottom};
}

/// A capsule with everything that is the same for all rays from the origin.
class Target {
 public:
  explicit Target(const Capsule& capsule)
      : capsule_(capsule),
        axis_(capsule.to - capsule.from),
        axis_squared_(axis_.squaredNorm()),
        axis_from_(-axis_.dot(capsule.from)),
        wall_(axis_squared_ * (capsule.from.squaredNorm() - square(capsule.radius)) - square(axis_from_)),
        from_cap_(capsule.from.squaredNorm() - square(capsule.radius)),
        to_cap_(capsule.to.squaredNorm() - square(capsule.radius)) {}

  /// Returns where the ray meets the surface first, in lengths of the ray, or kFar.
  float hit(const Vector3f& ray) const {
    const float ray_squared = ray.squaredNorm(), along = axis_.dot(ray), towards = -ray.dot(capsule_.from);
    if (axis_squared_ < 1e-9F) return hit_cap(ray_squared, towards, from_cap_);

    const float a = axis_squared_ * ray_squared - square(along);
    const float b = axis_squared_ * towards - axis_from_ * along;
    const float root = square(b) - a * wall_;
    if (root < 0) return kFar;
    // a ray along the axis meets the caps only
    const float distance = a > 1e-9F ? (-b - std::sqrt(root)) / a : 0;
    const float place = axis_from_ + distance * along;
    if (place > 0 && place < axis_squared_) return distance;
    return place <= 0 ? hit_cap(ray_squared, towards, from_cap_) : hit_cap(ray_squared, -ray.dot(capsule_.to), to_cap_);
  }

 private:
  static float square(float x) { return x * x; }

  static float hit_cap(float ray_squared, float towards, float cap) {
    const float root = square(towards) - ray_squared * cap;
    return root < 0 ? kFar : (-towards - std::sqrt(root)) / ray_squared;
  }

  const Capsule& capsule_;
  Vector3f axis_;
  float axis_squared_;
  float axis_from_;  // the origin's place along the axis, from `from`
  float wall_;       // the constant terms of the three quadratic equations
  float from_cap_, to_cap_;
};

Material material_at(const Capsule& capsule, const Vector3f& point) {
  if (capsule.material != Material::patches) return capsule.material;
  const Vector3f from_centre = point - capsule.from;
  return (from_centre.x() > 0) ^ (from_centre.y() > 0) ^ (from_centre.z() > 0) ? Material::black : Material::white;
}

}  // namespace

void draw(const Capsule& in_sensor, const Intrinsics& image, Cast& cast) {
  constexpr float kNearest = 0.05F;
  if (std::min(in_sensor.from.z(), in_sensor.to.z()) - in_sensor.radius < kNearest) return;
  const Rectangle part = rectangle_of(in_sensor, image);
  const Target target(in_sensor);
  for (int row = part.top; row < part.bottom; ++row)
    for (int column = part.left; column < part.right; ++column) {
      const Vector3f ray(static_cast<float>((column + 0.5 - image.centre_x) / image.focal_x),
                         static_cast<float>((row + 0.5 - image.centre_y) / image.focal_y), 1);
      const float depth = target.hit(ray);
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
      if (depth >= cast.depth[pixel]) continue;
      cast.depth[pixel] = depth;
      cast.material[pixel] = material_at(in_sensor, depth * ray);
    }
}

}  // namespace robot::truth
