#include "robot/fit/localisation/localisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include "tests/support/planted_poses.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

TEST(Localisation, Coverage) {
  tests::PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 10; planted.falls_per_minute = 1; planted.penalties_per_minute = 0.7;
  auto& l = planted.models.perception.localisation;
  l.flips_per_minute = 1; planted.models.effects.pose_flips = true; planted.changes_sides = true;
  std::map<std::string, std::array<double,4>> sums;
  const int N = getenv("N") ? atoi(getenv("N")) : 2;
  std::map<std::string, double> truth{{"localisation.start_deviation", l.start_deviation},{"localisation.start_deviation_heading", l.start_deviation_heading},{"localisation.fall_deviation", l.fall_deviation},{"localisation.fall_deviation_heading", l.fall_deviation_heading},{"localisation.flips_per_minute", l.flips_per_minute},{"localisation.flip_duration", l.flip_duration}};
  for (int i = 0; i < N; ++i) {
    PoseErrors poses;
    for (const auto& walk : tests::planted_poses(planted, 5, 3+i)) add_pose_errors(walk, poses);
    const Report report = localisation_report(poses, planted.models);
    if (i == 0) { std::cout << to_text(report); for (auto& k : report.kept) std::cout << k << "\n"; for (auto& k : report.pictures) std::cout << to_text(k) << "\n"; }
    for (auto& f : report.figures) { auto& s = sums[f.name]; s[0] += 1; double t = truth[f.name]; s[1] += f.low <= t && t <= f.high; s[2] += f.value - t; s[3] += f.high - f.low; }
  }
  for (auto& [n, s] : sums) std::cout << n << " cover " << s[1]/s[0] << " bias share " << s[2]/s[3] << " width " << s[3]/s[0] << " of " << s[0] << "\n";
}

TEST(Localisation, Game) {
  const ::tests::TemporaryFolder folder;
  Evidence evidence;
  for (int i = 0; i < 1; ++i)
    tests::append(evidence, tests::simulated_robots(folder.path() / ("game" + std::to_string(i)), {.seconds = 900, .seed = (unsigned)i + 5, .place_error = 0.02, .heading_error = 0.05, .clock_error = 0.01}));
  const auto start = std::chrono::steady_clock::now();
  const Report report = fit_localisation(evidence, tests::match_models());
  const auto end = std::chrono::steady_clock::now();
  std::cout << to_text(report);
  for (auto& k : report.kept) std::cout << k << "\n";
  std::cout << std::chrono::duration<double>(end - start).count() << " s\n";
}

}  // namespace
}  // namespace robot::fit
