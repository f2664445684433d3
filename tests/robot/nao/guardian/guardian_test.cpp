// The rules of the guardian, with the runtime alive, hung and dead.
#include "robot/nao/guardian/guardian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "tests/support/fake_body.h"

namespace robot::nao {
namespace {

struct NaoGuardian : ::testing::Test {
  tests::FakeBody body;
  Guardian guardian;
  Order order;
  bool alive = true;  // the runtime sends its order in every cycle
  std::uint64_t now_ns = 1'000'000'000;

  const Actuators& cycle(Cycle extra = {}) {
    extra.now_ns = now_ns += tests::kCycle_ns;
    extra.sensors = &body.sensors;
    if (alive) extra.order = &order;
    const Actuators& answer = guardian.step(extra);
    body.obey(answer, 0.012f);
    return answer;
  }
  void run(double seconds) {
    for (double passed = 0; passed < seconds; passed += 0.012) cycle();
  }
  /// Runs cycles until `doing`, at most ten seconds.
  void until(Doing doing) {
    for (int i = 0; i < 833 && guardian.doing() != doing; ++i) cycle();
    ASSERT_EQ(guardian.doing(), doing) << sentence_of(guardian.reason());
  }
  void click() {
    body.press_chest(true);
    run(0.1);
    body.press_chest(false);
    run(0.03);
  }
  void hear(bool penalised, GameState state) {
    order.game = {.heard = true, .penalised = penalised, .state = state, .player = 2};
    run(0.03);
  }
  /// Brings the robot to stand in the mode `playing`, with a runtime.
  void play() {
    cycle();
    click();
    click();
    click();
    until(Doing::standing);
    ASSERT_EQ(guardian.mode(), Mode::playing);
  }
  bool has_stiffness() const {
    for (const float stiffness : body.sensors.stiffness)
      if (stiffness != 0) return true;
    return false;
  }
  float knee() const { return body.sensors.position[l_knee_pitch]; }
  bool seated() const { return std::abs(knee() - sit()[0].position[l_knee_pitch]) < 0.05f && !has_stiffness(); }
  bool stands() const { return std::abs(knee() - stand()[0].position[l_knee_pitch]) < 0.05f && has_stiffness(); }
};

TEST_F(NaoGuardian, IsSoftUntilTheChestButtonIsPressed) {
  run(5);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.reason(), Reason::waits_for_button);
  hear(false, GameState::playing);
  run(5);
  EXPECT_FALSE(has_stiffness()) << "the GameController does not stiffen it";
  EXPECT_EQ(guardian.mode(), Mode::unstiff);
}

TEST_F(NaoGuardian, FollowsTheChestButton) {
  cycle();
  for (const Mode mode : {Mode::initial, Mode::penalised, Mode::playing, Mode::penalised, Mode::playing}) {
    click();
    EXPECT_EQ(guardian.mode(), mode);
  }
  until(Doing::standing);
  EXPECT_TRUE(stands());
}

TEST_F(NaoGuardian, StandsInInitialAndPenalisedAndIgnoresOrders) {
  cycle();
  click();
  order.drives.fill(1);
  order.position.fill(0.3f);
  order.stiffness.fill(1);
  order.posture = Order::Posture::sit;
  until(Doing::standing);
  run(1);
  EXPECT_TRUE(stands());
  EXPECT_NEAR(body.sensors.position[head_yaw], 0, 1e-3);
  click();
  EXPECT_EQ(guardian.mode(), Mode::penalised);
  run(1);
  EXPECT_NEAR(body.sensors.position[head_yaw], 0, 1e-3);
}

TEST_F(NaoGuardian, LetsTheRuntimeDriveJointsWhilePlaying) {
  play();
  order.drives[head_yaw] = order.drives[head_pitch] = 1;
  order.position[head_yaw] = 1;
  order.position[head_pitch] = 0.2f;
  order.position[l_knee_pitch] = 2;  // not driven
  order.stiffness.fill(0.6f);
  run(1);
  EXPECT_NEAR(body.sensors.position[head_yaw], 1, 1e-3);
  EXPECT_NEAR(body.sensors.position[head_pitch], 0.2, 1e-3);
  EXPECT_NEAR(body.sensors.stiffness[head_yaw], 0.6, 1e-3);
  EXPECT_TRUE(stands());
  // penalised: back to the stand, then still
  hear(true, GameState::playing);
  until(Doing::standing);
  EXPECT_NEAR(body.sensors.position[head_yaw], 0, 0.05);
}

TEST_F(NaoGuardian, TakesPosturesFromTheRuntimeWhilePlaying) {
  play();
  order.posture = Order::Posture::sit;
  until(Doing::soft);
  EXPECT_TRUE(seated());
  order.posture = Order::Posture::stand;
  until(Doing::standing);
  order.posture = Order::Posture::freeze;
  until(Doing::holding);
  run(1);
  EXPECT_TRUE(stands());
  order.posture = Order::Posture::soft;
  run(0.03);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.mode(), Mode::playing);
  order.posture = static_cast<Order::Posture>(99);
  run(1);
  EXPECT_FALSE(has_stiffness()) << "an unknown order is not obeyed";
}

