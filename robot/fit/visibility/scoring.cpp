#include "robot/fit/visibility/scoring.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/fit/visibility/logistic.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFifths = 5, kBins = 10;
constexpr double kLeastProbability = 0.001;

/// Returns the part of each pass.
std::vector<std::size_t> parts_of(const Sights& sights, const std::vector<Group>& passes, bool by_recording) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < passes.size(); ++i)
    parts.push_back(by_recording ? sights.sights[passes[i].front()].recording : i * kFifths / passes.size());
  return parts;
}

/// Writes the probabilities of one part by models that were fitted to the others.
void predict(const Sights& sights, const std::vector<Group>& others, const std::vector<std::size_t>& part,
             const DetectionCurve& standard, SightScores& scores) {
  std::vector<std::size_t> chosen;
  double seen = 0;
  for (const Group& pass : others)
    for (const std::size_t i : pass) chosen.push_back(i), seen += sights.sights[i].seen ? 1 : 0;
  const double constant = chosen.empty() ? 0.5 : seen / static_cast<double>(chosen.size());
  const Logistic logistic = fit_logistic(sights.sights, chosen);
  const DetectionCurve curve = detection_of(sights, others, standard);
  for (const std::size_t i : part) {
    const Sight& sight = sights.sights[i];
    const double all[] = {constant, shown_by(standard, sight), shown_by(curve, sight),
                          logistic.probability(features_of(sight))};
    for (std::size_t k = 0; k < scores.models.size(); ++k)
      scores.models[k].probabilities[i] = std::clamp(all[k], kLeastProbability, 1 - kLeastProbability);
  }
}

void score(const std::vector<Sight>& sights, SightScore& model) {
  for (std::size_t i = 0; i < sights.size(); ++i) {
    const double p = model.probabilities[i];
    model.log_loss -= std::log(sights[i].seen ? p : 1 - p);
    model.brier += std::pow((sights[i].seen ? 1 : 0) - p, 2);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, sights.size()));
  model.log_loss /= count, model.brier /= count;
}

}  // namespace

SightScores scores_of(const Sights& sights, const std::vector<Group>& passes, const DetectionCurve& standard) {
  SightScores scores;
  for (SightScore& model : scores.models) model.probabilities.assign(sights.sights.size(), 0.5);
  const bool by_recording = sights.recordings.size() >= 2;
  const std::size_t count = by_recording ? sights.recordings.size() : kFifths;
  scores.parts = by_recording ? formatted("each of %zu recordings", count) : std::string("each fifth of the passes");
  const std::vector<std::size_t> parts = parts_of(sights, passes, by_recording);
  for (std::size_t part = 0; part < count; ++part) {
    std::vector<Group> others;
    std::vector<std::size_t> held_out;
    for (std::size_t i = 0; i < passes.size(); ++i)
      if (parts[i] == part)
        held_out.insert(held_out.end(), passes[i].begin(), passes[i].end());
      else
        others.push_back(passes[i]);
    if (!held_out.empty()) predict(sights, others, held_out, standard, scores);
  }
  for (SightScore& model : scores.models) score(sights.sights, model);
  return scores;
}

std::vector<ReliabilityBin> reliability(const std::vector<Sight>& sights, const std::vector<double>& probabilities) {
  std::vector<ReliabilityBin> bins(kBins);
  for (std::size_t i = 0; i < sights.size(); ++i) {
    ReliabilityBin& bin = bins[std::min(kBins - 1, static_cast<std::size_t>(probabilities[i] * kBins))];
    bin.predicted += probabilities[i], bin.observed += sights[i].seen ? 1 : 0, ++bin.images;
  }
  std::erase_if(bins, [](const ReliabilityBin& bin) { return bin.images == 0; });
  for (ReliabilityBin& bin : bins) {
    bin.predicted /= static_cast<double>(bin.images);
    bin.observed /= static_cast<double>(bin.images);
  }
  return bins;
}

}  // namespace robot::fit
