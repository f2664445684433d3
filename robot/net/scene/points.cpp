#include "robot/net/scene/points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "robot/net/foxglove/rate_limit.h"
#include "robot/net/scene/cloud_points.h"
#include "robot/net/scene/schemas.h"

namespace robot::net {
namespace {

constexpr double kSpacing = 0.05;      // [m] between the points of an edge
constexpr std::size_t kMost = 62'500;  // points: a field has 4'000

/// Points along the edges of shapes.
class Cloud {
 public:
  /// The following points are relative to the place of `shape`, turned with it, and of its colour.
  void begin(const Shape& shape) { shape_ = &shape; }

  void add(const Point3& at) {
    if (points.size() > kMost) return;
    // the pitch about y, then the heading about z
    const double sp = std::sin(shape_->pitch), cp = std::cos(shape_->pitch);
    const double sh = std::sin(shape_->heading), ch = std::cos(shape_->heading);
    const double ahead = cp * at.x + sp * at.z, up = cp * at.z - sp * at.x;
    points.add(
        {shape_->place.x + ch * ahead - sh * at.y, shape_->place.y + sh * ahead + ch * at.y, shape_->place.z + up},
        shape_->colour);
  }

  void line(const Point3& from, const Point3& to) {
    const double x = to.x - from.x, y = to.y - from.y, z = to.z - from.z;
    const int parts = std::clamp(static_cast<int>(std::hypot(x, y, z) / kSpacing), 1, 1000);
    for (int i = 0; i < parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      add({from.x + share * x, from.y + share * y, from.z + share * z});
    }
  }

  void ring(double radius, double z) {
    constexpr int kParts = 16;
    for (int i = 0; i < kParts; ++i) {
      const double angle = 2 * std::numbers::pi * i / kParts;
      add({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }

  CloudPoints points;

 private:
  const Shape* shape_ = nullptr;
};

void add_box(Cloud& cloud, const Point3& size) {
  const double x = size.x / 2, y = size.y / 2, z = size.z / 2;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      cloud.line({-x, a * y, b * z}, {x, a * y, b * z});
      cloud.line({a * x, -y, b * z}, {a * x, y, b * z});
      cloud.line({a * x, b * y, -z}, {a * x, b * y, z});
    }
}

void add(Cloud& cloud, const Shape& shape) {
  cloud.begin(shape);
  const Point3& size = shape.size;
  switch (shape.kind) {
    case Shape::Kind::box: return add_box(cloud, size);
    case Shape::Kind::ball:
      for (const double height : {-0.7, 0.0, 0.7})
        cloud.ring(size.x / 2 * (height == 0 ? 1 : 0.7), height * size.z / 2);
      return;
    case Shape::Kind::cylinder:
      for (const double height : {-0.5, 0.0, 0.5}) cloud.ring(size.x / 2, height * size.z);
      return;
    case Shape::Kind::arrow: return cloud.line({}, {size.x, 0, 0});
    case Shape::Kind::words: return;
    case Shape::Kind::lines:
      for (std::size_t i = 0; i + 1 < shape.points.size(); i += 2) cloud.line(shape.points[i], shape.points[i + 1]);
  }
}

Convert clouds_of(const MakeScene& make) {
  constexpr double kRateHz = 5;
  return [make, limit = RateLimit()](const memory::Version& version) mutable -> Result<std::optional<std::string>> {
    if (!limit.passes(version.capture_ns(), kRateHz)) return std::optional<std::string>();
    const Result<Scene> scene = make(version);
    if (!scene) return scene.failure();
    return std::optional(point_cloud(*scene, version.capture_ns()));
  };
}

}  // namespace

std::string point_cloud(const Scene& scene, std::uint64_t capture_ns) {
  Cloud cloud;
  for (const Entity& entity : scene)
    if (can_be_drawn(entity))
      for (const Shape& shape : entity.shapes) add(cloud, shape);
  return cloud.points.message(capture_ns);
}

std::vector<Derived> point_channels(const memory::ChannelInfo& source, const SceneSources& sources) {
  const MakeScene make = scene_of(source, sources);
  if (!make) return {};
  const std::string of = source.topic == sources.each_second ? "/field" : source.topic;
  return {{.info = {.topic = of + "/points", .schema = kPointCloud.schema()},
           .make_convert = [make]() -> Convert { return clouds_of(make); }}};
}

}  // namespace robot::net
