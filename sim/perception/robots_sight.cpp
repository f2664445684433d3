#include "sim/perception/robots_sight.h"

#include <array>

#include "sim/math/lanes.h"
#include "sim/perception/image.h"

namespace sim::perception {
namespace {

constexpr float kBeyondRobotRange = 1.5f;  // [ranges] a percept that seems to be farther away is dropped

/// A look for one opponent. `number` distinguishes the draws of one robot.
struct Glance {
  const Look* look;
  int opponent;
  std::uint32_t number;
};

/// The robots of one block, each with an opponent.
struct GlanceBlock {
  Lane<Vec2> position, facing, look, other;
  Lane<float> head_pitch;
  Lane<std::int32_t> stands;
  DrawLanes draws;
  Lane<Vec2> believed;  // position of the own believed pose [team_field]
  Lane<float> believed_heading;
  Lane<Vec2> place;  // [team_field]
  Lane<std::int32_t> seen;
};

/// The constants of a look for opponents.
struct GlanceConstants {
  const Model& model;
  std::int32_t everywhere;  // 1: the view is not limited
  std::int32_t certain;     // 1: each one in view is detected
  std::int32_t exact;       // 1: without noise
};

void glance_at_opponents(GlanceBlock& block, const GlanceConstants& constants) {
  const auto& [model, everywhere, certain, exact] = constants;
  const ImageNoise standing = image_noise(model, true), walking = image_noise(model, false);
  const float farthest = kBeyondRobotRange * model.robots.far_range;
  SIM_FOR_LANES(i) {
    // its feet must be in view
    const Sighting sighting = sighting_of(block.other[i] - block.position[i], model.camera.height);
    const Vec2 look = turned(block.look[i], block.facing[i]);
    const bool shown = in_view(model.camera, block.head_pitch[i], look, model.robots.far_range, sighting);
    block.seen[i] = (shown ? 1 : 0) | everywhere;
  }
  if (!any(block.seen)) return;
  SIM_FOR_LANES(i) {
    // the detection and its noise
    const Vec2 to_it = block.other[i] - block.position[i];
    const float range = std::sqrt(squared_length(to_it));
    const auto words = block.draws.draw(i, Draw::opponent_seen);
    const bool detected = uniform(words[0]) < probability(model.robots, range);
    const ImageNoise noise = select(block.stands[i] != 0, standing, walking);
    const Vec2 place = turned_back(to_it, block.facing[i]);
    const Seen seen = seen_through(noise, place, range, model.camera.height, farthest, normals(words[1], words[2]));
    const Vec2 believed = select(exact != 0, place, seen.place);
    block.place.set(i, block.believed[i] + turned(believed, direction(block.believed_heading[i])));
    block.seen[i] &= ((detected ? 1 : 0) | certain) & (seen.is_valid | exact);
  }
}

void gather_glance(const Glance& glance, int i, GlanceBlock& block) {
  const Look& look = *glance.look;
  const Body& body = look.body();
  block.position.set(i, body.position);
  block.facing.set(i, body.facing);
  block.look.set(i, body.look);
  block.other.set(i, look.world->bodies[glance.opponent].position);
  block.head_pitch[i] = body.head_pitch;
  block.stands[i] = body.doing == Body::Doing::standing ? 1 : 0;
  block.draws.set(i, look.world->key, look.robot, glance.number);
  const Pose2& pose = look.beliefs->pose.pose;
  block.believed.set(i, pose.position);
  block.believed_heading[i] = pose.heading;
}

void look_at(const PerceptionParams& params, std::span<const Glance> glances) {
  const Effects& effects = params.effects;
  const GlanceConstants constants{params.model, effects.limited_view ? 0 : 1, effects.missed_ball ? 0 : 1,
                                  effects.ball_noise ? 0 : 1};
  GlanceBlock block{};
  in_blocks(
      glances, [&](const Glance& glance, int i) { gather_glance(glance, i, block); },
      [&] { in_lanes<glance_at_opponents>(block, constants); },
      [&](const Glance& glance, int i) {
        if (block.seen[i] == 0) return;
        const Look& look = *glance.look;
        look.beliefs->opponents[player_of(glance.opponent) - 1] = {block.place[i], look.world->tick};
      });
}

}  // namespace

void look_for_opponents(const PerceptionParams& params, std::span<const Look> looks) {
  std::array<Glance, kMostLooks * kMaxPlayers> glances;
  std::size_t count = 0;
  for (const Look& look : looks) {
    const World& world = *look.world;
    const int first = robot_of(other(side_of(look.robot)), 1);
    const auto glance_at = [&](int opponent, std::uint32_t number) {
      if (on_field(world.bodies[opponent])) glances[count++] = {&look, opponent, number};
    };
    if (!has_eyes(look.body())) continue;
    if (!params.effects.limited_view) {
      for (int i = 0; i < world.players; ++i)
        glance_at(first + i, world.tick * kMaxPlayers + static_cast<std::uint32_t>(i));
      continue;
    }
    // the opponent whose turn came since the last call
    if (look.steps <= kGlance && world.tick % kGlance >= look.steps) continue;
    const Tick turn = world.tick / (look.steps <= kGlance ? kGlance : look.steps);
    glance_at(first + static_cast<int>(turn % static_cast<Tick>(world.players)), world.tick);
  }
  look_at(params, {glances.data(), count});
}

}  // namespace sim::perception
