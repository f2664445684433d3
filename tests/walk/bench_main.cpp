// bench_walk CASE FIRST_SEED ROBOTS [LIBRARY | NAME=VALUE...]: lets drawn robots of both servo classes walk, be pushed or
// stop, and prints one line of JSON. CASE "falls" prints the table that foresight-sim plays with --falls; "getting up" lets
// robots lie and get up; "play" lets a strategy bring the ball to the goal. LIBRARY has another walk
// (tests/walk/foresight_walk.h); NAME=VALUE changes a parameter of ours, and engine=ode plays the case in the second engine.
// Falls are those of robots nobody tuned on, if no one has used the seeds before.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/app/build_id.h"
#include "robot/core/result.h"
#include "robot/nao/walk/named_parameters.h"
#include "tests/walk/cases.h"
#include "tests/walk/fall_table.h"
#include "tests/walk/foreign_walk.h"
#include "tests/walk/our_gait.h"
#include "tests/walk/play.h"
#include "tests/walk/rise.h"

namespace {

using namespace robot::nao::walk;
using Json = nlohmann::json;

/// The sums over the trials of one class.
class Tally {
 public:
  void add(const Outcome& outcome, const Plan& plan, int repetition) {
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

Json played(const Case& one, const Tested& tested, std::uint64_t first_seed, int robots) {
  Json all;
  for (const Servos servos : {Servos::stiff, Servos::soft}) {
    Tally tally;
    const auto add = [&](const Outcome& outcome, const Plan& plan, int direction) {
      tally.add(outcome, plan, direction);
    };
    if (!play(one, tested, servos, first_seed, robots, add)) return nullptr;
    all[servos == Servos::stiff ? "stiff" : "soft"] = tally.json();
  }
  return all;
}

/// The robots of one class that lay on one side: how many stood at the first attempt, how many within three, and the
/// seconds of each that stood.
Json got_up(Servos servos, robot::nao::Lying side, std::uint64_t first_seed, int robots) {
  int first = 0, stood = 0;
  std::vector<double> seconds;
  for (const robot::nao::Rise& rise : robot::nao::rises(servos, first_seed, robots, side)) {
    if (!rise.stood) continue;
    first += rise.at_once(), stood += rise.failed < 3;
    seconds.push_back(rise.seconds);
  }
  return {{"robots", robots}, {"first", first}, {"within_three", stood}, {"seconds", seconds}};
}

/// Calls see(servos) for both classes at once, and returns what it found by class.
template <class See>
Json by_class(const See& see) {
  auto stiff = std::async(std::launch::async, see, Servos::stiff),
       soft = std::async(std::launch::async, see, Servos::soft);
  return {{"stiff", stiff.get()}, {"soft", soft.get()}};
}

/// Lets a strategy play alone, robot by robot. Counts goals and falls, and lists the seconds until each goal. Lists the speed of
/// the ball after each kick [m/s], and the time from its command to its step [s].
Json playing(std::uint64_t first_seed, int robots) {
  constexpr double kLongest = 60;  // [s]
  return by_class([=](Servos servos) -> Json {
    int goals = 0, falls = 0;
    std::vector<double> seconds, kicks, waits;
    for (int i = 0; i < robots; ++i) {
      const robot::nao::Played played =
          robot::nao::play_alone(servos, first_seed + static_cast<std::uint64_t>(i), kLongest);
      goals += played.scored, falls += played.fell;
      if (played.scored) seconds.push_back(played.seconds);
      kicks.insert(kicks.end(), played.kicks.begin(), played.kicks.end());
      waits.insert(waits.end(), played.waits.begin(), played.waits.end());
    }
    return {{"robots", robots},   {"goals", goals}, {"falls", falls},
            {"seconds", seconds}, {"kicks", kicks}, {"waits", waits}};
  });
}

Json getting_up(std::uint64_t first_seed, int robots) {
  using robot::nao::Lying;
  Json all;
  for (const auto& [name, side] : {std::pair{"back", Lying::on_back},
                                   {"front", Lying::on_front},
                                   {"left", Lying::on_left},
                                   {"right", Lying::on_right}}) {
    all[name] = by_class([=, side = side](Servos servos) { return got_up(servos, side, first_seed, robots); });
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
      constant({.forward = 0.2}, 10).plan(1, 0));
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
  return "expected CASE FIRST_SEED ROBOTS [LIBRARY | NAME=VALUE...] [engine=ode], or cost; cases are falls, getting "
         "up, play, " +
         names + "; got '" + got + "'";
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

/// Lets the case be played in the second engine.
robot::Result<void> play_in_ode(Case* one) {
  if (!one || one->ball || one->turf > 0)
    return robot::Error{"expected a case on flat ground without a ball for engine=ode, got another one"};
  if (!ode_engine({}))
    return robot::Error{"expected a build with the package libode-dev for engine=ode, got one without"};
  one->ode = true;
  return {};
}

/// Returns the table of falls. The classes of our own walk are played at once. Another walk may share what it keeps between
/// its gaits, so its calls come from one thread.
robot::Result<std::string> table_of(const Tested& tested, const Origin& origin) {
  const auto policy = origin.parameters.empty() ? std::launch::deferred : std::launch::async;
  const auto counted = [&](Servos servos) {
    return std::async(policy, [&, servos] { return count_falls(tested, servos, origin.first_seed, origin.robots); });
  };
  std::future<robot::Result<FallCounts>> stiff = counted(Servos::stiff), soft = counted(Servos::soft);
  robot::Result<FallCounts> first = stiff.get(), second = soft.get();
  if (!first) return first.failure(origin.walk);
  if (!second) return second.failure(origin.walk);
  return fall_table(origin, {std::move(*first), std::move(*second)});
}

/// Plays the case and prints what it found; without a case, the table of falls.
int print(const Case* one, const Tested& tested, const Origin& origin) {
  if (!one) {
    const auto table = table_of(tested, origin);
    if (!table) return refuse(table.error());
    std::fputs(table->c_str(), stdout);
    return 0;
  }
  const Json all = played(*one, tested, origin.first_seed, origin.robots);
  if (all.is_null()) return refuse(origin.walk + ": expected a walk from foresight_walk_begin, got none");
  std::printf("%s\n", all.dump().c_str());
  return 0;
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
  if ((name == "getting up" || name == "play") && count == 4 && robots > 0) {
    const std::uint64_t first_seed = std::strtoull(words[2], nullptr, 10);
    const Json all = name == "play" ? playing(first_seed, robots) : getting_up(first_seed, robots);
    std::printf("%s\n", all.dump().c_str());
    return 0;
  }
  if ((found == cases().end() && name != "falls") || robots < 1) return refuse(usage(name));
  Case copy = found == cases().end() ? Case{} : found->second;
  Case* const one = found == cases().end() ? nullptr : &copy;
  if (count > 4 && std::string_view(words[count - 1]) == "engine=ode") {
    if (const auto possible = play_in_ode(one); !possible) return refuse(possible.error());
    --count;
  }
  Origin origin{.walk = "ours",
                .parameters = "",
                .build = std::string(robot::app::kBuildId),
                .first_seed = std::strtoull(words[2], nullptr, 10),
                .robots = robots};
  const bool is_library = count == 5 && std::string_view(words[4]).find('=') == std::string_view::npos;
  if (!is_library) {
    Parameters parameters = copy.parameters;
    if (const auto changed = change(parameters, {words + 4, words + count}); !changed) return refuse(changed.error());
    origin.parameters = hash_of(parameters);
    return print(one, ours(parameters), origin);
  }
  const auto library = ForeignWalk::load(words[4]);
  if (!library) return refuse(library.error());
  origin.walk = words[4];
  return print(one, theirs(*library), origin);
}
