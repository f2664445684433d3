#include "sim/learn/tuning.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/learn/cma.h"
#include "sim/math/angles.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Result;

constexpr double kFirstStep = 0.15;    // of each range
constexpr std::size_t kElites = 4;     // the last generations' best, which are evaluated again
constexpr int kHeldOutEvery = 4;       // [generations] between two points of the curve
constexpr int kScreenedAttempts = 64;  // at both ends of each range
constexpr double kFelt = 0.03;         // share of an exercise's attempts that a number must change
constexpr double kClear = 1;           // [standard errors] that a changed number must be worth

/// A range of more than this factor is searched by its logarithm.
constexpr float kWide = 4;
bool by_logarithm(const Knob& knob) { return knob.least > 0 && knob.most > kWide * knob.least; }

double place_of(const Knob& knob, float value) {
  if (!by_logarithm(knob)) return static_cast<double>((value - knob.least) / (knob.most - knob.least));
  return static_cast<double>(sim::log(value / knob.least) / sim::log(knob.most / knob.least));
}

float value_at(const Knob& knob, double place) {
  // reflected at both ends
  double inside = std::abs(std::fmod(place, 2.));
  if (inside > 1) inside = 2 - inside;
  const auto share = static_cast<float>(inside);
  if (!by_logarithm(knob)) return rounded(knob, knob.least + share * (knob.most - knob.least));
  return rounded(knob, knob.least * sim::exp(share * sim::log(knob.most / knob.least)));
}

std::vector<float> values_at(const std::vector<Knob>& knobs, const Vector& point) {
  std::vector<float> values;
  for (std::size_t i = 0; i < knobs.size(); ++i) values.push_back(value_at(knobs[i], point[i]));
  return values;
}

/// One search.
class Tuning {
 public:
  Tuning(const Json& strategy, std::vector<Knob> knobs, const TuningPlan& plan, std::uint64_t seed,
         const Practice& practice)
      : start_(strategy), knobs_(std::move(knobs)), plan_(plan), seed_(seed), practice_(practice) {}

  Result<Learned> run() {
    if (auto screened = screen(); !screened) return screened.failure();
    if (knobs_.empty())
      return Learned{
          .strategy = start_, .changes = {}, .notes = {"no number makes a difference"}, .gain = {}, .curve = {}};
    cma_.emplace(begin(seed_));
    for (int i = 0; i < plan_.generations; ++i) {
      practice_.tell("tuning", static_cast<double>(i) / plan_.generations);
      if (auto done = generation(); !done) return done.failure();
    }
    return select();
  }

 private:
  /// Keeps the knobs that make a difference in the exercises. On the same seeds, a number that no decision meets leaves
  /// every score as it is; it would drift.
  Result<void> screen() {
    practice_.tell("screening", 0);
    std::vector<float> values;
    for (const Knob& knob : knobs_) values.push_back(knob.value);
    std::vector<Json> strategies{start_};
    for (std::size_t i = 0; i < knobs_.size(); ++i)
      for (const double end : {0., 1.}) {
        std::vector<float> other = values;
        other[i] = value_at(knobs_[i], end);
        strategies.push_back(strategy_at(other));
      }
    const std::uint64_t first = practice_.seeds.take(Purpose::training, static_cast<std::uint64_t>(kScreenedAttempts));
    const auto scores = practice_.arena.play(strategies, first, kScreenedAttempts);
    if (!scores) return scores.failure();
    std::vector<Knob> kept;
    for (std::size_t i = 0; i < knobs_.size(); ++i)
      if (std::max(differing((*scores)[0], (*scores)[2 * i + 1]), differing((*scores)[0], (*scores)[2 * i + 2])) >=
          kFelt)
        kept.push_back(knobs_[i]);
    knobs_ = std::move(kept);
    return {};
  }

  /// Returns the share of an exercise's attempts that end otherwise, of the exercise with most of them.
  static double differing(const Scores& a, const Scores& b) {
    double most = 0;
    for (std::size_t e = 0; e < a.size(); ++e) {
      int count = 0;
      for (std::size_t i = 0; i < a[e].size(); ++i) count += a[e][i] == b[e][i] ? 0 : 1;
      most = std::max(most, static_cast<double>(count) / static_cast<double>(a[e].size()));
    }
    return most;
  }

  Cma begin(std::uint64_t seed) const {
    Vector start;
    for (const Knob& knob : knobs_) start.push_back(place_of(knob, knob.value));
    const int population = std::max(10, Cma::usual_population(start.size()));
    return {std::move(start), kFirstStep, population, seed};
  }

  Json strategy_at(const std::vector<float>& values) const { return with_values(start_, knobs_, values); }

