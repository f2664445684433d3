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
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "robot/core/clock.h"
#include "robot/lab/clocks/truth_offset.h"
#include "sim/statistics/sample.h"
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
  sim::statistics::Share covered;
  std::uint64_t cpu_ns = 0;  // of all estimates

  void take(const tests::PlantedPlan& plan, const DataOffset& found) {
    const double planted = plan.offset + plan.drift * (found.middle - plan.offset);
    errors.push_back(std::abs(found.offset - planted) * 1e3);
    deviations.push_back(found.deviation * 1e3);
    covered.add(errors.back() <= kTwoSided * deviations.back());
    if (found.drift_deviation > 0) drift_errors.push_back(std::abs(found.drift - plan.drift) * 1e6);
  }
};

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
    const std::uint64_t start_ns = robot::thread_cpu_ns();
    const auto found = find_offset(tests::shared_distance(distances), {.middle = 0, .reach = 60});
    figures.cpu_ns += robot::thread_cpu_ns() - start_ns;
    if (found) figures.take(plan, *found);
  }
  return figures;
}

void print(const Case& of, const Figures& figures) {
  using sim::statistics::median, sim::statistics::quantile;
  const nlohmann::json line{{"seconds", of.seconds},
                            {"kicks", of.kicks},
                            {"drift_ppm", of.drift * 1e6},
                            {"recordings", of.recordings},
                            {"accepted", figures.errors.size()},
                            {"error_median_ms", median(figures.errors)},
                            {"error_p95_ms", quantile(figures.errors, 0.95)},
                            {"deviation_median_ms", median(figures.deviations)},
                            {"coverage", figures.covered.value()},
                            {"drift_error_median_ppm", median(figures.drift_errors)},
                            {"estimate_cpu_ms", static_cast<double>(figures.cpu_ns) / 1e6 / of.recordings}};
  std::puts(line.dump().c_str());
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
