// The choice of a kick: its row in the model, the leg and the heading for it.
#pragma once

#include <cstdint>

#include "sim/agent/target.h"

namespace sim::agent {

/// The kicks among which a leaf chooses. From `named` on it is one kick, the settings have its name.
enum class KickChoice : std::uint8_t { front, any, named };
inline constexpr const char* kKickChoices[] = {"front", "any", nullptr};  // by KickChoice
inline constexpr Range kKickRange{.unit = "",
                                  .least = 0,
                                  .most = static_cast<float>(KickChoice::named) + kMaxNamedKicks - 1,
                                  .names = kKickChoices,
                                  .names_kicks = true,
                                  .example = R"("side")"};
inline constexpr const char* kKickAbout =
    "front: the quickest one to the front; any: of all kicks the one that is possible soonest; or a kick of the model";

inline constexpr float kOtherLeg = 0.03f;  // [m] the ball must lie this far on the other side to change the leg

/// A kick with a leg.
struct Shot {
  std::uint8_t kick;  // index into the kicks of the model
  std::int8_t side;   // leg: +1 left, -1 right
  Vec2 bend;          // [robot] direction of the ball when the robot kicks, a unit vector
  Vec2 way;           // [robot] unit vector of the wanted direction of the ball
  Vec2 face;          // [robot] unit vector of the heading that sends the ball there
};

/// Returns the kick that sends the ball into the sector and carries `range` [m]; of kicks that are too short the
/// longest. A kick to the front takes the leg nearer to the ball. Of others it is the leg, and with KickChoice::any the
/// kick, for which the robot is ready soonest. The shot that the robot intends already is kept unless another is quicker
/// by a margin.
Shot choose_shot(const View& view, const Sector& sector, KickChoice choice, float range);

}  // namespace sim::agent
