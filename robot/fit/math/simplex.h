// The least value of a function of a few parameters, without derivatives: for likelihoods.
#pragma once

#include <functional>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {

/// Returns parameters with a least value that a descent from `start` reaches (Nelder and Mead 1965). `steps` are the first
/// steps of each parameter. Infinity keeps a parameter within its bounds. Deterministic.
Vector least_of(const std::function<double(const Vector& parameters)>& value, const Vector& start, const Vector& steps);

}  // namespace robot::fit
