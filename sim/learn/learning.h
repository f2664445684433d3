// Layered learning of a strategy: layer by layer, then the seams between them, then the gate.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/contest/contest.h"
#include "sim/learn/arena.h"
#include "sim/learn/layer.h"
#include "sim/learn/share.h"
#include "sim/learn/step.h"

namespace sim::learn {

struct LearnChoice {
  std::string strategy;             // name or file
  std::vector<std::string> layers;  // names or files, from the lowest on
  double minutes = 10;              // the budget, see Budget
  std::uint64_t seed = 1;           // 0 .. Seeds::kMostRun
  World world;
  std::vector<std::string> unseen;  // opponents that only the gate plays
  bool shuffled = false;            // the control run: rewards are dealt by chance
  std::int64_t most_pairs = 4000;   // of the gate's sequential test
  double wanted = 0.1;              // [goals a game] the gain that the test must tell from none
  std::filesystem::path folder;     // of the run: go on with it; empty: none
  Share share;                      // of this process, if several play the run; they need the folder
  std::string name;                 // of the learned strategy
};

/// The number of games that a run plays: as many simulated seconds as two cores of a laptop play in the given minutes. It
/// depends on nothing else, so the same choice gives the same tree on every machine.
struct Budget {
  double seconds = 0;  // simulated

  static Budget of_minutes(double minutes);
};

/// The report of a layer or a seam.
struct Lesson {
  std::string name, about;
  std::vector<Change> changes;
  std::vector<std::string> notes;
  std::vector<CurvePoint> curve;
  /// The success of an exercise on seeds that chose nothing: before and after.
  struct Success {
    std::string exercise;
    int attempts = 0, before = 0, after = 0;
    contest::Mean gain;  // of the share
  };
  std::vector<Success> successes;
};

/// The gate's answer about one opponent.
struct Against {
  std::string opponent;  // empty: the start itself
  contest::Outcome outcome;
  bool passed = false;
};

struct Course {
  io::Json start, learned;
  std::vector<Change> changes;  // of the whole run
  std::vector<Lesson> lessons;
  std::vector<Against> gate;  // none if nothing changed, or if another process plays it
  bool better = false;        // the gate is passed
  std::uint64_t first_test_seed = 0;
};

/// Learns. The result depends on the choice only: not on threads or processes, nor on kills between. `tell` may be called
/// often.
robot::Result<Course> learn(const LearnChoice& choice, const Tell& tell);

}  // namespace sim::learn
