#include "tests/walk/trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/walk/our_gait.h"

// Short trials: the bars are those of `scripts/bench walk`.
namespace robot::nao::walk {
namespace {

constexpr double kHip = Parameters{}.hip_height;

Outcome walked(Servos servos, std::uint64_t seed, const Plan& plan) {
  Physics physics({.ball = plan.with_ball});
  OurGait gait;
  return run(physics, gait, draw_robot(seed, servos), seed, stand(), kHip, plan);
}

/// A robot whose legs do not move.
class Statue final : public Gait {
 public:
  Legs tick(const Sensors&, const Command&, double) override { return stand(); }
  bool steps() const override { return false; }
};

TEST(Trial, RobotsOfBothClassesWalkWithoutAFall) {
  for (const Servos servos : {Servos::stiff, Servos::soft}) {
    const Outcome outcome =
        walked(servos, 1, {.duration = 10, .command = [](double) { return Command{.forward = 0.2}; }});
    EXPECT_FALSE(outcome.failed());
    EXPECT_GT(outcome.forward / outcome.measured, 0.12);
    EXPECT_NEAR(outcome.measured, 8, 0.3);
  }
}

TEST(Trial, AStandingRobotThatIsPushedStepsAndStaysUp) {
  for (const Servos servos : {Servos::stiff, Servos::soft})
    for (int direction = 0; direction < 4; ++direction) {
      const Outcome outcome = walked(servos, 2,
                                     {.duration = 5,
                                      .command = [](double) { return Command{}; },
                                      .pushes = {{1, 1.2, direction * std::numbers::pi / 2}}});
      EXPECT_FALSE(outcome.fell) << "direction " << direction;
      EXPECT_LT(outcome.last_step, 5) << "direction " << direction;
    }
}

TEST(Trial, APushThatNobodyStandsMakesItFallInItsDirection) {
  for (const double direction : {0.0, std::numbers::pi / 2, std::numbers::pi, -std::numbers::pi / 2}) {
    const Outcome outcome = walked(
        Servos::stiff, 3, {.duration = 5, .command = [](double) { return Command{}; }, .pushes = {{1, 8, direction}}});
    EXPECT_TRUE(outcome.fell);
    EXPECT_LT(outcome.time, 4);
    EXPECT_NEAR(std::remainder(outcome.direction - direction, 2 * std::numbers::pi), 0, 0.6);
  }
}

TEST(Trial, ARobotThatDoesNotObeyHasFailedAfterTenSeconds) {
  Physics physics({});
  Statue statue;
  const Outcome outcome = run(physics, statue, draw_robot(4, Servos::stiff), 4, stand(), kHip,
                              {.duration = 14, .command = [](double) { return Command{.forward = 0.2}; }});
  EXPECT_FALSE(outcome.fell);
  EXPECT_GT(outcome.slow, 10);
  EXPECT_TRUE(outcome.failed());
}

TEST(Trial, TheWorldsAxesDoNotMatter) {
  // displacements are along the body: a turning robot that walks ahead has walked ahead
  const Outcome outcome = walked(
      Servos::soft, 6, {.duration = 10, .command = [](double) { return Command{.forward = 0.15, .turn = 0.5}; }});
  EXPECT_FALSE(outcome.fell);
  EXPECT_GT(outcome.forward / outcome.measured, 0.08);
  EXPECT_LT(std::abs(outcome.left / outcome.measured), 0.05);
  EXPECT_GT(outcome.turned / outcome.measured, 0.3);
}

}  // namespace
}  // namespace robot::nao::walk
