// Tests of the lanes of motion: each lane gets the bits of its formula alone, and lists get those of single robots.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "sim/motion/fall_lanes.h"
#include "sim/motion/head_lanes.h"
#include "sim/motion/walk_lanes.h"
#include "tests/sim/motion/arena.h"
#include "tests/sim/motion/dice.h"

namespace sim::motion {
namespace {

#ifdef NDEBUG
constexpr int kBlocks = 1'000'000 / kLanes;
#else
constexpr int kBlocks = 50'000 / kLanes;  // without optimisation
#endif

/// Wild inputs: mostly moderate numbers, and every special kind of number.
struct Wild {
  Dice dice{std::mt19937(1)};

  std::uint32_t word() { return static_cast<std::uint32_t>(dice.engine()); }
  float number() {
    using Limits = std::numeric_limits<float>;
    constexpr float kSpecial[] = {0.f,
                                  -0.f,
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::quiet_NaN(),
                                  Limits::denorm_min(),
                                  -1e-40f,
                                  Limits::max(),
                                  -Limits::min(),
                                  0.4f,
                                  kPi};
    const std::uint32_t kind = word() % 64;
    if (kind < std::size(kSpecial)) return kSpecial[kind];
    return dice.between(-1, 1) * (kind < 50 ? 1.f : 5.f);
  }
  void fill(Lane<float>& lane) {
    for (float& value : lane.lane) value = number();
  }
  void fill(Lane<Vec2>& lane) {
    for (int i = 0; i < kLanes; ++i) lane.set(i, {number(), number()});
  }
  void fill(Lane<std::int32_t>& flags) {
    for (std::int32_t& flag : flags.lane) flag = static_cast<std::int32_t>(word() & 1u);
  }
  void fill(DrawLanes& draws) {
    for (int i = 0; i < kLanes; ++i)
      draws.set(i, {word() | static_cast<std::uint64_t>(word()) << 32}, static_cast<int>(word() % 14), word());
  }
  template <class... Lanes>
  void fill_all(Lanes&... lanes) {
    (fill(lanes), ...);
  }
};

/// Reports whether two blocks have the same bits, or NaN in the same places.
template <class Block>
bool are_same(const Block& a, const Block& b) {
  std::array<std::uint32_t, sizeof(Block) / 4> first, second;
  std::memcpy(first.data(), &a, sizeof a);
  std::memcpy(second.data(), &b, sizeof b);
  const auto is_nan = [](std::uint32_t bits) { return std::isnan(std::bit_cast<float>(bits)); };
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i] != second[i] && !(is_nan(first[i]) && is_nan(second[i]))) return false;
  return true;
}

/// Expects that narrow and wide vectors both turn `block` into `expected`.
template <auto kernel, class Block, class... Constants>
bool agrees(const Block& block, const Block& expected, const Constants&... constants) {
  Block narrow = block, wide = block;
  detail::run_narrow<kernel>(constants..., narrow);
  if (detail::has_wide_lanes()) detail::run_wide<kernel>(constants..., wide);
  return are_same(narrow, expected) && (!detail::has_wide_lanes() || are_same(wide, expected));
}

WalkLanes random_walks(Wild& wild) {
  WalkLanes a;
  wild.fill_all(a.position, a.facing, a.velocity, a.heading, a.turn_rate, a.walked, a.draws, a.begins, a.walks,
                a.until_next, a.share, a.luck_speed, a.luck_turn, a.gait.velocity, a.gait.turn_rate, a.target, a.turn,
                a.by_speed, a.gain, a.dt);
  return a;
}

template <bool limited>
void expect_steps(const Effects& effects) {
  const Walk model = match_model().walk;
  Wild wild;
  for (int block = 0; block < kBlocks / 2; ++block) {
    const WalkLanes a = random_walks(wild);
    WalkLanes expected = a;
    for (int i = 0; i < kLanes; ++i) {
      const RandomKey key{a.draws.low[i] | static_cast<std::uint64_t>(a.draws.high[i]) << 32};
      const std::uint32_t robot = a.draws.robot[i];
      const float share = effects.walk_spread ? share_of(model, draw(key, robot, Draw::walk_pace, 0)) : 1;
      const Luck luck =
          effects.walk_noise ? luck_of(model, draw(key, robot, Draw::walk_noise, a.draws.number[i])) : Luck{};
      expected.share[i] = share;
      expected.set_luck(i, luck);
      if (a.begins[i] == 0) continue;
      expected.facing.set(i, direction(a.heading[i]));
      expected.gait.set(
          i, a.walks[i] == 0 ? Gait{}
                             : gait_of(walk_at(model, share), limited, a.gain[i], a.errand(i), a.until_next[i], luck));
    }
    ASSERT_TRUE((agrees<begin_steps<limited>>(a, expected, model, effects))) << block;
  }
}

TEST(MotionLanes, AStepBeginsInEachLaneAsItDoesAlone) {
  Effects effects = all_effects();
  effects.walk_spread = true;
  expect_steps<true>(effects);
  expect_steps<false>(Effects{});
}

template <bool limited>
void expect_glides() {
  const Walk model = match_model().walk;
  Wild wild;
  for (int block = 0; block < kBlocks / 2; ++block) {
    const WalkLanes a = random_walks(wild);
    WalkLanes expected = a;
    for (int i = 0; i < kLanes; ++i) {
      const Glide glided = glide(model, limited, a.gait[i], a.dt[i], a.body(i));
      expected.set_body(i, glided.body);
      expected.set_errand(i, after(a.errand(i), glided.moved));
    }
    ASSERT_TRUE(agrees<glide_on<limited>>(a, expected, model)) << block;
  }
}

