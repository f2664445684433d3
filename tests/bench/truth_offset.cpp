// How exactly do the data tell the offset between the clocks of ground truth and robot, and how honest is its error?
// Bars for 60 s with kicks: median error <= 10 ms, p95 <= 25 ms; the 95 % interval covers 90-99 %. None of 100 recordings
// without a kick is accepted. A minute takes well below a second, an hour of five robots some seconds.
//
//   bench_truth_offset [RECORDINGS]
//
// Prints a line of JSON for each case: recordings of one length, with random offsets of up to 0.8 s, searched within 60 s.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "robot/lab/clocks/truth_offset.h"
#include "tests/support/planted_offset.h"

namespace {

using namespace robot::lab;

/// One length of recordings.
struct Case {
  double seconds = 60;
  bool kicks = true;
  double drift = 0;  // [s/s]
  int recordings = 100;
};

/// The figures of one case.
struct Figures {
  std::vector<double> errors, deviations, drift_errors;  // [ms], [ms], [ppm]
  int covered = 0;
  double cpu_seconds = 0;  // [s] of processor time, of all estimates

  void take(const tests::PlantedPlan& plan, const DataOffset& found) {
    const double planted = plan.offset + plan.drift * (found.middle - plan.offset);
    errors.push_back(std::abs(found.offset - planted) * 1e3);
    deviations.push_back(found.deviation * 1e3);
    covered += errors.back() <= kTwoSided * deviations.back();
    if (found.drift_deviation > 0) drift_errors.push_back(std::abs(found.drift - plan.drift) * 1e6);
  }
};

/// Returns the value that `part` of all do not exceed; 0 without values.
double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

Figures measure(const Case& of) {
  Figures figures;
  std::mt19937 random(7);
  for (int i = 0; i < of.recordings; ++i) {
    const tests::PlantedPlan plan{.seconds = of.seconds,
                                  .kicks = of.kicks,
                                  .offset = -0.8 + 1.6 * (static_cast<double>(random()) / 4294967296.0),
                                  .drift = of.drift,
                                  .seed = 1000 + static_cast<std::uint32_t>(i)};
    const auto distances = tests::planted_distances(plan);
    const std::clock_t start = std::clock();
    const auto found = find_offset(tests::shared_distance(distances), {.middle = 0, .reach = 60});
    figures.cpu_seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (found) figures.take(plan, *found);
  }
  return figures;
}

void print(const Case& of, const Figures& figures) {
  const auto accepted = figures.errors.size();
  std::printf(
      "{\"bench\": \"truth_offset\", \"seconds\": %.0f, \"kicks\": %s, \"drift_ppm\": %.0f, \"recordings\": %d, "
      "\"accepted\": %zu, \"error_median_ms\": %.2f, \"error_p95_ms\": %.2f, \"deviation_median_ms\": %.2f, "
      "\"coverage\": %.3f, \"drift_error_median_ppm\": %.2f, \"estimate_cpu_ms\": %.1f}\n",
      of.seconds, of.kicks ? "true" : "false", of.drift * 1e6, of.recordings, accepted, quantile(figures.errors, 0.5),
      quantile(figures.errors, 0.95), quantile(figures.deviations, 0.5),
      accepted > 0 ? static_cast<double>(figures.covered) / static_cast<double>(accepted) : 0,
      quantile(figures.drift_errors, 0.5), 1e3 * figures.cpu_seconds / of.recordings);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  const int recordings = count > 1 ? std::max(1, std::atoi(arguments[1])) : 200;
  for (const Case& of : {Case{.seconds = 60, .kicks = true, .recordings = recordings},
                         Case{.seconds = 60, .kicks = false, .recordings = recordings},
                         Case{.seconds = 300, .kicks = true, .recordings = std::max(1, recordings / 5)},
                         Case{.seconds = 3600, .kicks = true, .drift = 30e-6, .recordings = 5}})
    print(of, measure(of));
}
