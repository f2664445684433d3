#include "sim/perception/robots_sight.h"

namespace sim::perception {
namespace {

constexpr float kBeyondRobotRange = 1.5f;  // [ranges] a percept that seems to be farther away is dropped

}  // namespace

void look_for_opponent(const PerceptionParams& params, const World& world, int robot, int opponent,
                       std::uint32_t number, agent::Beliefs& beliefs) {
  const auto& [model, effects, field, marks, contact, ball] = params;
  const Body& body = world.bodies[robot];
  const Body& other = world.bodies[opponent];
  if (!has_eyes(body) || other.doing == Body::Doing::removed) return;

  // its feet must be in view
  const Sighting sighting = sighting_of(body, other.position, model.camera.height);
  if (effects.limited_view && !in_view(model.camera, body, look_of(body), model.robots.far_range, sighting)) return;
  Vec2 place = turned_back(sighting.to_it, body.facing);

  // the detection and its noise
  if (effects.missed_ball || effects.ball_noise) {
    const float range = std::sqrt(sighting.square);
    const auto words = draw(world.key, static_cast<std::uint32_t>(robot), Draw::opponent_seen, number);
    if (effects.missed_ball && uniform(words[0]) >= probability(model.robots, range)) return;
    if (effects.ball_noise) {
      place = seen_through(image_noise(model, body), place, range, sighting.height,
                           kBeyondRobotRange * model.robots.far_range, normals(words[1], words[2]));
      if (place == Vec2{}) return;
    }
  }
  const Pose2& pose = beliefs.pose.pose;
  beliefs.opponents[player_of(opponent) - 1] = {pose.position + turned(place, direction(pose.heading)), world.tick};
}

}  // namespace sim::perception
