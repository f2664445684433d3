// The distances within which a measurement may belong to a thing.
#pragma once

namespace robot::truth {

/// Largest squared Mahalanobis distance of a measurement from its thing: right in 99.97 of 100 cases.
constexpr double kGate = 16;

/// Longest time [s] without a sighting after which a thing keeps its number.
constexpr double kLongestOcclusion = 5;

}  // namespace robot::truth
