// The first visits of a tree's leaves in each attempt at a drill, with what the robot believed there.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "sim/learn/arena.h"

namespace sim::learn {

/// The features of a moment, in the order in which they were asked for. NaN: the robot did not know it.
using Moment = std::vector<float>;

/// For each attempt the moment of the first visit, if there was one.
using Visits = std::vector<std::optional<Moment>>;

/// Plays attempts at one exercise on `count` seeds, and records the visits of each leaf. The leaves are named by their
/// rules' JSON pointers. `features` are names of features.
robot::Result<std::map<std::string, Visits>> visits_of(const io::Json& strategy, const Arena::Exercise& exercise,
                                                       const std::vector<std::string>& features,
                                                       std::uint64_t first_seed, int count, int threads);

}  // namespace sim::learn
