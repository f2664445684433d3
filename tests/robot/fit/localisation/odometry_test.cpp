#include "robot/fit/localisation/odometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include "robot/fit/localisation/odometry_fit.h"
#include "tests/support/planted_poses.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"


namespace robot::fit {
namespace {

TEST(Odometry, Try) {
  tests::PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 10;
  Drift drift;
  for (const auto& walk : tests::planted_poses(planted, 6, 3)) add_drift(walk, drift);
  for (int fold = -1; fold < 6; ++fold) {
    std::vector<DriftWindow> others;
    for (auto& w : drift.windows) if ((int)w.recording % 5 != fold) others.push_back(w);
    auto fit = fit_drift(others, 6);
    auto& m = fit.model;
    std::cout << others.size() << " " << m.bias << " " << m.translation_noise << " " << m.rotation_noise << " " << m.rotation_per_metre << " " << m.place_error << " " << m.heading_error << "\n";
    std::cout << fit.place.deviations[0] << " " << fit.place.deviations[1] << "\n";
    double s=0; for (auto& w : drift.windows) if ((int)w.recording % 5 == fold) s+= std::log(m.place_variance(w));
    std::cout << s << "\n";
  }
}

TEST(Odometry, Game) {
  const ::tests::TemporaryFolder folder;
  Evidence evidence;
  for (int i = 0; i < 2; ++i) {
    auto t = std::chrono::steady_clock::now();
    tests::append(evidence, tests::simulated_robots(folder.path() / ("game" + std::to_string(i)), {.seconds = 600, .seed = (unsigned)i + 5, .place_error = 0.02, .heading_error = 0.05, .clock_error = 0.01}));
    std::cout << std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count() << " s\n";
  }
  const auto start = std::chrono::steady_clock::now();
  const Report report = fit_odometry(evidence, tests::match_models());
  const auto end = std::chrono::steady_clock::now();
  std::cout << to_text(report);
  for (auto& k : report.kept) std::cout << k << "\n";
  std::cout << std::chrono::duration<double>(end - start).count() << " s\n";
}

TEST(Odometry, Coverage) {
  tests::PlantedPoses planted{.models = tests::match_models()};
  planted.minutes = 10;
  std::map<std::string, std::array<double,4>> sums;
  const int N = getenv("N") ? atoi(getenv("N")) : 20;
  const auto& l = planted.models.perception.localisation;
  std::map<std::string, double> truth{{"localisation.translation_noise", l.translation_noise},{"localisation.rotation_noise", l.rotation_noise},{"localisation.rotation_per_metre", l.rotation_per_metre},{"localisation.bias", l.bias}};
  for (int i = 0; i < N; ++i) {
  Drift drift;
  for (const auto& walk : tests::planted_poses(planted, 6, 3+i)) add_drift(walk, drift);
  const Report report = odometry_report(drift, planted.models);
  for (auto& f : report.figures) { auto& s = sums[f.name]; s[0] += 1; double t = truth[f.name]; s[1] += f.low <= t && t <= f.high; s[2] += f.value - t; s[3] += f.high - f.low; }
  }
  for (auto& [n, s] : sums) std::cout << n << " cover " << s[1]/s[0] << " bias share " << s[2]/s[3] << " width " << s[3]/s[0] << "\n";
}

}  // namespace
}  // namespace robot::fit