TEST(MotionLanes, ABodyGlidesInEachLaneAsItDoesAlone) {
  expect_glides<true>();
  expect_glides<false>();
}

template <bool limited>
void expect_heads() {
  const Head model = match_model().head;
  Wild wild;
  for (int block = 0; block < kBlocks / 2; ++block) {
    HeadLanes a;
    wild.fill_all(a.aims, a.aim, a.height, a.told, a.told_heading, a.position, a.facing, a.heading, a.dt, a.yaw,
                  a.pitch, a.look, a.to_yaw, a.to_pitch);
    // often the robot has not moved, or the head is there already
    const int still = block % kLanes;
    a.told.set(still, a.position[still]), a.told_heading[still] = a.heading[still];
    a.aims[still] = block % 2, a.aim.set(still, {a.yaw[still], a.pitch[still]});
    HeadLanes expected = a;
    for (int i = 0; i < kLanes; ++i) {
      const Vec2 point = seen_now(a.aim[i], {a.told[i], a.told_heading[i]}, a.stand(i));
      const Angles to = a.aims[i] != 0 ? aimed_at(point, a.height[i], a.gaze(i)) : Angles{a.aim[i].x, a.aim[i].y};
      expected.to_yaw[i] = to.yaw, expected.to_pitch[i] = to.pitch;
      expected.set_gaze(i, turned_to(model, limited, to, a.dt[i], a.gaze(i)));
    }
    ASSERT_TRUE(agrees<turn_heads_on<limited>>(a, expected, model)) << block;
  }
}

TEST(MotionLanes, AHeadTurnsInEachLaneAsItDoesAlone) {
  expect_heads<true>();
  expect_heads<false>();
}

TEST(MotionLanes, FallsAreDrawnInEachLaneAsTheyAreAlone) {
  Wild wild;
  int falls = 0;
  for (int block = 0; block < kBlocks; ++block) {
    FallLanes a;
    wild.fill_all(a.draws, a.rate, a.ticks, a.falls);
    FallLanes expected = a;
    for (int i = 0; i < kLanes; ++i) {
      expected.falls[i] = falls_by(a.draws.draw(i, Draw::fall)[0], a.rate[i], a.ticks[i]) ? 1 : 0;
      falls += expected.falls[i];
    }
    ASSERT_TRUE(agrees<draw_falls>(a, expected)) << block;
  }
  EXPECT_GT(falls, kBlocks / 10);
}

/// A game of six robots that get random commands.
struct Crowded {
  World world{};
  std::array<Command, 6> commands;
  std::array<Pose2, 6> told;
};

Command random_command(Dice& dice) {
  Command command;
  command.body = static_cast<Command::Body>(dice.engine() % 5);
  command.head = static_cast<Command::Head>(dice.engine() % 3);
  command.kick = static_cast<std::uint8_t>(dice.engine() % 4);  // the last one does not exist
  command.kick_left = dice.engine() % 2 == 0;
  command.walk = {dice.between(-0.6f, 0.6f), dice.between(-0.6f, 0.6f)};
  command.turn = dice.between(-2, 2);
  command.gain = dice.between(0.2f, 1.2f);
  for (float& look : command.look) look = dice.between(-1, 2);
  return command;
}

TEST(MotionLanes, AListMovesAsSingleRobotsDo) {
  for (int off = 0; off < 16; ++off) {
    Model model = match_model();
    model.squat = {.delay = 0.3f, .duration = 1};
    Effects effects = all_effects();
    effects.walk_spread = true;
    effects.walk_acceleration = (off & 1) == 0, effects.walk_noise = (off & 2) == 0;
    effects.head_limits = (off & 4) == 0, effects.falls = (off & 8) == 0;
    const BallModel ball{.radius = 0.05f, .deceleration = 0.3f};
    const MotionParams params{model, effects, ball};

    Dice dice{std::mt19937(static_cast<unsigned>(off))};
    std::vector<Crowded> together(7);
    for (std::size_t game = 0; game < together.size(); ++game) together[game].world.key.seed = game;
    std::vector<Crowded> alone = together;
    for (int turn = 0; turn < 150; ++turn) {
      std::vector<Mover> list;
      for (std::size_t game = 0; game < together.size(); ++game) {
        Crowded& crowd = together[game];
        Crowded& single = alone[game];
        const Tick steps = 1 + static_cast<Tick>(dice.engine() % 12);
        for (int robot = 0; robot < 6; ++robot) {
          const auto i = static_cast<std::size_t>(robot);
          const Body& body = crowd.world.bodies[robot];
          if (turn % 3 == 0) crowd.commands[i] = random_command(dice);
          crowd.told[i] = {body.position, body.heading};
          single.commands[i] = crowd.commands[i], single.told[i] = crowd.told[i];
          if (dice.engine() % 5 == 0) continue;
          const Tick head_steps = dice.engine() % 3 == 0 ? 0 : steps;
          list.push_back({&crowd.commands[i], &crowd.told[i], &crowd.world, robot, steps, head_steps});
          const Mover mover{&single.commands[i], &single.told[i], &single.world, robot, steps, head_steps};
          move(params, {&mover, 1});
        }
        single.world.tick += steps;
      }
      move(params, list);
      for (std::size_t game = 0; game < together.size(); ++game) {
        together[game].world.tick = alone[game].world.tick;
        for (int robot = 0; robot < 6; ++robot) {
          const Body& a = together[game].world.bodies[robot];
          const Body& b = alone[game].world.bodies[robot];
          ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << off << " " << turn << " " << game << " " << robot;
        }
        ASSERT_EQ(together[game].world.ball.velocity, alone[game].world.ball.velocity);
        ASSERT_EQ(together[game].world.whiffed, alone[game].world.whiffed);
      }
    }
  }
}

}  // namespace
}  // namespace sim::motion
