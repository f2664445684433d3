// The cognitive controller: world → beliefs.
#pragma once

#include <cstdint>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/field/field.h"
#include "sim/field/rules.h"
#include "sim/math/tick.h"
#include "sim/perception/cognition.h"
#include "sim/perception/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::perception {

/// What perceiving depends on; none of it changes during a game.
struct PerceptionParams {
  const Model& model;
  const Effects& effects;
  const field::Field& field;
  const field::Marks& marks;
  const ContactModel& contact;
  const BallModel& ball;
};

/// The robot comes onto the field (at the start, or back from a penalty): it knows roughly where it stands, and nothing
/// of the ball.
void enter(const PerceptionParams& params, const World& world, int robot, agent::Beliefs& beliefs,
           Cognition& cognition);

/// The beliefs of a robot `steps` ticks after the last time: predicted by odometry, then corrected by the image of
/// `world.tick`. Cheap when nothing is in view.
void perceive(const PerceptionParams& params, const World& world, int robot, Tick steps, agent::Beliefs& beliefs,
              Cognition& cognition);

/// What the robot would tell its team now.
agent::Mate packet_of(const agent::Beliefs& beliefs, const agent::Mind& mind, bool penalised, Tick now);
/// When a robot that sent at `last` may and wants to send again: after the year's interval, and with an even share of
/// what is left of the budget; kNever when nothing is. `sent` [packets] by the team so far, `remaining` [s] of the game.
Tick next_packet(const field::Rules& rules, const Effects& effects, Tick last, int sent, float remaining);
/// What becomes of a packet on its way.
struct Transmission {
  Tick delay = 0;         // [ticks] from sending to arriving
  std::uint8_t lost = 0;  // bit i: to the sender's beliefs.mates[i], each on his own
};
/// Of a packet that `sender` sends now.
Transmission transmit(const Model& model, const Effects& effects, const World& world, int sender);
/// Puts a packet of `sender` into the beliefs of its teammate `receiver`.
inline void receive(const agent::Mate& packet, int sender, int receiver, agent::Beliefs& beliefs) {
  beliefs.mates[sender < receiver ? player_of(sender) - 1 : player_of(sender) - 2] = packet;
}

}  // namespace sim::perception
