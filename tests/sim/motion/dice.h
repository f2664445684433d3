// Random numbers for tests, equal on all machines.
#pragma once

#include <random>

namespace sim::motion {

struct Dice {
  std::mt19937 engine;
  float between(float least, float most) {
    return least + (most - least) * static_cast<float>(engine() >> 8) * 0x1p-24f;
  }
};

}  // namespace sim::motion
