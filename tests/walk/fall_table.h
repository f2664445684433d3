// How often a walk falls, as a table that the simulator plays (sim/motion/fall_table.h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robot/core/result.h"
#include "tests/walk/cases.h"

namespace robot::nao::walk {

/// The falls among some trials.
struct Trials {
  int trials = 0;
  int falls = 0;
};

/// Pushes of one strength, by their direction.
struct Pushed {
  double impulse = 0;  // [N s]
  std::array<Trials, kDirections> to;
};

/// The falls while a robot moves in one manner, or while another one shoves it.
struct Walked {
  std::string_view manner;  // a name in sim::motion::FallRates
  int falls = 0;
  double minutes = 0;
};

/// Robots that lay on one side.
struct Risen {
  int robots = 0;
  int first = 0;       // stood at the first attempt
  double seconds = 0;  // of such an attempt: the median
};

/// The sides that a robot is down on. The left and the right count together.
inline constexpr std::array kDownOn = {"back", "front", "side"};

/// All trials of the robots of one class.
struct FallCounts {
  std::vector<Walked> walks;
  std::array<int, 3> alone{};  // falls without a push, by kDownOn
  std::vector<Pushed> standing, walking;
  std::array<Risen, 3> risen{};  // by kDownOn
  double lying = 0;              // [s] before an attempt: the median
};

/// Which pushes topple a robot. The logarithm of the odds of a fall rises by `slope` with that of the impulse.
struct Toppling {
  double slope = 0;
  std::array<double, kDirections> half{};  // [N s] topples half of the robots
};

/// Fits the toppling to the counts: a penalised logistic regression, in which all directions share the slope. The penalties
/// are those of normal priors. The slope is 6 ± 3. The impulse that topples half is 2.4 N s, multiplied or divided by exp(3 / slope). A
/// direction differs from the mean by a factor of exp(1.5 / slope). Priors count where nearly all robots fall, or nearly none.
Toppling fit_toppling(const std::vector<Pushed>& pushes);

/// Counts the falls of `robots` robots of this class, and lets them get up as our guardian does it. It is an Error if the walk
/// gives no gait, if all robots fall before their push, or if none gets up.
Result<FallCounts> count_falls(const Tested& tested, Servos servos, std::uint64_t first_seed, int robots);

/// The source of the counts.
struct Origin {
  std::string walk;        // "ours", or the library
  std::string parameters;  // a hash of ours; "" for a library
  std::string build;       // the commit of the harness
  std::uint64_t first_seed = 0;
  int robots = 0;  // of each class
};

/// Returns the table as JSON, with the counts: one entry a line. `counts` by Servos.
std::string fall_table(const Origin& origin, const std::array<FallCounts, 2>& counts);

/// Returns a hash of the parameters of our walk: another one means another walk. Those of kicks are left out: no trial of the
/// table kicks.
std::string hash_of(const Parameters& parameters);
/// Returns a hash of the key frames of getting up.
std::string hash_of_getting_up();

/// Returns the probability that an attempt fails. The prior is that of Jeffreys.
double failure_of(const Risen& risen);
/// Returns the share of falls with such a count, of `all`, with the same prior for each of kDownOn.
double share_of(int count, int all);

}  // namespace robot::nao::walk
