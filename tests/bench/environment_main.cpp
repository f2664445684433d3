// How many agents' steps a second does the environment play on one core, with all features observed? The bar is a million in
// spl2012, 4 a side. A random policy may not leave the valid states.
//
//   bench_environment OPTIONS STEPS: plays this number of steps by random actions and prints one line of JSON.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "sim/environment/environment.h"
#include "sim/math/random.h"

namespace {

using namespace sim;
using sim::environment::Environment;

constexpr int kBetweenChecks = 100;  // steps

/// The time that this process has computed [s]: other programs count little.
double computed() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Writes random rows: rules of the menu, or numbers from -1 to 1.
void act_at_random(Environment& games, std::uint32_t step, float rules) {
  std::uint32_t number = 0;
  for (float& action : games.arrays().actions) {
    const float drawn = uniform(draw({step}, kNobody, Draw::situation, number++)[0]);
    action = games.width() == 1 ? std::floor(drawn * rules) : 2 * drawn - 1;
  }
}

int fail(const std::string& sentence) {
  std::fprintf(stderr, "bench_environment: %s\n", sentence.c_str());
  return 2;
}

}  // namespace

int main(int count, char** words) {
  const int steps = count == 3 ? std::atoi(words[2]) : 0;
  if (steps < 1) return fail("expected options as JSON and a number of steps, at least 1");
  const auto opened = Environment::open(words[1]);
  if (!opened) return fail(opened.error());
  Environment& games = **opened;
  const auto options = sim::environment::read_options(words[1]);
  const auto rules = static_cast<float>(options->frame.tree.menu.size());

  double seconds = 0;
  int outside = 0;  // observations beyond -1 .. 1
  for (int step = 0; step < steps; ++step) {
    act_at_random(games, static_cast<std::uint32_t>(step), rules);
    const double begin = computed();
    if (const auto done = games.step(); !done) return fail(done.error());
    seconds += computed() - begin;
    if (step % kBetweenChecks != 0) continue;
    if (const auto valid = games.check(); !valid) return fail(valid.error());
    for (const float value : games.arrays().observations) outside += !(value >= -1 && value <= 1);
  }
  const double agent_steps = static_cast<double>(steps) * games.games() * games.agents();
  std::printf("{\"agent_steps\":%.0f,\"seconds\":%g,\"per_second\":%.0f,\"agents\":%d,\"columns\":%d,\"outside\":%d}\n",
              agent_steps, seconds, agent_steps / seconds, games.agents(), games.columns(), outside);
  return 0;
}