  Result<void> generation() {
    const std::vector<Vector> points = cma_->ask();
    std::vector<Json> strategies{start_};
    for (const Vector& point : points) strategies.push_back(strategy_at(values_at(knobs_, point)));
    const auto scores = practice_.play(strategies, Purpose::training, plan_.attempts);
    if (!scores) return scores.failure();
    Vector costs;
    for (const Scores& each : *scores) costs.push_back(-practice_.arena.value_of(each));
    const double start = -costs.front();
    costs.erase(costs.begin());
    const auto best = static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());
    elites_.push_back(values_at(knobs_, points[best]));
    if (elites_.size() > kElites) elites_.erase(elites_.begin());
    cma_->tell(costs);
    if (cma_->generation() % kHeldOutEvery == 0 || cma_->generation() == plan_.generations)
      return add_to_curve(-costs[best] - start);
    return {};
  }

  /// `training` is the gain of the generation's best candidate on its own seeds.
  Result<void> add_to_curve(double training) {
    const auto scores =
        practice_.play({start_, strategy_at(values_at(knobs_, cma_->mean()))}, Purpose::held_out, plan_.attempts);
    if (!scores) return scores.failure();
    const contest::Mean gain = practice_.arena.gain_of((*scores)[0], (*scores)[1]);
    curve_.push_back({cma_->generation(), training, gain.mean, gain.error});
    return {};
  }

  /// The first round chooses among the mean and the elites, the second one tests the choice.
  Result<Learned> select() {
    Learned learned{.strategy = start_, .changes = {}, .notes = {}, .gain = {}, .curve = curve_};
    std::vector<std::vector<float>> choices{values_at(knobs_, cma_->mean())};
    choices.insert(choices.end(), elites_.begin(), elites_.end());
    std::vector<Json> strategies;
    for (const auto& values : choices) strategies.push_back(strategy_at(values));
    const auto first = practice_.play(strategies, Purpose::selection, plan_.selection);
    if (!first) return first.failure();
    Vector costs;
    for (const Scores& scores : *first) costs.push_back(-practice_.arena.value_of(scores));
    const auto best = static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());

    const auto second = practice_.play({start_, strategies[best]}, Purpose::selection, plan_.test);
    if (!second) return second.failure();
    learned.gain = practice_.arena.gain_of((*second)[0], (*second)[1]);
    learned.notes.push_back(robot::formatted("tuned %zu numbers in %d generations: gain %+.3f ± %.3f%s", knobs_.size(),
                                             plan_.generations, learned.gain.mean, kSure * learned.gain.error,
                                             is_sure(learned.gain) ? "" : ", not kept"));
    if (!is_sure(learned.gain)) return learned;
    return simplified(std::move(learned), choices[best]);
  }

  /// Puts back each number that makes no clear difference, if the result still wins on new seeds.
  Result<Learned> simplified(Learned learned, const std::vector<float>& values) {
    learned.strategy = strategy_at(values), learned.changes = changes(knobs_, values);
    std::vector<std::size_t> changed;
    std::vector<Json> strategies{learned.strategy};
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
      if (values[i] == knobs_[i].value) continue;
      std::vector<float> other = values;
      other[i] = knobs_[i].value;
      changed.push_back(i);
      strategies.push_back(strategy_at(other));
    }
    const auto without = practice_.play(strategies, Purpose::selection, plan_.selection);
    if (!without) return without.failure();
    std::vector<float> simple = values;
    for (std::size_t k = 0; k < changed.size(); ++k) {
      const contest::Mean worth = practice_.arena.gain_of((*without)[k + 1], (*without)[0]);
      if (worth.mean < kClear * worth.error) simple[changed[k]] = knobs_[changed[k]].value;
    }
    if (simple == values) return learned;
    const auto test = practice_.play({start_, learned.strategy, strategy_at(simple)}, Purpose::selection, plan_.test);
    if (!test) return test.failure();
    const contest::Mean gain = practice_.arena.gain_of((*test)[0], (*test)[2]);
    const contest::Mean lost = practice_.arena.gain_of((*test)[2], (*test)[1]);
    if (!is_sure(gain) || is_sure(lost)) return learned;
    learned.strategy = strategy_at(simple), learned.changes = changes(knobs_, simple), learned.gain = gain;
    learned.notes.push_back(robot::formatted("%zu of %zu changed numbers are worth it: gain %+.3f ± %.3f",
                                             learned.changes.size(), changed.size(), gain.mean, kSure * gain.error));
    return learned;
  }

  const Json& start_;
  std::vector<Knob> knobs_;
  const TuningPlan plan_;
  const std::uint64_t seed_;
  const Practice& practice_;
  std::optional<Cma> cma_;
  std::vector<std::vector<float>> elites_;
  std::vector<CurvePoint> curve_;
};

}  // namespace

Result<Learned> tune(const Json& strategy, const Layer& layer, const TuningPlan& plan, std::uint64_t seed,
                     const Practice& practice) {
  auto all = knobs_of(strategy, practice.arena.diagonal());
  if (!all) return all.failure();
  std::erase_if(*all, [&](const Knob& knob) { return !layer.has(knob); });
  if (all->empty())
    return Learned{.strategy = strategy, .changes = {}, .notes = {"no number of this layer"}, .gain = {}, .curve = {}};
  return Tuning(strategy, *std::move(all), plan, seed, practice).run();
}

}  // namespace sim::learn
