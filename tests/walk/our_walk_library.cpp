// Our walk as a library, by the interface for walks of other teams: an example, and the proof that the interface lacks
// nothing.
#include <algorithm>

#include "robot/nao/walk/walk.h"
#include "tests/walk/foresight_walk.h"

using namespace robot::nao::walk;

namespace {

void copy(const Legs& legs, double (*to)[kLegJoints]) {
  for (const Side side : {left, right}) std::copy(legs[side].begin(), legs[side].end(), to[side]);
}

}  // namespace

double foresight_walk_stand(double legs[2][6]) {
  copy(stand(), legs);
  return Parameters{}.hip_height;
}

void* foresight_walk_begin() { return new Walk; }

int foresight_walk_tick(void* walk, const foresight_walk_sensors* sensors, const foresight_walk_command* command,
                        double dt, double targets[2][6]) {
  Walk& ours = *static_cast<Walk*>(walk);
  Sensors from;
  std::copy_n(sensors->rate, 3, from.rate.begin());
  from.roll = sensors->roll, from.pitch = sensors->pitch;
  for (const Side side : {left, right}) {
    std::copy_n(sensors->load[side], 4, from.load[side].begin());
    std::copy_n(sensors->joints[side], kLegJoints, from.joints[side].begin());
  }
  copy(ours.tick(from, {command->forward, command->left, command->turn}, dt), targets);
  return ours.steps() ? 1 : 0;
}

void foresight_walk_end(void* walk) { delete static_cast<Walk*>(walk); }