TEST_F(NaoGuardian, FollowsTheGameControllerWhenItsStateChanges) {
  play();
  hear(true, GameState::playing);
  EXPECT_EQ(guardian.mode(), Mode::penalised);
  click();
  EXPECT_EQ(guardian.mode(), Mode::playing) << "a person may change it";
  run(1);
  EXPECT_EQ(guardian.mode(), Mode::playing);
  hear(true, GameState::set);
  EXPECT_EQ(guardian.mode(), Mode::penalised);
  hear(false, GameState::initial);
  EXPECT_EQ(guardian.mode(), Mode::initial);
  hear(false, GameState::ready);
  EXPECT_EQ(guardian.mode(), Mode::playing);
}

TEST_F(NaoGuardian, FollowsTheGameControllerWhenTheRobotIsSwitchedOn) {
  hear(true, GameState::playing);
  click();
  EXPECT_EQ(guardian.mode(), Mode::penalised);
}

TEST_F(NaoGuardian, DoesNotBeginWithoutARuntime) {
  alive = false;
  cycle();
  click();
  EXPECT_EQ(guardian.mode(), Mode::unstiff);
  alive = true;
  run(5);
  EXPECT_FALSE(has_stiffness()) << "it does not stand up by itself when one comes";
}

/// State of the runtime during an event.
enum class Runtime { alive, hung, dead };

struct NaoGuardianWith : NaoGuardian, ::testing::WithParamInterface<Runtime> {
  /// Sets the state of the runtime to the test's parameter.
  void befall() {
    if (GetParam() == Runtime::alive) return;
    alive = false;
    if (GetParam() == Runtime::dead) cycle({.runtime_crashed = true});
  }
};

TEST_P(NaoGuardianWith, TheHeadHeldTakesTheStiffnessWithin100ms) {
  for (const bool standing : {true, false}) {
    play();
    if (!standing) order.posture = Order::Posture::sit;
    run(0.5);
    befall();
    ASSERT_TRUE(has_stiffness());
    body.hold_head(true);
    run(0.09);
    EXPECT_FALSE(has_stiffness());
    EXPECT_EQ(guardian.mode(), Mode::unstiff);
    body.hold_head(false);
    run(20);
    EXPECT_FALSE(has_stiffness()) << "and it stays soft";
    EXPECT_EQ(guardian.reason(), Reason::head_touched);
    // restores the start for the next round
    alive = true;
    order = {};
    cycle();
  }
}

TEST_P(NaoGuardianWith, SitAndSoftTakesTheStiffnessAtOnce) {
  play();
  befall();
  cycle({.asked_soft = true});
  EXPECT_FALSE(has_stiffness());
  run(10);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.reason(), Reason::asked_soft);
  alive = true;
  run(5);
  EXPECT_FALSE(has_stiffness()) << "until the chest button is pressed";
  click();
  until(Doing::standing);
}

