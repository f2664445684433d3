// How exactly and how fast are robots and balls found in depth images?
//
//   bench_truth frames FRAMES      the detection on this many synthetic images of each case
//
// Prints a line of JSON for each case. Images: 640 x 480, five robots down to 0.36 m apart, a ball, a walking referee.
// Budget: a frame in 1.2 ms on one core; robots within 5 m: 2.0 cm on average and 3.5 cm at p95; a ball 1.2 cm.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/bench/truth_frames.h"

int main(int count, char** words) {
  const int frames = count == 3 && std::string_view(words[1]) == "frames" ? std::atoi(words[2]) : 0;
  if (frames <= 0) {
    std::fputs("bench_truth: expected `frames` and a number of images\n", stderr);
    return 2;
  }
  bench::truth_frames(frames);
  return 0;
}
