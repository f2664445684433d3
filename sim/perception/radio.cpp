// The team's radio: contents, times, delays and losses of packets.
#include "sim/perception/perception.h"

namespace sim::perception {
namespace {

constexpr int kHeldBack = 30;       // [packets] reserve of the budget, as B-Human keep it (models.md 2.7)
constexpr float kLongestDelay = 5;  // [mean delays] a longer delay is cut off here

}  // namespace

agent::Mate packet_of(const agent::Beliefs& beliefs, const agent::Mind& mind, bool penalised, Tick now) {
  const Pose2& pose = beliefs.pose.pose;
  const agent::Ball& ball = beliefs.ball;
  agent::Mate packet{.pose = pose, .sent = now, .time_to_ball_cs = mind.time_to_ball_cs};
  packet.role = static_cast<std::uint8_t>(mind.role);
  packet.active = !penalised;
  packet.choice = mind.choice;
  if (ball.seen == kNever) return packet;

  packet.ball = pose.position + turned(ball.position, direction(pose.heading));
  const Tick since = now - ball.seen;
  packet.ball_age = static_cast<std::uint16_t>(since < 0xfffe ? since : 0xfffe);
  return packet;
}

Tick next_packet(const field::Rules& rules, const Effects& effects, Tick last, int sent, float remaining) {
  if (!effects.packet_limit) return last + 1;
  float silence = rules.message_interval;
  if (rules.message_budget != 0) {
    const int left = rules.message_budget - kHeldBack - sent;
    if (left <= 0) return kNever;
    const float share = remaining * static_cast<float>(rules.players) / static_cast<float>(left);
    silence = share > silence ? share : silence;
  }
  return last + ticks(silence);
}

Transmission transmit(const Model& model, const Effects& effects, const World& world, int sender) {
  Transmission transmission;
  if (!effects.packet_delay && !effects.packet_loss) return transmission;
  const auto words = draw(world.key, static_cast<std::uint32_t>(sender), Draw::packet, world.tick);
  if (effects.packet_delay) {
    const float times = -log(1 - uniform(words[0]));
    transmission.delay = ticks(model.radio.delay * (times < kLongestDelay ? times : kLongestDelay));
  }
  if (effects.packet_loss) {
    // 16 random bits for each mate
    static_assert(agent::kMaxMates <= 6);
    const auto chance = static_cast<std::uint32_t>(model.radio.loss * 0x1p16f);
    std::uint32_t lost = 0;
#pragma GCC unroll 6
    for (std::uint32_t mate = 0; mate < agent::kMaxMates; ++mate) {
      const std::uint32_t luck = words[1 + mate / 2] >> (16 * (mate % 2)) & 0xffff;
      lost |= static_cast<std::uint32_t>(luck < chance) << mate;
    }
    transmission.lost = static_cast<std::uint8_t>(lost);
  }
  return transmission;
}

}  // namespace sim::perception
