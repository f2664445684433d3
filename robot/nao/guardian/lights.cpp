#include "robot/nao/guardian/lights.h"

namespace robot::nao {
namespace {

constexpr Colour kOff{0, 0, 0}, kBlue{0, 0, 1}, kRed{1, 0, 0}, kYellow{1, 1, 0}, kGreen{0, 1, 0}, kCyan{0, 1, 1};
constexpr Colour kOrange{1, 0.4f, 0}, kWhite{1, 1, 1};
constexpr std::uint64_t kBlink_ns = 500'000'000;

Colour chest(const Shown& shown) {
  if (shown.mode == Mode::unstiff) return shown.now_ns / kBlink_ns % 2 == 0 ? kBlue : kOff;
  if (shown.mode == Mode::penalised) return kRed;
  if (shown.mode == Mode::initial) return shown.game == GameState::standby ? kCyan : kOff;
  switch (shown.game) {
    case GameState::ready: return kBlue;
    case GameState::set: return kYellow;
    case GameState::finished: return kOff;
    default: return kGreen;
  }
}

}  // namespace

Lights lights_of(const Shown& shown) {
  Lights lights;
  lights.chest = chest(shown);
  lights.l_eye = lights.r_eye = shown.crashed ? kRed : shown.troubled ? kOrange : kWhite;
  for (std::size_t i = 0; i < lights.l_ear.size(); ++i)
    lights.l_ear[i] = lights.r_ear[i] = shown.charge > static_cast<float>(i) / 10 ? 1 : 0;
  return lights;
}

}  // namespace robot::nao
