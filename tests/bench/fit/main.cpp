// How exact are fitted models, and how honest are their intervals? Planted parameters, fitted a hundred times.
//
//   bench_fit [REPETITIONS] [CASE…]
//
// Prints a line of JSON for each result:
//   study    the 460 images of the thesis from 0.5 to 3 m; errors of each curve on other recordings, also nearer and farther
//   kicks    50 kicks of a kind: errors of speed and direction, coverage and score of the landing points
//   planted  each fitted figure: share of intervals that cover the planted value, bias in parts of the interval
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/bench/fit/planted.h"

namespace {

struct Case {
  const char* name;
  void (*run)(int repetitions);
  int most = 1'000'000;  // repetitions: some cases play whole games
};
constexpr Case kCases[] = {
    {"study", bench::study, 40},
    {"ball_distance", bench::ball_distance},
    {"kicks", bench::kicks},
    {"partial_kicks", bench::partial_kicks},
    {"rolling", bench::rolling},
    {"rebounds", bench::rebounds},
    {"falls", bench::falls},
    {"sights", bench::sights},
    {"visibility", bench::visibility},
    {"radio", bench::radio},
    {"walking", bench::walking},
    {"odometry", bench::odometry},
    {"localisation", bench::localisation},
    {"games", bench::games},
};

}  // namespace

int main(int count, char** words) {
  const int repetitions = count > 1 ? std::atoi(words[1]) : 100;
  const std::vector<std::string> only(words + std::min(count, 2), words + count);
  for (const Case& one : kCases)
    if (only.empty() || std::ranges::find(only, one.name) != only.end()) one.run(std::min(repetitions, one.most));
  return 0;
}
