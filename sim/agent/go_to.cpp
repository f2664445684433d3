#include "sim/agent/go_to.h"

#include "sim/agent/head.h"
#include "sim/agent/place_skills.h"
#include "sim/agent/walk.h"

namespace sim::agent {

motion::Command go_to(const View& view, Mind&, const GoTo& with) {
  const Vec2 place{clamp(with.x, -view.half_length, view.half_length),
                   clamp(with.y, -view.half_width, view.half_width)};
  const Vec2 seen = with.face == Face::goal ? view.goal() : supposed_ball(view);
  const Vec2 face = is_given(with.direction) ? direction(with.direction) : unit(seen - view.position);
  motion::Command command = walk_to_place(view, place, face, with.gain);
  look_at_ball(view, command);
  return command;
}

}  // namespace sim::agent
