// The search that both tuners share: CMA-ES whose points are judged on two threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include "sim/learn/cma.h"

namespace robot::nao::walk {

/// The settings of a search. It begins at the origin.
struct Search {
  std::size_t dimensions;
  double step;
  int population;
  std::uint64_t first_seed;
  int generations;
};

/// Searches the lowest cost(judge, point, first_seed). Each thread has one of the judges; each generation meets seeds of its
/// own. Prints each generation, then calls tell(mean).
template <class Judge, class Cost, class Tell>
void run(const Search& what, std::array<Judge, 2>& judges, Cost&& cost, Tell&& tell) {
  sim::learn::Cma search(sim::learn::Vector(what.dimensions, 0.0), what.step, what.population, what.first_seed);
  for (int generation = 0; generation < what.generations; ++generation) {
    const auto points = search.ask();
    std::vector<double> costs(points.size());
    const std::uint64_t seed = what.first_seed + static_cast<std::uint64_t>(generation) * 1000;
    const auto judge = [&](std::size_t thread) {
      for (std::size_t i = thread; i < points.size(); i += judges.size())
        costs[i] = cost(judges[thread], points[i], seed);
    };
    std::thread second([&] { judge(1); });
    judge(0);
    second.join();
    search.tell(costs);
    std::printf("// generation %d: best %.3f, worst %.3f, deviation %.3f\n", generation,
                *std::min_element(costs.begin(), costs.end()), *std::max_element(costs.begin(), costs.end()),
                search.deviation());
    tell(search.mean());
    std::fflush(stdout);
  }
}

}  // namespace robot::nao::walk