TEST_P(NaoGuardianWith, AFallTucksAndSoftens) {
  play();
  befall();
  body.fall();
  until(Doing::falling);
  ASSERT_TRUE(guardian.fell());
  EXPECT_GT((*guardian.fell())[1], 0.4f);
  EXPECT_LT(body.sensors.angles[1], 0.8f) << "before it hits the ground";
  run(0.5);
  for (const float stiffness : body.sensors.stiffness) EXPECT_LE(stiffness, 0.31f);
  until(Doing::fallen);
  EXPECT_FALSE(has_stiffness());
  run(20);
  EXPECT_FALSE(has_stiffness()) << "as long as it lies";
  EXPECT_EQ(guardian.reason(), Reason::fell);
}

TEST_P(NaoGuardianWith, HeatSitsItDown) {
  play();
  befall();
  body.sensors.temperature[l_hip_pitch] = 80;
  until(Doing::soft);
  EXPECT_TRUE(seated());
  run(10);
  EXPECT_FALSE(has_stiffness());
}

TEST_P(NaoGuardianWith, AnEmptyBatterySitsItDown) {
  play();
  befall();
  body.sensors.battery[0] = 0.02f;
  until(Doing::soft);
  EXPECT_TRUE(seated());
  run(10);
  EXPECT_FALSE(has_stiffness());
}

TEST_P(NaoGuardianWith, ItSitsBeforeTheGuardianEnds) {
  play();
  befall();
  for (int i = 0; i < 400 && !guardian.soft(); ++i) cycle({.stop = true});
  EXPECT_TRUE(guardian.soft());
  EXPECT_TRUE(seated());
}

INSTANTIATE_TEST_SUITE_P(
    Runtime, NaoGuardianWith, ::testing::Values(Runtime::alive, Runtime::hung, Runtime::dead), [](const auto& tested) {
      return std::string(tested.param == Runtime::alive ? "Alive" : tested.param == Runtime::hung ? "Hung" : "Dead");
    });

TEST_F(NaoGuardian, WithoutOrdersHoldsThenSitsThenIsSoft) {
  for (const bool dead : {false, true}) {
    play();
    order.drives[head_yaw] = order.drives[head_pitch] = 1;
    order.position[head_yaw] = 1;
    order.stiffness.fill(1);
    run(1);
    alive = false;
    cycle({.runtime_crashed = dead});
    run(0.15);
    EXPECT_EQ(guardian.doing(), Doing::holding);
    EXPECT_EQ(guardian.reason(), dead ? Reason::runtime_gone : Reason::runtime_late);
    const float yaw = body.sensors.position[head_yaw];
    run(2.5);
    EXPECT_EQ(guardian.doing(), Doing::holding);
    EXPECT_EQ(body.sensors.position[head_yaw], yaw);
    until(Doing::sitting_down);
    until(Doing::soft);
    EXPECT_TRUE(seated());
    run(20);
    EXPECT_FALSE(has_stiffness());
    alive = true;
    order = {};
    cycle({.asked_soft = true});
  }
}

TEST_F(NaoGuardian, ARobotWhoseLegsWereDrivenStandsFirst) {
  for (const bool dead : {false, true}) {
    play();
    // in the middle of a step
    for (const auto& [joint, position] :
         {std::pair{l_hip_pitch, -0.7f}, {l_knee_pitch, 1.2f}, {l_ankle_pitch, -0.5f}}) {
      order.drives[joint] = 1;
      order.position[joint] = position;
    }
    order.stiffness.fill(0.9f);
    run(0.5);
    EXPECT_NEAR(knee(), 1.2, 0.01);
    alive = false;
    cycle({.runtime_crashed = dead});
    run(0.15);
    EXPECT_EQ(guardian.doing(), Doing::standing_up);
    EXPECT_EQ(guardian.reason(), dead ? Reason::runtime_gone : Reason::runtime_late);
    run(1.3);
    EXPECT_EQ(guardian.doing(), Doing::holding);
    EXPECT_TRUE(stands());
    until(Doing::sitting_down);
    until(Doing::soft);
    EXPECT_TRUE(seated());
    alive = true;
    order = {};
    cycle({.asked_soft = true});
  }
}

