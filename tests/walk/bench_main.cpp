// bench_walk CASE FIRST_SEED ROBOTS [LIBRARY | NAME=VALUE...]: lets drawn robots of both servo classes walk, be pushed or stop, and prints
// one line of JSON. LIBRARY has another walk (tests/walk/foresight_walk.h); NAME=VALUE changes a parameter of ours. Falls
// are those of robots nobody tuned on, if no one has used the seeds before.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/nao/walk/named_parameters.h"
#include "tests/walk/foreign_walk.h"
#include "tests/walk/our_gait.h"
#include "tests/walk/plans.h"

namespace {

using namespace robot::nao::walk;
using Json = nlohmann::json;

constexpr int kDirections = 8;

/// Everything that a case changes.
struct Case {
  std::function<Plan(std::uint64_t seed, int repetition)> plan;
  int repetitions = 1;  // of each robot
  double turf = 0;      // [m]
  double delay = 0;     // [s] more
  double wider = 1;
  bool ball = false;
  Parameters parameters = {};
};

Plan steady(const Command& command, double duration) {
  return {.duration = duration, .command = [=](double now) { return now < kStart ? Command{} : command; }};
}

/// One push in each of eight directions, at a random phase of a step.
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

Case constant(const Command& command, double duration = 40) {
  return {.plan = [=](std::uint64_t, int) { return steady(command, duration); }};
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

/// All cases by name.
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
      {"stop", {.plan = [=](std::uint64_t, int) { return stopping(ahead); }}},
      {"push 1.2 walking", pushes(1.2, slow)},
      {"push 1.2 standing", pushes(1.2, {})},
      {"push 1.8 walking", pushes(1.8, slow)},
      {"push 1.8 standing", pushes(1.8, {})},
      {"push 2.4 walking", pushes(2.4, slow)},
      {"push 2.4 standing", pushes(2.4, {})},
      {"push 3.0 walking", pushes(3.0, slow)},
      {"push 3.0 standing", pushes(3.0, {})},
      {"kick forward", kicks({})},
      {"kick side", kicks({KickStep::side, 0.05, 0.17})},
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

/// The sums over the trials of one class.
class Tally {
 public:
  void add(const Outcome& outcome, const Plan& plan, int repetition) {
    // a robot that fell before its push proves nothing about the push
    if (!plan.pushes.empty() && outcome.fell && outcome.time < plan.pushes.front().time) return;
    ++trials_;
    const bool fell = outcome.fell;
    falls_ += fell;
    slow_ += !fell && outcome.failed();
    minutes_ += outcome.time / 60;
    metres_ += std::max(outcome.forward, 0.0);
    const auto direction = static_cast<std::size_t>(repetition);
    ++trials_of_[direction], falls_of_[direction] += fell;
    if (outcome.measured > 4) {
      forward_.push_back(outcome.forward / outcome.measured);
      left_.push_back(outcome.left / outcome.measured);
      turned_.push_back(outcome.turned / outcome.measured);
    }
    last_step_.push_back(outcome.last_step);
    if (plan.with_ball) ball_speed_.push_back(outcome.ball_speed);
    if (fell && !plan.pushes.empty()) until_fall_.push_back(outcome.time - plan.pushes.front().time);
  }

  Json json() const {
    return {{"trials", trials_},
            {"falls", falls_},
            {"slow", slow_},
            {"minutes", minutes_},
            {"metres", metres_},
            {"trials_by_direction", trials_of_},
            {"falls_by_direction", falls_of_},
            {"forward", forward_},
            {"left", left_},
            {"turned", turned_},
            {"last_steps", last_step_},
            {"ball_speeds", ball_speed_},
            {"seconds_until_fall", until_fall_}};
  }

 private:
  int trials_ = 0, falls_ = 0, slow_ = 0;
  double minutes_ = 0, metres_ = 0;
  std::array<int, kDirections> trials_of_{}, falls_of_{};
  std::vector<double> forward_, left_, turned_, last_step_, ball_speed_, until_fall_;
};

/// The walk under test.
struct Tested {
  Legs stand;
  double hip_height;  // [m]
  std::function<std::unique_ptr<Gait>()> begin;
};

Tested ours(const Parameters& parameters) {
  return {stand(parameters), parameters.hip_height, [=] { return std::make_unique<OurGait>(parameters); }};
}

Tested theirs(const ForeignWalk& walk) {
  return {walk.stand(), walk.hip_height(), [&walk] { return walk.begin(); }};
}

Json played(const Case& one, const Tested& tested, std::uint64_t first_seed, int robots) {
  std::array<std::unique_ptr<Physics>, 2> physics;  // by the reading of the inertias
  for (const bool about_origin : {false, true})
    physics[about_origin] =
        std::make_unique<Physics>(Scene{.turf = one.turf > 0, .ball = one.ball, .about_origin = about_origin});
  Json all;
  for (const Servos servos : {Servos::stiff, Servos::soft}) {
    Tally tally;
    for (int i = 0; i < robots; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      DrawnRobot robot = draw_robot(seed, servos, one.wider);
      robot.turf = one.turf, robot.delay += one.delay;
      for (int repetition = 0; repetition < one.repetitions; ++repetition) {
        const std::unique_ptr<Gait> gait = tested.begin();
        if (!gait) return nullptr;
        const Plan plan = one.plan(seed, repetition);
        tally.add(run(*physics[robot.about_origin], *gait, robot, seed, tested.stand, tested.hip_height, plan), plan,
                  repetition);
      }
    }
    all[servos == Servos::stiff ? "stiff" : "soft"] = tally.json();
  }
  return all;
}

/// Times the walk alone, on frames of a recorded trial.
Json cost() {
  Physics physics({});
  OurGait gait;
  std::vector<Sensors> frames;
  struct Recorder final : Gait {
    std::vector<Sensors>& frames;
    OurGait& gait;
    Recorder(std::vector<Sensors>& all, OurGait& ours) : frames(all), gait(ours) {}
    Legs tick(const Sensors& sensors, const Command& command, double dt) override {
      frames.push_back(sensors);
      return gait.tick(sensors, command, dt);
    }
    bool steps() const override { return gait.steps(); }
  } recorder(frames, gait);
  run(physics, recorder, draw_robot(1, Servos::stiff), 1, stand(), Parameters{}.hip_height,
      steady({.forward = 0.2}, 10));
  Walk walk;
  const auto begin = std::chrono::steady_clock::now();
  constexpr int kRounds = 50;
  for (int round = 0; round < kRounds; ++round)
    for (const Sensors& frame : frames) walk.tick(frame, {.forward = 0.2}, 0.012);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto ticks = static_cast<double>(frames.size());
  return {{"microseconds_a_tick", 1e6 * seconds.count() / (kRounds * ticks)}, {"ticks", (kRounds + 1) * ticks}};
}

int refuse(const std::string& sentence) {
  std::fprintf(stderr, "bench_walk: %s\n", sentence.c_str());
  return 2;
}

std::string usage(const std::string& got) {
  std::string names;
  for (const auto& [name, one] : cases()) names.append(names.empty() ? "" : ", ").append(name);
  return "expected CASE FIRST_SEED ROBOTS [LIBRARY | NAME=VALUE...], or cost; cases are " + names + "; got '" + got +
         "'";
}

/// Changes parameters by words such as "lift=0.02".
robot::Result<void> change(Parameters& parameters, std::span<char*> words) {
  for (const std::string word : words) {
    const std::size_t middle = word.find('=');
    const auto place = parameter_named(word.substr(0, middle));
    const std::string number = middle == std::string::npos ? "" : word.substr(middle + 1);
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    if (!place || number.empty() || *end != 0 || !std::isfinite(value))
      return robot::Error{"expected NAME=VALUE with a name of robot/nao/walk/parameters.h, got '" + word + "'"};
    parameters.*place = value;
  }
  return {};
}

}  // namespace

int main(int count, char** words) {
  const std::string name = count > 1 ? words[1] : "";
  if (name == "cost" && count == 2) {
    std::printf("%s\n", cost().dump().c_str());
    return 0;
  }
  const auto found = cases().find(name);
  const int robots = count >= 4 ? std::atoi(words[3]) : 0;
  if (found == cases().end() || robots < 1) return refuse(usage(name));
  const std::uint64_t first_seed = std::strtoull(words[2], nullptr, 10);
  const bool is_library = count == 5 && std::string_view(words[4]).find('=') == std::string_view::npos;
  if (!is_library) {
    Parameters parameters = found->second.parameters;
    if (const auto changed = change(parameters, {words + 4, words + count}); !changed) return refuse(changed.error());
    std::printf("%s\n", played(found->second, ours(parameters), first_seed, robots).dump().c_str());
    return 0;
  }
  const auto library = ForeignWalk::load(words[4]);
  if (!library) return refuse(library.error());
  const Json all = played(found->second, theirs(*library), first_seed, robots);
  if (all.is_null()) return refuse(std::string(words[4]) + ": expected a walk from foresight_walk_begin, got none");
  std::printf("%s\n", all.dump().c_str());
  return 0;
}
