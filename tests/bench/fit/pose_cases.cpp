// Figures of odometry and localisation, planted in walks of robots beside a truth with errors.
#include <random>
#include <vector>

#include "robot/fit/localisation/localisation.h"
#include "robot/fit/localisation/odometry.h"
#include "tests/bench/fit/planted.h"
#include "tests/support/planted_poses.h"

namespace bench {
namespace {

/// Returns the walks of one repetition. The clock's error differs from one to the next.
std::vector<robot::fit::WatchedMotion> walks_of(robot::tests::PlantedPoses planted, int repetition) {
  const auto seed = 100 + static_cast<std::uint64_t>(repetition);
  std::mt19937_64 random(seed);
  planted.late = kClockError * std::normal_distribution<double>()(random);
  return robot::tests::planted_poses(planted, 6, seed);
}

}  // namespace

/// Six robots walk for ten minutes each.
void odometry(int repetitions) {
  robot::tests::PlantedPoses walks{.models = robot::tests::match_models()};
  walks.minutes = 10;
  const auto& model = walks.models.perception.localisation;
  Planted planted({{"localisation.bias", model.bias},
                   {"localisation.translation_noise", model.translation_noise},
                   {"localisation.rotation_noise", model.rotation_noise},
                   {"localisation.rotation_per_metre", model.rotation_per_metre}});
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::Drift drift;
    for (const auto& walk : walks_of(walks, i)) robot::fit::add_drift(walk, drift);
    planted.add(robot::fit::odometry_report(drift, walks.models));
  }
  planted.print();
}

/// The same walks with falls, penalties and flips; the base has other marks.
void localisation(int repetitions) {
  const sim::Models base = robot::tests::match_models();
  robot::tests::PlantedPoses walks{.models = base};
  walks.minutes = 10, walks.falls_per_minute = 1, walks.penalties_per_minute = 0.7, walks.changes_sides = true;
  walks.models.effects.pose_flips = true;
  auto& model = walks.models.perception.localisation;
  model.mark_deviation = 0.12f, model.mark_deviation_heading = 0.07f, model.flips_per_minute = 1;
  Planted planted({{"localisation.start_deviation", model.start_deviation},
                   {"localisation.start_deviation_heading", model.start_deviation_heading},
                   {"localisation.fall_deviation", model.fall_deviation},
                   {"localisation.fall_deviation_heading", model.fall_deviation_heading},
                   {"localisation.flips_per_minute", model.flips_per_minute},
                   {"localisation.flip_duration", model.flip_duration},
                   {"localisation.mark_deviation", model.mark_deviation},
                   {"localisation.mark_deviation_heading", model.mark_deviation_heading}});
  for (int i = 0; i < repetitions; ++i) {
    robot::fit::PoseEvidence evidence;
    for (const auto& walk : walks_of(walks, i)) robot::fit::add_poses(walk, evidence);
    planted.add(robot::fit::localisation_report(evidence, base));
  }
  planted.print();
}

}  // namespace bench