TEST_F(NaoGuardian, TheHeadHeldSoftensAWalkingRobotWithin100ms) {
  play();
  for (std::size_t joint = l_hip_yaw_pitch; joint <= r_ankle_roll; ++joint) order.drives[joint] = 1;
  order.position = body.sensors.position;
  order.stiffness.fill(0.9f);
  run(0.5);
  body.hold_head(true);
  run(0.1);
  EXPECT_FALSE(has_stiffness());
}

TEST_F(NaoGuardian, GoesOnWhenALateRuntimeSpeaksAgain) {
  play();
  order.drives[head_yaw] = order.drives[head_pitch] = 1;
  order.position[head_yaw] = 1;
  order.stiffness.fill(1);
  run(1);
  alive = false;
  run(1);
  ASSERT_EQ(guardian.doing(), Doing::holding);
  alive = true;
  cycle();
  EXPECT_EQ(guardian.doing(), Doing::standing);
  EXPECT_EQ(guardian.mode(), Mode::playing);
  EXPECT_NEAR(body.sensors.position[head_yaw], 1, 1e-3) << "the same as before the event";
}

TEST_F(NaoGuardian, AfterARestartOfTheRuntimeWaitsForTheGameController) {
  play();
  hear(false, GameState::playing);
  order.drives[head_yaw] = order.drives[head_pitch] = 1;
  order.position[head_yaw] = 1;
  order.stiffness.fill(1);
  order.game = {};
  cycle({.runtime_crashed = true});
  const float yaw = body.sensors.position[head_yaw];
  run(10);
  EXPECT_EQ(guardian.reason(), Reason::waits_for_game);
  EXPECT_EQ(body.sensors.position[head_yaw], yaw) << "it does not move before that";
  hear(true, GameState::playing);
  EXPECT_EQ(guardian.mode(), Mode::penalised);
  run(2);
  EXPECT_NEAR(body.sensors.position[head_yaw], 0, 0.05);
  hear(false, GameState::playing);
  run(3);
  EXPECT_NEAR(body.sensors.position[head_yaw], 1, 0.01) << "and continues to play when that reports it";
}

TEST_F(NaoGuardian, AfterARestartTheChestButtonAllowsMotionToo) {
  play();
  cycle({.runtime_left = true});
  run(1);
  EXPECT_EQ(guardian.reason(), Reason::waits_for_game);
  click();
  EXPECT_EQ(guardian.mode(), Mode::penalised);
  EXPECT_EQ(guardian.reason(), Reason::none);
}

TEST_F(NaoGuardian, ThreeCrashesInAMinuteEndSeatedWithRedEyes) {
  play();
  for (int i = 0; i < 2; ++i) {
    cycle({.runtime_crashed = true});
    run(10);
    EXPECT_NE(guardian.reason(), Reason::crashed);
  }
  cycle({.runtime_crashed = true});
  until(Doing::soft);
  EXPECT_TRUE(seated());
  hear(false, GameState::playing);
  run(30);
  EXPECT_TRUE(seated());
  EXPECT_EQ(guardian.reason(), Reason::crashed);
  EXPECT_EQ(cycle().lights.l_eye, (Colour{1, 0, 0}));
  click();
  run(1);
  EXPECT_TRUE(seated()) << "the first click only acknowledges the crash";
  EXPECT_NE(cycle().lights.l_eye, (Colour{1, 0, 0}));
  click();
  until(Doing::standing);
}

TEST_F(NaoGuardian, CrashesFarApartAreForgiven) {
  play();
  for (int i = 0; i < 5; ++i) {
    cycle({.runtime_crashed = true});
    run(31);
  }
  EXPECT_NE(guardian.reason(), Reason::crashed);
}

TEST_F(NaoGuardian, StandsUpOnlyUpright) {
  cycle();
  body.sensors.angles[0] = 0.5f;
  click();
  run(10);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.reason(), Reason::not_upright);
  body.put_upright();
  until(Doing::standing);
}

