#include "sim/referee/event.h"

namespace sim::referee {

const char* name_of(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::ready: return "ready";
    case Event::Kind::set: return "set";
    case Event::Kind::playing: return "playing";
    case Event::Kind::ball_free: return "ball free";
    case Event::Kind::goal: return "goal";
    case Event::Kind::out: return "out";
    case Event::Kind::kick_in: return "kick-in";
    case Event::Kind::goal_kick: return "goal kick";
    case Event::Kind::corner_kick: return "corner kick";
    case Event::Kind::pushing: return "pushing";
    case Event::Kind::illegal_defender: return "illegal defender";
    case Event::Kind::leaving: return "leaving";
    case Event::Kind::local_stuck: return "local stuck";
    case Event::Kind::global_stuck: return "global stuck";
    case Event::Kind::illegal_kick: return "illegal kick";
    case Event::Kind::illegal_position: return "illegal position";
    case Event::Kind::returned: return "returned";
    case Event::Kind::half_time: return "half time";
    case Event::Kind::end: return "end";
    case Event::Kind::placed: return "placed";
  }
  return "";
}

}  // namespace sim::referee
