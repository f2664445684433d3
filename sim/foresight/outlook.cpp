#include "sim/foresight/outlook.h"

#include <algorithm>

#include "sim/referee/referee.h"

namespace sim::foresight {

Place place_of(const field::Field& field, const State& state, Side side) {
  const float ahead = attack_sign(state.world, side) * state.world.ball.position.x;
  const float share = ahead / field.length + 0.5f;
  const float zone = std::clamp(share, 0.f, 1.f) * static_cast<float>(Outlook::kZones);
  return {std::min(static_cast<int>(zone), Outlook::kZones - 1), state.book.last_touch == side ? 0 : 1};
}

float worth(const Outlook& outlook, const Params& params, const State& state, Side side) {
  const float left = referee::left_of_half(params.rules, state.book);
  const float share = std::clamp(left / outlook.reach, 0.f, 1.f);
  const Place place = place_of(params.rules.field, state, side);
  return share * outlook.worth[place.zone][place.touch];
}

}  // namespace sim::foresight
