// The cognitive controller: world → beliefs.
#pragma once

#include <cstdint>
#include <span>

#include "sim/agent/beliefs.h"
#include "sim/agent/mind.h"
#include "sim/field/field.h"
#include "sim/field/rules.h"
#include "sim/math/tick.h"
#include "sim/perception/cognition.h"
#include "sim/perception/look.h"
#include "sim/perception/model.h"
#include "sim/world/effects.h"
#include "sim/world/model.h"
#include "sim/world/world.h"

namespace sim::perception {

/// The parameters of perception. They are constant during a game.
struct PerceptionParams {
  const Model& model;
  const Effects& effects;
  const field::Field& field;
  const field::Marks& marks;
  const ContactModel& contact;
  const BallModel& ball;
};

/// Sets the beliefs of a robot that enters the field, at the start or after a penalty: it knows roughly where it
/// stands, and nothing about the ball.
void enter(const PerceptionParams& params, const World& world, int robot, agent::Beliefs& beliefs,
           Cognition& cognition);

/// Updates the beliefs of robots of any number of games with these parameters: odometry predicts them, the images up to
/// `world.tick` correct them. At most kMostLooks at once; no look depends on another one. Cheap when the view is empty.
void perceive(const PerceptionParams& params, std::span<const Look> looks);

/// Returns the packet that the robot would send to its team now.
agent::Mate packet_of(const agent::Beliefs& beliefs, const agent::Mind& mind, bool penalised, Tick now);
/// Returns the tick at which a robot that sent at `last` sends again. It keeps the interval of the year's rules, and a
/// longer one if the remaining budget has to last for the rest of the game. Returns kNever when the budget is used up.
/// `sent` [packets] is the team's number so far, `remaining` [s] the rest of the game.
Tick next_packet(const field::Rules& rules, const Effects& effects, Tick last, int sent, float remaining);
/// The fate of a packet on the air.
struct Transmission {
  Tick delay = 0;         // [ticks] from sending to arrival
  std::uint8_t lost = 0;  // bit i: lost for the sender's beliefs.mates[i]; losses are independent
};
/// Draws the transmission of a packet that `sender` sends now.
Transmission transmit(const Model& model, const Effects& effects, const World& world, int sender);
/// Puts a packet of `sender` into the beliefs of its teammate `receiver`.
inline void receive(const agent::Mate& packet, int sender, int receiver, agent::Beliefs& beliefs) {
  beliefs.mates[sender < receiver ? player_of(sender) - 1 : player_of(sender) - 2] = packet;
}

}  // namespace sim::perception
