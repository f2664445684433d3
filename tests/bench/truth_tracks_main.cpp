// How good are velocities, identities and covariances of the fused truth, and what does an image cost?
// The budget of an image is 0.1 ms with 10 robots on the lab's machine.
#include <cstdio>

#include "tests/bench/truth_tracks.h"

int main() {
  for (const auto& part : {kicked_ball, identity_switches, consistency, cost_of_an_image}) std::puts(part().c_str());
}
