#include "robot/nao/walk/walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "robot/nao/walk/named_parameters.h"
#include "tests/sim/support/allocations.h"

namespace robot::nao::walk {
namespace {

constexpr double kFrame = 0.012;  // [s] LoLA

/// A robot whose joints obey at once and which never tips. A foot carries half of the weight while it is on the ground.
class IdealRobot {
 public:
  explicit IdealRobot(const Walk& walk) : walk_(walk) {}

  Sensors sense(const Legs& targets, double roll = 0, double pitch = 0) const {
    Sensors sensors{.roll = roll, .pitch = pitch, .joints = targets};
    const double low = std::min(height(targets, left), height(targets, right));
    for (const Side side : {left, right})
      if (height(targets, side) < low + 0.001) sensors.load[side].fill(0.65);
    if (walk_.steps()) sensors.rate[2] = walk_.speed().turn;
    return sensors;
  }

 private:
  static double height(const Legs& legs, Side side) { return sole_of(legs[side], side).z; }

  const Walk& walk_;
};

/// Walks for `seconds`. Returns the targets of all ticks.
std::vector<Legs> play(Walk& walk, const Command& command, double seconds, double roll = 0, double pitch = 0) {
  const IdealRobot robot(walk);
  std::vector<Legs> all;
  Legs targets = all.empty() ? Legs{} : all.back();
  for (double time = 0; time < seconds; time += kFrame) {
    targets = walk.tick(robot.sense(targets, roll, pitch), command, kFrame);
    all.push_back(targets);
  }
  return all;
}

/// Returns arbitrary sensors of a robot that shakes.
Sensors drawn(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Sensors sensors;
  for (double& rate : sensors.rate) rate = between(-2, 2);
  sensors.roll = between(-0.3, 0.3), sensors.pitch = between(-0.3, 0.3);
  for (auto& foot : sensors.load)
    for (double& load : foot) load = between(0, 2);
  for (auto& leg : sensors.joints)
    for (double& angle : leg) angle = between(-0.5, 0.8);
  return sensors;
}

Command drawn_command(std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  Command command{.forward = 0.25 * part(random), .left = 0.15 * part(random), .turn = part(random)};
  if (part(random) > 0.9) command.kick = static_cast<KickStep>(1 + random() % 3);
  command.foot = random() % 2 == 0 ? left : right;
  return command;
}

Command mirrored(const Command& command) {
  return {command.forward, -command.left, -command.turn, command.kick, other(command.foot)};
}

Sensors mirrored(const Sensors& sensors) {
  Sensors image;
  image.rate = {-sensors.rate[0], sensors.rate[1], -sensors.rate[2]};
  image.roll = -sensors.roll, image.pitch = sensors.pitch;
  for (const Side side : {left, right}) {
    const auto& load = sensors.load[other(side)];
    image.load[side] = {load[1], load[0], load[3], load[2]};
    image.joints[side] = sensors.joints[other(side)];
    image.joints[side][hip_roll] *= -1, image.joints[side][ankle_roll] *= -1;
  }
  return image;
}

TEST(Walk, StandsStillWithoutACommand) {
  Walk walk;
  const auto all = play(walk, {}, 2);
  EXPECT_FALSE(walk.steps());
  EXPECT_EQ(all.front(), all.back());
}

TEST(Walk, StepsInTurnsAndReachesTheCommandedSpeed) {
  Walk walk;
  const Command command{.forward = 0.2};
  play(walk, command, 4);
  EXPECT_TRUE(walk.steps());
  EXPECT_GT(walk.count(), 10);
  EXPECT_NEAR(walk.speed().forward, 0.2, 1e-9);
  EXPECT_NEAR(walk.speed().left, 0, 1e-9);
}

TEST(Walk, MovesTheSupportFootBackWithTheGround) {
  // the way of the support foot against the torso is the way of the torso over ground
  Walk walk;
  const IdealRobot robot(walk);
  Legs targets{};
  double way = 0;
  double time = 0;
  for (; time < 10; time += kFrame) {
    const Side support = other(walk.swing());
    const Legs last = targets;
    targets = walk.tick(robot.sense(targets), {.forward = 0.15}, kFrame);
    if (time > 5 && other(walk.swing()) == support)
      way += sole_of(last[support], support).x - sole_of(targets[support], support).x;
  }
  // these legs do not fall short
  EXPECT_NEAR(way / 5, 0.15 * (1 + Parameters{}.longer), 0.03);
}

TEST(Walk, StandsWithinASecondAndAHalfAfterACommandOfZero) {
  for (const Command& command :
       {Command{.forward = 0.2}, Command{.left = 0.1}, Command{.turn = 0.8}, Command{.forward = -0.1}}) {
    Walk walk;
    play(walk, command, 4);
    ASSERT_TRUE(walk.steps());
    play(walk, {}, 1.5);
    EXPECT_FALSE(walk.steps());
  }
}

TEST(Walk, ALiftedRobotStandsStillUntilItIsPutDown) {
  Walk walk;
  play(walk, {.forward = 0.2}, 3);
  ASSERT_TRUE(walk.steps());
  Sensors lifted;
  for (int i = 0; i < 100; ++i) {
    lifted.pitch = 0.2, lifted.joints = walk.tick(lifted, {.forward = 0.2}, kFrame);
    if (i > 30) {
      ASSERT_FALSE(walk.steps()) << "tick " << i;
    }
  }
  play(walk, {.forward = 0.2}, 1);
  EXPECT_TRUE(walk.steps());
}

TEST(Walk, AStandingRobotThatTipsSteps) {
  for (const double pitch : {0.2, -0.25}) {
    Walk walk;
    play(walk, {}, 2);
    play(walk, {}, 0.1, 0, pitch);
    EXPECT_TRUE(walk.steps());
  }
}

TEST(Walk, ARobotThatTipsToOneSideStepsWithThatFoot) {
  for (const Side side : {left, right}) {
    Walk walk;
    play(walk, {}, 2);
    play(walk, {}, 2 * kFrame, -0.25 * sign_of(side), 0);
    ASSERT_TRUE(walk.steps());
    EXPECT_EQ(walk.swing(), side);
  }
}

TEST(Walk, TheSwingFootFollowsAFall) {
  Walk walk;
  play(walk, {.forward = 0.1}, 3);
  const auto worst = [&](double pitch) {
    const IdealRobot robot(walk);
    Legs targets = walk.tick(robot.sense({}, 0, 0), {.forward = 0.1}, kFrame);
    double shift = 0;
    for (int i = 0; i < 15; ++i) {
      targets = walk.tick(robot.sense(targets, 0, pitch), {.forward = 0.1}, kFrame);
      if (std::abs(walk.caught().forward) > std::abs(shift)) shift = walk.caught().forward;
    }
    return shift;
  };
  EXPECT_GT(worst(0.3), 0.01);
  EXPECT_LT(worst(-0.3), -0.01);
}

TEST(Walk, KicksWithTheNextStepOfThatFootAndOnlyOnceAStep) {
  for (const KickStep kick : {KickStep::forward, KickStep::side, KickStep::turn})
    for (const Side foot : {left, right}) {
      Walk walk;
      const IdealRobot robot(walk);
      Legs targets = play(walk, {.forward = 0.1}, 2).back();
      Command command{.forward = 0.1, .kick = kick, .foot = foot};
      double ahead = 0, out = 0, before_ahead = 0, before_out = 0;
      bool kicked = false;
      for (int i = 0; i < 120; ++i) {
        targets = walk.tick(robot.sense(targets), command, kFrame);
        const Point sole = sole_of(targets[foot], foot);
        if (walk.kick() != KickStep::none) {
          EXPECT_EQ(walk.kick(), kick);
          EXPECT_EQ(walk.swing(), foot);
          kicked = true, command.kick = KickStep::none;
          ahead = std::max(ahead, sole.x), out = std::max(out, sign_of(foot) * sole.y);
        } else if (!kicked) {
          before_ahead = std::max(before_ahead, sole.x), before_out = std::max(before_out, sign_of(foot) * sole.y);
        }
      }
      EXPECT_TRUE(kicked);
      EXPECT_EQ(walk.kick(), KickStep::none);
      if (kick == KickStep::forward) {
        EXPECT_GT(ahead, before_ahead + 0.03);
      }
      if (kick == KickStep::side) {
        EXPECT_GT(out, before_out + 0.03);
      }
    }
}

TEST(Walk, MirroredInputsGiveMirroredLegs) {
  std::mt19937 random(5);
  Walk walk, image;
  for (int i = 0; i < 3000; ++i) {
    Sensors sensors = drawn(random);
    if (i == 0) sensors.roll = 0.25, sensors.rate[0] = 0;  // it decides which foot is first
    const Command command = i % 200 < 150 ? drawn_command(random) : Command{};
    const Legs legs = walk.tick(sensors, command, kFrame);
    const Legs mirror = image.tick(mirrored(sensors), mirrored(command), kFrame);
    for (const Side side : {left, right})
      for (const LegJoint joint : {hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll}) {
        const double sign = joint == hip_roll || joint == ankle_roll ? -1 : 1;
        ASSERT_NEAR(mirror[side][joint], sign * legs[other(side)][joint], 1e-9) << "tick " << i << ", joint " << joint;
      }
  }
}

TEST(Walk, TheSameInputsGiveTheSameLegs) {
  std::mt19937 random(6), again(6);
  Walk first, second;
  for (int i = 0; i < 1000; ++i) {
    const Legs legs = first.tick(drawn(random), drawn_command(random), kFrame);
    ASSERT_EQ(second.tick(drawn(again), drawn_command(again), kFrame), legs) << "tick " << i;
  }
}

TEST(Walk, GoesToOtherParametersWithoutAJump) {
  Parameters other;
  for (const NamedParameter& named : kNamedParameters) other.*named.place *= 1.1;
  for (const double speed : {0.0, 0.15}) {
    Walk walk, usual;
    play(walk, {.forward = speed}, 2);
    play(usual, {.forward = speed}, 2);
    walk.change(other);
    const Legs first = play(walk, {.forward = speed}, kFrame).back(),
               same = play(usual, {.forward = speed}, kFrame).back();
    for (const Side side : {left, right})
      for (std::size_t joint = 0; joint < kLegJoints; ++joint)
        EXPECT_NEAR(first[side][joint], same[side][joint], 0.02) << "at " << speed << " m/s, joint " << joint;
    play(walk, {.forward = speed}, 0.5);
    for (const NamedParameter& named : kNamedParameters)
      EXPECT_EQ(walk.parameters().*named.place, other.*named.place) << named.name;
  }
}

TEST(Walk, StandsAsIfItHadBegunWithItsParameters) {
  const Parameters lower{.hip_height = 0.2};
  Walk walk;
  play(walk, {}, 0.1);
  walk.change({.hip_height = 0.25});
  play(walk, {}, 0.2);
  walk.change(lower);  // before it has reached the others
  EXPECT_EQ(play(walk, {}, 1).back(), play(*std::make_unique<Walk>(lower), {}, 1).back());
}

TEST(Walk, AChangeToTheSameParametersChangesNothing) {
  std::mt19937 random(9), again(9);
  Walk changed, untouched;
  for (int i = 0; i < 500; ++i) {
    if (i % 10 == 0) changed.change({});
    ASSERT_EQ(changed.tick(drawn(random), drawn_command(random), kFrame),
              untouched.tick(drawn(again), drawn_command(again), kFrame));
  }
}

TEST(Walk, TheNamedParametersSayWhatTheirHeaderSays) {
  std::ifstream header(FORESIGHT_WALK_PARAMETERS);
  ASSERT_TRUE(header);
  std::vector<std::string> written, named;
  const std::regex line(R"( *double (\w+) = [\d.]+; *// \[(.*?)\] (.*))");
  std::smatch parts;
  for (std::string text; std::getline(header, text);)
    if (std::regex_match(text, parts, line)) written.push_back(parts.format("$1 [$2] $3"));
  for (const NamedParameter& one : kNamedParameters)
    named.push_back(std::string(one.name) + " [" + std::string(one.unit) + "] " + std::string(one.meaning));
  EXPECT_EQ(named, written);
}

TEST(Walk, AllLegsAreFiniteWhateverTheSensorsSay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> extreme(-1e6, 1e6);
  Walk walk;
  for (int i = 0; i < 5000; ++i) {
    Sensors sensors = drawn(random);
    if (i % 3 == 0) sensors.rate[1] = extreme(random), sensors.roll = extreme(random);
    if (i % 5 == 0) sensors.load = {};
    for (const auto& leg : walk.tick(sensors, drawn_command(random), i % 7 == 0 ? 0.1 : kFrame))
      for (const double angle : leg) ASSERT_TRUE(std::isfinite(angle)) << "tick " << i;
  }
}

TEST(Walk, AllLegsAreFiniteWhateverTheParametersSay) {
  std::mt19937 random(10);
  Walk walk;
  for (int i = 0; i < 20000; ++i) {
    if (i % 50 == 0) {
      Parameters parameters;
      for (const NamedParameter& named : kNamedParameters) {
        const auto [low, high] = range_of(named.place);
        parameters.*named.place = std::uniform_real_distribution<double>(low, high)(random);
      }
      walk.change(parameters);
    }
    for (const auto& leg : walk.tick(drawn(random), drawn_command(random), kFrame))
      for (const double angle : leg) ASSERT_TRUE(std::isfinite(angle)) << "tick " << i;
  }
}

TEST(Walk, AllocatesNothing) {
  std::mt19937 random(8);
  std::vector<Sensors> frames;
  for (int i = 0; i < 500; ++i) frames.push_back(drawn(random));
  Walk walk;
  const std::size_t before = sim::test::allocations();
  for (const Sensors& frame : frames) {
    if (&frame == &frames[250]) walk.change({.lift = 0.03});
    walk.tick(frame, {.forward = 0.2}, kFrame);
  }
  EXPECT_EQ(sim::test::allocations() - before, 0u);
}

}  // namespace
}  // namespace robot::nao::walk
