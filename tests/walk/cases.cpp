#include "tests/walk/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/walk/our_gait.h"
#include "tests/walk/plans.h"

namespace robot::nao::walk {
namespace {

constexpr double kShove = 0.64;  // [N s] of two robots of 5.3 kg that close in at 0.2 m/s and part at a fifth of that
constexpr double kShoveEvery = 0.27;  // [s] a step of the one that pushes

Plan steady(const Command& command, double duration) {
  return {.duration = duration, .command = [=](double now) { return now < kStart ? Command{} : command; }};
}

/// New commands every 2 s, as in a game; a quarter of them to stand.
Plan game_like(std::uint64_t seed, double duration) {
  return {.duration = duration, .command = [=](double now) {
            if (now < kStart) return Command{};
            const auto number = 10 * static_cast<std::uint64_t>(now / 2);
            const auto between = [&](std::uint64_t which, double low, double high) {
              return low + (high - low) * drawn(seed, number + which);
            };
            if (between(0, 0, 1) < 0.25) return Command{};
            Command command{between(1, -0.1, 0.2), between(2, -0.1, 0.1), between(3, -0.8, 0.8)};
            if (between(4, 0, 1) < 0.4) command.left = command.turn = 0;
            return command;
          }};
}

Plan stopping(const Command& command) {
  return {.duration = 8, .command = [=](double now) { return now < kStart || now >= 4.5 ? Command{} : command; }};
}

Case kicks(const PlannedKick& kick) {
  return {.plan = [=](std::uint64_t seed, int) { return kick_plan(kick, seed); }, .ball = true};
}

Parameters open_loop() {
  Parameters p;
  p.rate_to_ankle_pitch = p.rate_to_ankle_roll = p.rate_to_hip_pitch = p.tilt_to_ankle_pitch = p.tilt_to_ankle_roll = 0;
  p.catch_forward = p.catch_side = p.counter = 0;
  p.earliest = p.latest = 1, p.hanging = 0, p.share = 2;  // the clock ends each step
  p.lean_learning = p.speed_learning = p.heading_rate = p.lag_share = 0;
  return p;
}

template <class Change>
Case changed(Case original, Change&& change) {
  change(original);
  return original;
}

}  // namespace

Case pushes(double impulse, const Command& command) {
  return {.plan =
              [=](std::uint64_t seed, int direction) {
                Plan plan = steady(command, 8);
                plan.pushes = {{3.5 + drawn(seed, static_cast<std::uint64_t>(direction)), impulse,
                                direction * 2 * std::numbers::pi / kDirections}};
                return plan;
              },
          .repetitions = kDirections};
}

Case shoves(const Command& command) {
  return {.plan =
              [=](std::uint64_t seed, int direction) {
                Plan plan = steady(command, 10);
                const double first = kShoved + kShoveEvery * drawn(seed, static_cast<std::uint64_t>(direction));
                for (double time = first; time < plan.duration; time += kShoveEvery)
                  plan.pushes.push_back({time, kShove, direction * 2 * std::numbers::pi / kDirections});
                return plan;
              },
          .repetitions = kDirections};
}

Case constant(const Command& command, double duration) {
  return {.plan = [=](std::uint64_t, int) { return steady(command, duration); }};
}

const std::map<std::string, Case>& cases() {
  const Command ahead{.forward = 0.2}, slow{.forward = 0.15};
  const auto with = [](Case original, auto member, auto value) {
    original.parameters.*member = value;
    return original;
  };
  static const std::map<std::string, Case> all = {
      {"walk", constant(ahead)},
      {"walk 0.25", constant({.forward = 0.25})},
      {"backwards", constant({.forward = -0.1}, 20)},
      {"sideways", constant({.left = 0.1}, 20)},
      {"turning", constant({.turn = 0.8}, 20)},
      {"game", {.plan = [](std::uint64_t seed, int) { return game_like(seed, 60); }}},
      {"half", {.plan = [](std::uint64_t seed, int) { return game_like(seed, 600); }}},
      {"half, warming", {.plan = [](std::uint64_t seed, int) { return game_like(seed, 600); }, .warms = 600}},
      {"stop", {.plan = [=](std::uint64_t, int) { return stopping(ahead); }}},
      {"push 1.2 walking", pushes(1.2, slow)},
      {"push 1.2 standing", pushes(1.2, {})},
      {"push 1.8 walking", pushes(1.8, slow)},
      {"push 1.8 standing", pushes(1.8, {})},
      {"push 2.4 walking", pushes(2.4, slow)},
      {"push 2.4 standing", pushes(2.4, {})},
      {"push 3.0 walking", pushes(3.0, slow)},
      {"push 3.0 standing", pushes(3.0, {})},
      {"shoved walking", shoves(slow)},
      {"shoved standing", shoves({})},
      {"kick forward", kicks({})},
      {"kick side", kicks({.step = KickStep::side, .speed = 0.1, .ball_ahead = 0.05, .nearer = 0, .ball_aside = 0.17})},
      {"turf 8 mm", changed(constant(ahead, 18), [](Case& one) { one.turf = 0.008; })},
      {"delay 40 ms", changed(constant(ahead), [](Case& one) { one.delay = 0.02; })},
      {"ranges 20 % wider", changed(constant(ahead), [](Case& one) { one.wider = 1.2; })},
      {"open loop", changed(constant(ahead), [](Case& one) { one.parameters = open_loop(); })},
      {"without learned course", with(constant(ahead), &Parameters::learning, 0.0)},
      {"without lag lead", with(constant(ahead), &Parameters::lag_share, 0.0)},
      {"without counterweight", with(pushes(1.8, slow), &Parameters::counter, 0.0)},
  };
  return all;
}

Tested ours(const Parameters& parameters) {
  return {stand(parameters), parameters.hip_height, [=] { return std::make_unique<OurGait>(parameters); }};
}

Tested theirs(const ForeignWalk& walk) {
  return {walk.stand(), walk.hip_height(), [&walk] { return walk.begin(); }};
}

bool play(const Case& one, const Tested& tested, Servos servos, std::uint64_t first_seed, int robots,
          const std::function<void(const Outcome& outcome, const Plan& plan, int repetition)>& see) {
  std::array<std::unique_ptr<Physics>, 2> physics;  // by the reading of the inertias
  for (const bool about_origin : {false, true})
    physics[about_origin] = std::make_unique<Physics>(
        Scene{.turf = one.turf > 0, .ball = one.ball, .about_origin = about_origin, .ode = one.ode});
  for (int i = 0; i < robots; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    DrawnRobot robot = draw_robot(seed, servos, one.wider);
    robot.turf = one.turf, robot.delay += one.delay, robot.warms = one.warms;
    for (int repetition = 0; repetition < one.repetitions; ++repetition) {
      const std::unique_ptr<Gait> gait = tested.begin();
      if (!gait) return false;
      const Plan plan = one.plan(seed, repetition);
      const Outcome outcome =
          run(*physics[robot.about_origin], *gait, robot, seed, tested.stand, tested.hip_height, plan);
      if (!plan.pushes.empty() && outcome.fell && outcome.time < plan.pushes.front().time) continue;
      see(outcome, plan, repetition);
    }
  }
  return true;
}

}  // namespace robot::nao::walk