TEST_F(NaoGuardian, StretchesItsLegsOnlyWithWeightOnItsFeet) {
  cycle();
  body.lift();
  click();
  float straightest = 3;
  for (int i = 0; i < 800; ++i) {
    cycle();
    straightest = std::min(straightest, knee());
  }
  EXPECT_GT(straightest, 1.9f);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.reason(), Reason::feet_unloaded);
  body.put_down();
  until(Doing::standing);
}

TEST_F(NaoGuardian, StiffnessIsRamped) {
  cycle();
  click();
  float before = body.sensors.stiffness[l_knee_pitch], greatest = 0;
  EXPECT_LT(before, 0.2f);
  for (int i = 0; i < 300; ++i) {
    cycle();
    greatest = std::max(greatest, body.sensors.stiffness[l_knee_pitch] - before);
    before = body.sensors.stiffness[l_knee_pitch];
  }
  EXPECT_GT(before, 0.5f);
  EXPECT_LE(greatest, Limiter::kStiffnessRise * 0.0121f);
}

TEST_F(NaoGuardian, StandsUpAgainOnceItIsUprightAfterAFall) {
  play();
  body.fall();
  until(Doing::fallen);
  run(3);
  body.put_upright();
  run(0.5);
  EXPECT_FALSE(has_stiffness()) << "a person may still be putting it down";
  until(Doing::standing);
}

/// A robot that lies on its back, and is ordered to get up.
struct NaoGuardianOnGround : NaoGuardian {
  void SetUp() override {
    play();
    body.lie_on_back();
    until(Doing::fallen);
    order.posture = Order::Posture::get_up;
  }
  void until_it_gets_up() { until(Doing::getting_up); }
};

TEST_F(NaoGuardianOnGround, GetsUpWhenOrderedAndStands) {
  until_it_gets_up();
  run(0.1);
  EXPECT_TRUE(has_stiffness());
  EXPECT_TRUE(guardian.fell()) << "it has not stood up yet";
  EXPECT_GT(guardian.remaining(), 1);
  body.put_upright();  // tests/walk plays it in the physics
  until(Doing::standing);
  EXPECT_FALSE(guardian.fell());
  EXPECT_EQ(guardian.reason(), Reason::none);
  run(1);
  EXPECT_TRUE(stands());
}

TEST_F(NaoGuardianOnGround, RollsOverFirst) {
  body.lie_on_front();
  until_it_gets_up();
  EXPECT_LT(guardian.remaining(), 5) << "it only rolls over";
  run(0.5);
  body.lie_on_back();
  until(Doing::fallen);
  EXPECT_EQ(guardian.failed_attempts(), 0);
  until_it_gets_up();
  EXPECT_GT(guardian.remaining(), 5);
}

TEST_F(NaoGuardianOnGround, ARollIsJudgedOnceItLiesStill) {
  for (const bool succeeds : {true, false}) {
    body.lie_on_front();
    until_it_gets_up();
    until(Doing::fallen);
    EXPECT_EQ(guardian.failed_attempts(), 0) << "it may still roll on";
    for (int i = 0; i < 100; ++i) {
      body.sensors.gyroscope = {i % 2 == 0 ? 1.0f : -1.0f, 0, 0};
      cycle();
      ASSERT_EQ(guardian.failed_attempts(), 0);
    }
    body.sensors.gyroscope = {};
    if (succeeds) body.lie_on_back();
    until_it_gets_up();
    EXPECT_EQ(guardian.failed_attempts(), succeeds ? 0 : 1);
    EXPECT_EQ(guardian.remaining() > 5, succeeds) << "else it rolls again";
    // restores the start for the next round
    body = tests::FakeBody();
    guardian = Guardian();
    SetUp();
  }
}

