// The team's radio: what a packet says, when one is sent, how late it comes and whether it does.
#include "sim/perception/perception.h"

namespace sim::perception {
namespace {

constexpr int kHeldBack = 30;       // packets, as B-Human do (models.md 2.7)
constexpr float kLongestDelay = 5;  // times the mean: what comes later than that counts as lost elsewhere

}  // namespace

agent::Mate packet_of(const agent::Beliefs& beliefs, const agent::Mind& mind, bool penalised, Tick now) {
  const Pose2& pose = beliefs.pose.pose;
  const agent::Ball& ball = beliefs.ball;
  agent::Mate packet{.pose = pose, .time_to_ball = mind.time_to_ball, .sent = now};
  packet.role = static_cast<std::uint8_t>(mind.role);
  packet.active = !penalised;
  if (ball.seen == kNever) return packet;

  packet.ball = pose.position + turned(ball.position, direction(pose.heading));
  const Tick since = now - ball.seen;
  packet.ball_age = static_cast<std::uint16_t>(since < 0xfffe ? since : 0xfffe);
  return packet;
}

bool sends(const field::Rules& rules, const Effects& effects, const Cognition& cognition, int sent, float remaining,
           Tick now) {
  if (!effects.packet_limit) return true;
  const float silent = age(now, cognition.packet.sent);
  // half a tick early is on time
  if (silent < rules.message_interval - 0.5f * kTickDuration) return false;
  if (rules.message_budget == 0) return true;
  const int left = rules.message_budget - kHeldBack - sent;
  return left > 0 && silent * static_cast<float>(left) >= remaining * static_cast<float>(rules.players);
}

Tick delay_of(const Model& model, const Effects& effects, const World& world, int sender) {
  if (!effects.packet_delay) return 0;
  const auto words = draw(world.key, static_cast<std::uint32_t>(sender), Event::packet_delay, world.tick);
  const float times = -log(1 - uniform(words[0]));
  return ticks(model.radio.delay * (times < kLongestDelay ? times : kLongestDelay));
}

void receive(const Model& model, const Effects& effects, const World& world, const agent::Mate& packet, int sender,
             int receiver, agent::Beliefs& beliefs) {
  if (effects.packet_loss) {
    const Tick number = world.tick * kMaxRobots + static_cast<Tick>(sender);
    const auto words = draw(world.key, static_cast<std::uint32_t>(receiver), Event::packet_loss, number);
    if (uniform(words[0]) < model.radio.loss) return;
  }
  const int from = player_of(sender), to = player_of(receiver);
  beliefs.mates[from < to ? from - 1 : from - 2] = packet;
}

}  // namespace sim::perception
