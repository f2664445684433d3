// How well models predict whether a ball is seen, on images that they were not fitted to. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "robot/fit/visibility/detection.h"
#include "robot/fit/visibility/sights.h"

namespace robot::fit {

/// The models that are compared.
enum class SightModel : std::size_t { constant, standard, detection, logistic };
inline constexpr std::array<const char*, 4> kSightModels{"constant", "default detection", "fitted detection",
                                                         "logistic"};

/// One model's probabilities on images held out.
struct SightScore {
  std::vector<double> probabilities;  // of each sight
  double log_loss = 0, brier = 0;     // means over all sights; a probability is at least 0.1 % and at most 99.9 %
};

struct SightScores {
  std::array<SightScore, 4> models;  // by SightModel
  std::string parts;                 // how images were held out: "each of 3 recordings"
};

/// Holds out each recording in turn, or each fifth of the passes of a single one.
SightScores scores_of(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard);

/// Images with nearly the same probability.
struct ReliabilityBin {
  double predicted = 0, observed = 0;  // means
  std::size_t images = 0;
};

/// Returns the bins of a tenth each that have images.
std::vector<ReliabilityBin> reliability(const std::vector<Sight>& sights, const std::vector<double>& probabilities);

}  // namespace robot::fit