TEST_F(NaoGuardianOnGround, ARobotThatOnlyRollsGivesUpToo) {
  body.lie_on_front();
  int attempts = 0;
  for (int i = 0; i < 10'000 && guardian.reason() != Reason::stays_down; ++i) {
    const Doing before = guardian.doing();
    cycle();
    attempts += before == Doing::fallen && guardian.doing() == Doing::getting_up;
  }
  EXPECT_EQ(attempts, Guardian::kAttempts);
  EXPECT_EQ(guardian.reason(), Reason::stays_down);
}

TEST_F(NaoGuardianOnGround, LiesSoftWithoutThatOrder) {
  for (const Order::Posture posture :
       {Order::Posture::stand, Order::Posture::sit, Order::Posture::freeze, Order::Posture::soft}) {
    order.posture = posture;
    run(3);
    EXPECT_EQ(guardian.doing(), Doing::fallen);
    EXPECT_FALSE(has_stiffness());
    EXPECT_EQ(guardian.reason(), Reason::fell);
  }
}

TEST_F(NaoGuardianOnGround, WaitsUntilItLiesStill) {
  for (int i = 0; i < 300; ++i) {
    body.sensors.gyroscope = {i % 2 == 0 ? 1.0f : -1.0f, 0, 0};
    cycle();
    ASSERT_EQ(guardian.doing(), Doing::fallen);
  }
}

TEST_F(NaoGuardianOnGround, IsSoftAtOnceWhenAnythingElseApplies) {
  const std::pair<const char*, std::function<void()>> events[] = {
      {"head", [&] { body.hold_head(true); }},
      {"another order", [&] { order.posture = Order::Posture::sit; }},
      {"penalised", [&] { hear(true, GameState::playing); }},
      {"hung runtime", [&] { alive = false; }},
      {"heat", [&] { body.sensors.temperature[l_knee_pitch] = 80; }},
      {"an empty battery", [&] { body.sensors.battery[0] = 0.02f; }}};
  for (const auto& [name, befall] : events) {
    SCOPED_TRACE(name);
    until_it_gets_up();
    run(0.3);
    ASSERT_TRUE(has_stiffness());
    befall();
    run(0.6);
    EXPECT_FALSE(has_stiffness());
    // restores the start for the next round
    body = tests::FakeBody();
    guardian = Guardian();
    order = {};
    alive = true;
    SetUp();
  }
}

TEST_F(NaoGuardianOnGround, GetsUpAgainIfItTopplesAfterItBrokeOff) {
  until_it_gets_up();
  run(2);
  body.put_upright();
  run(2);
  alive = false;
  run(0.15);
  alive = true;
  run(0.5);
  EXPECT_EQ(guardian.doing(), Doing::fallen) << "upright, but its joints give way";
  body.lie_on_back();
  until_it_gets_up();
}

TEST_F(NaoGuardianOnGround, StandsUpIfItIsUprightAfterItBrokeOff) {
  until_it_gets_up();
  run(2);
  body.put_upright();
  run(2);
  alive = false;
  run(0.15);
  alive = true;
  until(Doing::standing_up);
  until(Doing::standing);
}

TEST_F(NaoGuardianOnGround, GivesUpAfterThreeAttempts) {
  int attempts = 0;
  for (int i = 0; i < 10'000 && guardian.reason() != Reason::stays_down; ++i) {
    const Doing before = guardian.doing();
    cycle();  // the torso never rises
    attempts += before == Doing::fallen && guardian.doing() == Doing::getting_up;
  }
  EXPECT_EQ(attempts, Guardian::kAttempts);
  run(10);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.reason(), Reason::stays_down);
  EXPECT_STREQ(sentence_of(guardian.reason()),
               "the robot did not get up in three attempts: it is soft until it is upright again");
  // a person puts it upright: it may fall and get up again
  body.put_upright();
  until(Doing::standing);
  run(2);
  body.lie_on_back();
  until(Doing::fallen);
  until_it_gets_up();
}

