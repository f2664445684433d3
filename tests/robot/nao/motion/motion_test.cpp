// Motion commands become orders. Motions that the body does not have are refused with a sentence.
#include "robot/nao/motion/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tests/support/lola_frame.h"

namespace robot::nao {
namespace {

struct NaoMotion : ::testing::Test {
  NaoMotion() {
    report.has_sensors = true;
    report.mode = Mode::playing;
    report.doing = Doing::standing;
    report.capture_ns = 1'000'000'000;
    report.sensors = tests::standing_sensors();
    report.commanded = report.sensors.position;
  }

  Order next(std::uint64_t age_ns = 0) {
    report.capture_ns += 12'000'000;
    const Order order = motion.next(report, &command, age_ns, nullptr);
    // the guardian obeys
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (order.drives[joint]) report.commanded[joint] = report.sensors.position[joint] = order.position[joint];
    return order;
  }
  pb::MotionStatus status() const {
    pb::MotionStatus status;
    motion.fill_status(report, status);
    return status;
  }
  bool head_active() const { return status().head_active(); }

  Motion motion;
  Report report;
  pb::MotionCommand command;
};

TEST_F(NaoMotion, StandsAndDrivesNothingUntilACommandComes) {
  const Order order = motion.next(report, nullptr, 0, nullptr);
  EXPECT_EQ(order.posture, Order::Posture::stand);
  EXPECT_EQ(order.drives, PerJoint<std::uint8_t>{});
  EXPECT_FALSE(order.game.heard);
}

TEST_F(NaoMotion, TurnsTheHeadAtTheCommandedSpeed) {
  command.mutable_head_angles()->set_yaw(1);
  command.mutable_head_angles()->set_pitch(0.2f);
  Order order = next();
  order = next();
  EXPECT_NEAR(order.position[head_yaw], 2 * Motion::kHeadSpeed * 0.012f, 0.3);
  EXPECT_TRUE(head_active());
  for (int i = 0; i < 200; ++i) order = next();
  EXPECT_NEAR(order.position[head_yaw], 1, 1e-5);
  EXPECT_NEAR(order.position[head_pitch], 0.2, 1e-5);
  EXPECT_EQ(order.drives[l_knee_pitch], 0);
  EXPECT_FALSE(head_active());

  command.mutable_head_angles()->set_yaw(-1);
  command.mutable_head_angles()->set_max_yaw_speed(0.5f);
  const float before = order.position[head_yaw];
  EXPECT_NEAR(next().position[head_yaw], before - 0.5f * 0.012f, 1e-5);
}

TEST_F(NaoMotion, KeepsTheHeadClearOfTheShoulders) {
  command.mutable_head_angles()->set_yaw(5);
  command.mutable_head_angles()->set_pitch(5);
  Order order;
  for (int i = 0; i < 300; ++i) order = next();
  EXPECT_NEAR(order.position[head_yaw], limits_of(head_yaw).range.high, 1e-5);
  EXPECT_NEAR(order.position[head_pitch], head_pitch_range(order.position[head_yaw]).high, 1e-5);
  command.mutable_head_angles()->set_yaw(std::nanf(""));
  EXPECT_NEAR(next().position[head_yaw], limits_of(head_yaw).range.high, 1e-5)
      << "a value that is no number is not obeyed";
}

TEST_F(NaoMotion, LooksAtAPlaceWithTheCameraThatCanSeeIt) {
  const Kinematics kinematics;
  for (const auto& [x, y, camera] : {std::tuple{3.0f, 1.0f, Camera::top}, {0.25f, -0.1f, Camera::bottom}}) {
    command.mutable_look_to()->set_x(x);
    command.mutable_look_to()->set_y(y);
    command.mutable_look_to()->set_z(0.05f);
    for (int i = 0; i < 300; ++i) next();
    const Transform robot_from_camera = kinematics.robot_from_hip(report.sensors.position, 0, 0) *
                                        kinematics.hip_from_camera(report.sensors.position, camera);
    const Eigen::Vector3d seen = robot_from_camera.inverse() * Eigen::Vector3d(x, y, 0.05);
    EXPECT_NEAR(std::atan2(seen.head<2>().norm(), seen.z()), 0, 1e-3) << x;
  }
}

TEST_F(NaoMotion, KeepsTheHeadWhenTheCommandDoesNotMentionIt) {
  command.mutable_head_angles()->set_yaw(0.5f);
  for (int i = 0; i < 100; ++i) next();
  command.clear_head_angles();
  command.set_posture(pb::MotionCommand::POSTURE_STAND);
  EXPECT_NEAR(next().position[head_yaw], 0.5, 1e-5);
}

TEST_F(NaoMotion, TakesPosturesAndKeepsThem) {
  const std::pair<pb::MotionCommand::Posture, Order::Posture> postures[] = {
      {pb::MotionCommand::POSTURE_STAND, Order::Posture::stand},
      {pb::MotionCommand::POSTURE_SIT, Order::Posture::sit},
      {pb::MotionCommand::POSTURE_FREEZE, Order::Posture::freeze},
      {pb::MotionCommand::POSTURE_RELAX, Order::Posture::soft},
      {pb::MotionCommand::POSTURE_GET_UP, Order::Posture::stand}};
  for (const auto& [said, wanted] : postures) {
    command.set_posture(said);
    EXPECT_EQ(next().posture, wanted);
    EXPECT_EQ(motion.refused(), "");
  }
  command.set_posture(pb::MotionCommand::POSTURE_SIT);
  next();
  command.clear_body();
  EXPECT_EQ(next().posture, Order::Posture::sit) << "go on as before";
  EXPECT_EQ(next(2 * Motion::kCommandLasts_ns).posture, Order::Posture::stand) << "the last command is too old";
}

TEST_F(NaoMotion, AWalkingRobotStandsBeforeItSitsOrFreezes) {
  for (const auto& [said, wanted] : {std::pair{pb::MotionCommand::POSTURE_SIT, Order::Posture::sit},
                                     {pb::MotionCommand::POSTURE_FREEZE, Order::Posture::freeze}}) {
    command.mutable_walk_speed()->set_x(0.1f);
    for (int i = 0; i < 150; ++i) next();
    command.set_posture(said);
    EXPECT_EQ(next().posture, Order::Posture::stand);
    EXPECT_TRUE(status().stopping());
    for (int i = 0; i < 125; ++i) next();
    EXPECT_EQ(next().posture, wanted);
  }
  command.mutable_walk_speed()->set_x(0.1f);
  for (int i = 0; i < 150; ++i) next();
  command.set_posture(pb::MotionCommand::POSTURE_RELAX);
  EXPECT_EQ(next().posture, Order::Posture::soft);
}

constexpr Joint kLegs[] = {l_hip_yaw_pitch, l_hip_roll,  l_hip_pitch,  l_knee_pitch,  l_ankle_pitch, l_ankle_roll,
                           r_hip_roll,      r_hip_pitch, r_knee_pitch, r_ankle_pitch, r_ankle_roll};

bool drives_legs(const Order& order) {
  return std::all_of(std::begin(kLegs), std::end(kLegs), [&](Joint joint) { return order.drives[joint] == 1; });
}
bool drives_a_leg(const Order& order) {
  return std::any_of(std::begin(kLegs), std::end(kLegs), [&](Joint joint) { return order.drives[joint] == 1; });
}

TEST_F(NaoMotion, WalksWithinTheRangesOfTheJointsAndSaysSo) {
  command.mutable_walk_speed()->set_x(0.15f);
  for (int i = 0; i < 300; ++i) {
    const Order order = next();
    EXPECT_TRUE(drives_legs(order));
    for (const Joint joint : kLegs) {
      ASSERT_EQ(order.position[joint], clamp(order.position[joint], limits_of(joint).range)) << limits_of(joint).name;
      ASSERT_EQ(order.stiffness[joint], WalkingLegs::kStiffness);
    }
  }
  EXPECT_EQ(motion.refused(), "");
  EXPECT_TRUE(status().walking());
  EXPECT_TRUE(status().body_active());
  EXPECT_FALSE(status().standing());
  EXPECT_FALSE(status().stopping());
  EXPECT_NEAR(status().velocity_x(), 0.15, 1e-3);

  command.mutable_walk_speed()->set_x(0);
  next();
  EXPECT_TRUE(status().stopping());
  for (int i = 0; i < 125; ++i) next();
  EXPECT_FALSE(status().walking());
  EXPECT_TRUE(status().standing());
}

TEST_F(NaoMotion, HasNoOdometryUntilTheFirstWalk) {
  EXPECT_FALSE(motion.has_odometry());
  command.mutable_walk_speed()->set_x(0.1f);
  for (int i = 0; i < 400; ++i) next();
  EXPECT_TRUE(motion.has_odometry());
  pb::Odometry odometry;
  motion.fill_odometry(odometry);
  EXPECT_GT(odometry.x(), 0.1);
}

TEST_F(NaoMotion, LeavesTheLegsToTheGuardianUntilACommandToWalk) {
  command.set_posture(pb::MotionCommand::POSTURE_STAND);
  EXPECT_FALSE(drives_a_leg(next()));
  command.mutable_walk_speed()->set_x(0);
  EXPECT_FALSE(drives_a_leg(next()));
  command.mutable_walk_to()->set_gain(0);
  EXPECT_FALSE(drives_a_leg(next()));
  command.mutable_walk_speed()->set_turn_rate(0.3f);
  EXPECT_TRUE(drives_legs(next()));
}

TEST_F(NaoMotion, ObeysTheParametersOfTheWalk) {
  const auto knee_after_take_over = [&](double hip_height) {
    Motion lower(Kinematics(), {.hip_height = hip_height});
    command.mutable_walk_speed()->set_x(0.1f);
    Order order;
    for (int i = 0; i < 50; ++i) {
      report.capture_ns += 12'000'000;
      order = lower.next(report, &command, 0, nullptr);
    }
    return order.position[l_knee_pitch];
  };
  EXPECT_GT(knee_after_take_over(0.2), knee_after_take_over(0.22) + 0.1f);
}

TEST_F(NaoMotion, GoesToOtherParametersWhileItStandsOrTakesTheLegsOver) {
  const auto knee_after = [&](int cycles) {
    Order order;
    for (int i = 0; i < cycles; ++i) order = next();
    return order.position[l_knee_pitch];
  };
  command.mutable_walk_speed()->set_x(0.1f);
  next();
  motion.change_walk({.hip_height = 0.2});  // in the middle of the take-over
  const float soon = knee_after(49);
  command.mutable_walk_speed()->set_x(0);
  const float low = knee_after(200);
  EXPECT_GT(low, soon + 0.1f);
  motion.change_walk({});
  const float middle = knee_after(20);
  EXPECT_LT(middle, low - 0.02f);
  EXPECT_LT(knee_after(60), middle - 0.05f);
}

TEST_F(NaoMotion, TakesTheLegsOverWithoutAJump) {
  command.mutable_walk_speed()->set_x(0.1f);
  PerJoint<float> last = report.commanded;
  for (int i = 0; i < 50; ++i) {
    const Order order = next();
    for (const Joint joint : kLegs) {
      ASSERT_LT(std::abs(order.position[joint] - last[joint]), limits_of(joint).speed * 0.012f)
          << limits_of(joint).name << " in cycle " << i;
      last[joint] = order.position[joint];
    }
  }
}

TEST_F(NaoMotion, GivesTheLegsBackWhenTheBodyMayNotWalk) {
  command.mutable_walk_speed()->set_x(0.1f);
  for (int i = 0; i < 100; ++i) next();
  EXPECT_TRUE(status().walking());
  report.mode = Mode::penalised;
  EXPECT_FALSE(drives_a_leg(next()));
  EXPECT_FALSE(status().walking());
  report.mode = Mode::playing;
  report.doing = Doing::fallen;
  EXPECT_FALSE(drives_a_leg(next()));
  report.doing = Doing::standing;
  EXPECT_TRUE(drives_legs(next()));
  EXPECT_FALSE(status().walking()) << "the take-over comes first";
}

TEST_F(NaoMotion, StandsWhenTheCommandToWalkIsTooOldOrNoNumber) {
  command.mutable_walk_speed()->set_x(0.1f);
  for (int i = 0; i < 100; ++i) next();
  for (int i = 0; i < 125; ++i) next(2 * Motion::kCommandLasts_ns);
  EXPECT_FALSE(status().walking());
  for (int i = 0; i < 100; ++i) next();
  EXPECT_TRUE(status().walking());
  command.mutable_walk_speed()->set_x(std::nanf(""));
  for (int i = 0; i < 125; ++i) next();
  EXPECT_FALSE(status().walking());
}

TEST_F(NaoMotion, WalksToAPlaceAndStandsThere) {
  command.mutable_walk_to()->set_x(0.5f);
  command.mutable_walk_to()->set_gain(1);
  for (int i = 0; i < 200; ++i) next();
  EXPECT_TRUE(status().walking());
  EXPECT_GT(status().velocity_x(), 0.15);
  command.mutable_walk_to()->set_x(0.01f);
  for (int i = 0; i < 125; ++i) next();
  EXPECT_FALSE(status().walking());
}

TEST_F(NaoMotion, KicksOnceWithAStepOfTheFootNearTheBall) {
  for (const double ball_y : {0.06, -0.06}) {
    command.mutable_walk_speed()->set_x(0.1f);
    for (int i = 0; i < 150; ++i) next();
    pb::Kick& kick = *command.mutable_kick();
    kick.set_type("walk_forward");
    kick.set_in_walk(true);
    kick.set_ball_y(static_cast<float>(ball_y));
    int kicks = 0;
    bool kicking = false;
    for (int i = 0; i < 300; ++i) {
      next();
      const pb::MotionStatus now = status();
      // the running kick ends when its step ends
      if (kicking && now.running().empty()) ++kicks;
      kicking = now.running() == "walk_forward";
      if (!kicking) continue;
      EXPECT_TRUE(now.walking());
    }
    EXPECT_EQ(kicks, 1);
    EXPECT_FALSE(status().walking()) << "then it stands";
  }
}

TEST_F(NaoMotion, WalksToABallThatTheFootDoesNotReachAndKicksItThere) {
  command.mutable_kick()->set_in_walk(true);
  command.mutable_kick()->set_leg(pb::Kick::LEG_RIGHT);
  command.mutable_kick()->set_ball_x(0.3f);
  command.mutable_kick()->set_ball_y(-0.01f);
  pb::Odometry begin, now;
  motion.fill_odometry(begin);
  for (int i = 0; i < 500 && !motion.kicks(); ++i) {
    next();
    motion.fill_odometry(now);
  }
  ASSERT_TRUE(motion.kicks());
  EXPECT_EQ(status().support_foot(), pb::MotionStatus::SUPPORT_FOOT_LEFT);
  const double reach = walk::Parameters{}.kick_reach;
  EXPECT_NEAR(now.x() - begin.x(), 0.3 - reach + 0.025, 0.035) << "the next step of the foot";
  EXPECT_GT(now.y() - begin.y(), 0.005) << "the ball comes before the foot";
}

TEST_F(NaoMotion, KicksAgainWhileABallInReachIsCommandedAndStandsWhenItHasPassedTheBall) {
  command.mutable_kick()->set_in_walk(true);
  command.mutable_kick()->set_ball_x(0.15f);
  command.mutable_kick()->set_ball_y(0.06f);
  int kicks = 0;
  bool kicked = false;
  for (int i = 0; i < 600; ++i) {
    // a behaviour that sees the ball before its feet, with errors
    command.mutable_kick()->set_ball_x(i % 2 == 0 ? 0.15f : 0.14f);
    next();
    kicks += motion.kicks() && !kicked ? 1 : 0;
    kicked = motion.kicks();
  }
  EXPECT_GE(kicks, 3);
  for (int i = 0; i < 600; ++i) next();
  EXPECT_FALSE(status().walking()) << "the last place of the ball lies behind";
}

TEST_F(NaoMotion, AKickThatWaitsInVainIsOverWhenTheCommandToWalkIsNoNumber) {
  command.mutable_kick()->set_in_walk(true);
  command.mutable_kick()->set_ball_x(1);
  command.mutable_kick()->set_ball_y(0.06f);
  for (int i = 0; i < 100; ++i) next();
  EXPECT_TRUE(status().walking()) << "to the ball";
  command.mutable_walk_speed()->set_x(std::nanf(""));
  for (int i = 0; i < 200; ++i) next();
  EXPECT_FALSE(status().walking());
}

TEST_F(NaoMotion, AWarmRobotWithHalfOfItsSpeedKicksToo) {
  report.limited = true;
  command.mutable_kick()->set_in_walk(true);
  command.mutable_kick()->set_ball_x(0.22f);
  command.mutable_kick()->set_ball_y(0.06f);
  for (int i = 0; i < 400 && !motion.kicks(); ++i) next();
  EXPECT_TRUE(motion.kicks());
}

TEST_F(NaoMotion, ABallThatIsNoNumberIsNotKicked) {
  command.mutable_kick()->set_in_walk(true);
  command.mutable_kick()->set_ball_x(std::nanf(""));
  command.mutable_kick()->set_ball_y(0.06f);
  for (int i = 0; i < 300; ++i) {
    next();
    EXPECT_FALSE(motion.kicks());
  }
  EXPECT_FALSE(status().walking());
}

TEST_F(NaoMotion, AKickIsCarriedOutAlthoughTheNextCommandWalksUnlessItStands) {
  for (const bool stands : {false, true}) {
    command.mutable_walk_speed()->set_x(0.1f);
    for (int i = 0; i < 150; ++i) next();
    command.mutable_kick()->set_in_walk(true);
    next();
    if (stands)
      command.set_posture(pb::MotionCommand::POSTURE_STAND);
    else
      command.mutable_walk_to()->set_x(0.3f), command.mutable_walk_to()->set_gain(1);
    int kicking = 0;
    for (int i = 0; i < 80; ++i) {
      next();
      kicking += motion.kicks() ? 1 : 0;
    }
    EXPECT_EQ(kicking > 0, !stands);
    EXPECT_LT(kicking, 40) << "only one step";
  }
}

TEST_F(NaoMotion, RefusesMissingMotionsWithASentence) {
  command.mutable_kick();
  next();
  EXPECT_EQ(motion.refused(), "body nao kicks only with a step of the walk (in_walk): it stands");
  command.mutable_kick()->set_in_walk(true);
  next();
  EXPECT_EQ(motion.refused(), "");
  command.mutable_scripted()->set_name("dance");
  next();
  EXPECT_EQ(motion.refused(), "body nao has no motion 'dance': it stands");
}

TEST_F(NaoMotion, ARobotThatLiesGetsUpUnlessItIsToldToStayDown) {
  for (const Doing down : {Doing::fallen, Doing::getting_up}) {
    report.doing = down;
    command.mutable_walk_speed()->set_x(0.1f);
    EXPECT_EQ(next().posture, Order::Posture::get_up) << "as the body sim does";
    EXPECT_EQ(next(2 * Motion::kCommandLasts_ns).posture, Order::Posture::stand) << "not by an old command";
    command.set_posture(pb::MotionCommand::POSTURE_GET_UP);
    EXPECT_EQ(next().posture, Order::Posture::get_up);
    EXPECT_EQ(motion.refused(), "");
    command.set_posture(pb::MotionCommand::POSTURE_SIT);
    EXPECT_EQ(next().posture, Order::Posture::sit);
    command.set_posture(pb::MotionCommand::POSTURE_RELAX);
    EXPECT_EQ(next().posture, Order::Posture::soft);
  }
}

TEST_F(NaoMotion, SendsTheGameControllersState) {
  pb::GameState game;
  game.set_own_player(2);
  game.set_state(pb::GameState::STATE_SET);
  game.mutable_own()->add_players();
  game.mutable_own()->add_players()->set_penalised(true);
  EXPECT_FALSE(word_of(game).heard) << "no packet yet";
  game.set_received_ns(5);
  const GameWord word = motion.next(report, nullptr, 0, &game).game;
  EXPECT_EQ(word, (GameWord{.heard = 1, .penalised = 1, .state = GameState::set, .player = 2}));
  game.set_own_player(9);
  EXPECT_FALSE(word_of(game).penalised) << "it has no such player";
}

}  // namespace
}  // namespace robot::nao
