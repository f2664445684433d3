// Turning heads in lanes: one robot in each. Internal to sim/motion.
#pragma once

#include <cstdint>

#include "sim/math/lanes.h"
#include "sim/motion/aim.h"

namespace sim::motion {

/// The heads of up to kLanes robots, and their aims.
struct HeadLanes {
  Lane<std::int32_t> aims;  // 1: the aim is a point; 0: it is a yaw and a pitch
  Lane<Vec2> aim;           // [m, robot, from `told`], or yaw and pitch [rad]
  Lane<float> height;       // [m] of the point
  Lane<Vec2> told;          // position of the robot when it got the command [m, field]
  Lane<float> told_heading;
  Lane<Vec2> position, facing;
  Lane<float> heading;
  Lane<float> dt;          // [s]
  Lane<float> yaw, pitch;  // of the head
  Lane<Vec2> look;
  Lane<float> to_yaw, to_pitch;

  Gaze gaze(int i) const { return {yaw[i], pitch[i], look[i]}; }
  void set_gaze(int i, const Gaze& gaze) { yaw[i] = gaze.yaw, pitch[i] = gaze.pitch, look.set(i, gaze.look); }
  Stand stand(int i) const { return {position[i], heading[i], facing[i]}; }
};

/// Turns the heads.
template <bool Limited>
void turn_heads_on(const Head& model, HeadLanes& a) {
  const Head head = model;
  SIM_FOR_LANES(i) {
    const Vec2 point = seen_now(a.aim[i], {a.told[i], a.told_heading[i]}, a.stand(i));
    const Angles aimed = aimed_at(point, a.height[i], a.gaze(i));
    const bool aims = a.aims[i] != 0;
    a.to_yaw[i] = aims ? aimed.yaw : a.aim[i].x, a.to_pitch[i] = aims ? aimed.pitch : a.aim[i].y;
  }
  SIM_FOR_LANES(i) a.set_gaze(i, turned_to(head, Limited, {a.to_yaw[i], a.to_pitch[i]}, a.dt[i], a.gaze(i)));
}

}  // namespace sim::motion