TEST_F(NaoGuardian, MovesAtHalfTheSpeedWhileWarmOrLow) {
  for (const bool warm : {true, false}) {
    play();
    if (warm) body.sensors.temperature[head_yaw] = 72;
    if (!warm) body.sensors.battery[0] = 0.08f;
    run(1);
    EXPECT_TRUE(guardian.limited());
    EXPECT_EQ(guardian.reason(), warm ? Reason::warm : Reason::battery_low);
    order.drives[head_yaw] = order.drives[head_pitch] = 1;
    order.position[head_yaw] = 2;
    order.stiffness.fill(1);
    const float from = cycle().position[head_yaw];
    EXPECT_NEAR(cycle().position[head_yaw] - from, limits_of(head_yaw).speed / 2 * 0.012f, 1e-4);
    order = {};
    cycle({.asked_soft = true});
    body.sensors.temperature[head_yaw] = 38;
    run(1);
  }
}

TEST_F(NaoGuardian, HoldsThenSitsWhenFramesCannotBeRead) {
  play();
  const auto blind = [&](double seconds) {
    for (double passed = 0; passed < seconds; passed += 0.012) {
      const Actuators& answer = guardian.step({.now_ns = now_ns += tests::kCycle_ns, .order = &order});
      body.obey(answer, 0.012f);
    }
  };
  blind(1);
  EXPECT_EQ(guardian.doing(), Doing::holding);
  EXPECT_EQ(guardian.reason(), Reason::sensors_missing);
  EXPECT_TRUE(stands());
  blind(6);
  EXPECT_TRUE(seated());
}

TEST_F(NaoGuardian, HoldsARobotThatIsStiffAtTheStart) {
  body.sensors = tests::FakeBody().sensors;
  body.sensors.position = stand()[0].position;
  body.sensors.stiffness.fill(0.8f);
  cycle();
  EXPECT_EQ(guardian.doing(), Doing::holding);
  run(2);
  EXPECT_EQ(guardian.reason(), Reason::waits_for_game);
  EXPECT_TRUE(stands());
  hear(false, GameState::playing);
  until(Doing::standing);
  EXPECT_EQ(guardian.mode(), Mode::playing);
}

TEST_F(NaoGuardian, ChecksTheBodyAgainAfterALossOfLola) {
  play();
  hear(false, GameState::playing);
  guardian.lose_lola();
  order.game.heard = 0;
  now_ns += 5 * 1'000'000'000ull;
  run(1);
  EXPECT_EQ(guardian.doing(), Doing::holding);
  EXPECT_EQ(guardian.reason(), Reason::waits_for_game);
  EXPECT_TRUE(stands());
  hear(false, GameState::playing);
  until(Doing::standing);

  // a robot that people made soft stays soft, also when LoLA reports stiff joints
  cycle({.asked_soft = true});
  guardian.lose_lola();
  body.sensors.stiffness.fill(0.8f);
  run(5);
  EXPECT_FALSE(has_stiffness());
  click();
  until(Doing::standing);
}

TEST_F(NaoGuardian, LeavesARobotSoftThatLiesAtTheStart) {
  body.sensors.stiffness.fill(0.8f);
  body.sensors.angles[1] = 1.4f;
  run(1);
  EXPECT_FALSE(has_stiffness());
  EXPECT_EQ(guardian.mode(), Mode::unstiff);
}

TEST_F(NaoGuardian, ShowsItsStateByLights) {
  run(0.1);
  click();
  EXPECT_EQ(cycle().lights.chest, (Colour{0, 0, 0}));
  click();
  EXPECT_EQ(cycle().lights.chest, (Colour{1, 0, 0}));
  click();
  EXPECT_EQ(cycle().lights.chest, (Colour{0, 1, 0}));
  hear(false, GameState::ready);
  EXPECT_EQ(cycle().lights.chest, (Colour{0, 0, 1}));
  hear(false, GameState::set);
  EXPECT_EQ(cycle().lights.chest, (Colour{1, 1, 0}));
  EXPECT_EQ(cycle().lights.l_ear[7], 1);
  EXPECT_EQ(cycle().lights.l_ear[8], 0) << "eight tenths of the battery";
}

}  // namespace
}  // namespace robot::nao
