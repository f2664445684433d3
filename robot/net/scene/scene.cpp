#include "robot/net/scene/scene.h"

#include <algorithm>
#include <cmath>

#include "robot/net/scene/wire.h"

namespace robot::net {
namespace {

Wire vector_of(const Point3& point) { return Wire().number(1, point.x).number(2, point.y).number(3, point.z); }

Wire message_of(const Colour& colour) {
  return Wire().number(1, colour.red).number(2, colour.green).number(3, colour.blue).number(4, colour.alpha);
}

Wire pose_of(const Shape& shape) {
  const double yaw = shape.heading / 2, pitch = shape.pitch / 2;
  return Wire()
      .message(1, vector_of(shape.place))
      .message(2, Wire()
                      .number(1, -std::sin(yaw) * std::sin(pitch))
                      .number(2, std::cos(yaw) * std::sin(pitch))
                      .number(3, std::sin(yaw) * std::cos(pitch))
                      .number(4, std::cos(yaw) * std::cos(pitch)));
}

/// The fields of foxglove.SceneEntity and of its parts are those of proto/foxglove/SceneUpdate.proto.
void append(const Shape& shape, Wire& entity) {
  const Wire pose = pose_of(shape), colour = message_of(shape.colour);
  switch (shape.kind) {
    case Shape::Kind::box:
      entity.message(8, Wire().message(1, pose).message(2, vector_of(shape.size)).message(3, colour));
      return;
    case Shape::Kind::ball:
      entity.message(9, Wire().message(1, pose).message(2, vector_of(shape.size)).message(3, colour));
      return;
    case Shape::Kind::cylinder:
      entity.message(
          10, Wire().message(1, pose).message(2, vector_of(shape.size)).number(3, 1).number(4, 1).message(5, colour));
      return;
    case Shape::Kind::arrow: {
      const double head = std::min(2 * shape.size.y, shape.size.x / 2);
      entity.message(7, Wire()
                            .message(1, pose)
                            .number(2, shape.size.x - head)
                            .number(3, shape.size.y)
                            .number(4, head)
                            .number(5, 2 * shape.size.y)
                            .message(6, colour));
      return;
    }
    case Shape::Kind::words:
      entity.message(13, Wire()
                             .message(1, pose)
                             .integer(2, 1)
                             .number(3, shape.size.z)
                             .integer(4, 0)
                             .message(5, colour)
                             .text(6, shape.words));
      return;
    case Shape::Kind::lines: {
      constexpr std::uint64_t kLineList = 2;
      Wire lines;
      lines.integer(1, kLineList).message(2, pose).number(3, shape.size.z).integer(4, 0);
      for (const Point3& point : shape.points) lines.message(5, vector_of(point));
      entity.message(11, lines.message(6, colour));
    }
  }
}

}  // namespace

bool can_be_drawn(double x, double y) {
  constexpr double kFar = 1000;
  return std::abs(x) <= kFar && std::abs(y) <= kFar;
}

bool can_be_drawn(const Entity& entity) {
  return std::ranges::all_of(entity.shapes, [](const Shape& shape) {
    return can_be_drawn(shape.place.x, shape.place.y) && can_be_drawn(shape.size.x, shape.size.y) &&
           std::isfinite(shape.heading);
  });
}

std::string SceneStream::update(const Scene& scene, std::uint64_t capture_ns) {
  const Wire time = timestamp(capture_ns);
  std::set<std::string> present;
  Wire entities;
  for (const Entity& entity : scene) {
    if (!can_be_drawn(entity) || !present.insert(entity.id).second) continue;
    Wire message;
    message.message(1, time).text(2, kFieldFrame).text(3, entity.id);
    message.message(4, Wire().integer(1, 0).integer(2, 0)).integer(5, 0);
    for (const Shape& shape : entity.shapes) append(shape, message);
    entities.message(2, message);
  }
  Wire update;
  for (const std::string& id : shown_)
    if (!present.contains(id)) update.message(1, Wire().message(1, time).integer(2, 0).text(3, id));
  if (shown_.size() + present.size() <= kMostIds) shown_.merge(present);
  return update.bytes() + entities.bytes();
}

}  // namespace robot::net
