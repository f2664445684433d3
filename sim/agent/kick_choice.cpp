#include "sim/agent/kick_choice.h"

#include "sim/agent/walk.h"
#include "sim/motion/motion.h"

namespace sim::agent {
namespace {

constexpr float kFront = 0.2f;       // [rad] a kick this far from straight ahead goes to the front
constexpr float kStay = 0.4f;        // [s] lead that another shot needs
constexpr float kTurnsFirst = 0.4f;  // [m] farther away the body turns to its destination first (sim/motion/walk.cpp)

bool goes_to_front(const motion::Kick& kick) { return std::abs(kick.direction) <= kFront; }

/// Returns whether `kick` suits the range better than `other`: it carries that far and is quick, or it is long.
bool suits_better(const motion::Kick& kick, const motion::Kick& other, float range) {
  const bool reaches = kick.range >= range, other_reaches = other.range >= range;
  if (reaches != other_reaches) return reaches;
  return reaches ? kick.delay < other.delay : kick.range > other.range;
}

/// Returns the quickest kick to the front that carries `range`, or the longest when none does.
int front_kick(const motion::Model& model, float range) {
  int best = -1;
  for (int i = 0; i < model.kick_count; ++i)
    if (goes_to_front(model.kicks[i]) && (best < 0 || suits_better(model.kicks[i], model.kicks[best], range))) best = i;
  return best < 0 ? 0 : best;
}

Shot shot_with(const View& view, const Sector& sector, int kick, std::int8_t side) {
  const float angle = view.around.motion->kicks[kick].direction;
  const Vec2 bend = angle == 0 ? Vec2{1, 0} : direction(static_cast<float>(side) * angle);
  const Vec2 way = way_in(sector, view, bend);
  return {static_cast<std::uint8_t>(kick), side, bend, way, turned_back(way, bend)};
}

/// Returns the shot to the front with the leg nearer to the ball.
Shot front_shot(const View& view, const Sector& sector, int kick) {
  const Shot shot = shot_with(view, sector, kick, view.mind.search_side);
  const float off = cross(shot.face, view.ball);
  if (std::abs(off) <= kOtherLeg || left_or_right(off) == shot.side) return shot;
  return shot_with(view, sector, kick, left_or_right(off));
}

/// Returns the time [s] to turn by the angle between two unit vectors, about.
float turning_time(const motion::Walk& walk, Vec2 from, Vec2 to) {
  return 0.5f * kPi / walk.turn_rate * (1 - dot(from, to));
}

/// Estimates the time [s] until the foot touches the ball.
float time_of(const View& view, const Shot& shot) {
  const motion::Kick& kick = view.around.motion->kicks[shot.kick];
  const motion::Walk& walk = view.around.motion->walk;
  const Vec2 place = place_for(kick, view.ball, shot.face, shot.side);
  const Vec2 first = round_circle(view, view.ball, room_of(kick.ball_x), place, view.mind.search_side);
  const float way = length(first), rest = distance(first, place);
  float turning = turning_time(walk, {1, 0}, shot.face);
  if (way > kTurnsFirst) {
    const Vec2 ahead = (1 / way) * first;
    turning = turning_time(walk, {1, 0}, ahead) + turning_time(walk, ahead, shot.face);
  }
  return (way + rest) / (0.5f * (walk.forward + walk.sideward)) + turning + kick.delay;
}

}  // namespace

Shot choose_shot(const View& view, const Sector& sector, KickChoice choice, float range) {
  const motion::Model& model = *view.around.motion;
  int only = -1;
  if (choice >= KickChoice::named) {
    const int index = static_cast<int>(choice) - static_cast<int>(KickChoice::named);
    only = motion::find_kick(model, view.settings.kicks.names[index]);
  }
  // a kick that this body lacks is replaced by one to the front
  if (choice == KickChoice::front || (choice != KickChoice::any && only < 0))
    return front_shot(view, sector, front_kick(model, range));
  if (only >= 0 && goes_to_front(model.kicks[only])) return front_shot(view, sector, only);

  // all kicks that carry far enough, otherwise the longest
  float needed = range, longest = 0;
  for (int i = 0; i < model.kick_count; ++i) longest = longest > model.kicks[i].range ? longest : model.kicks[i].range;
  if (longest < needed) needed = longest;
  Shot best{};
  float least = 1e6f;
  for (int i = 0; i < model.kick_count; ++i) {
    if (only >= 0 ? i != only : model.kicks[i].range < needed) continue;
    for (const int turn : {1, -1}) {
      const auto side = static_cast<std::int8_t>(turn * view.mind.search_side);
      const Shot shot = shot_with(view, sector, i, side);
      const bool intended = shot.kick == view.mind.kick && turn == 1;
      const float time = time_of(view, shot) - (intended ? kStay : 0);
      if (time < least) best = shot, least = time;
    }
  }
  return best;
}

}  // namespace sim::agent
