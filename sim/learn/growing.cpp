#include "sim/learn/growing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/vocabulary.h"
#include "sim/learn/edit.h"
#include "sim/learn/visits.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Result;

constexpr double kOften = 0.05;         // a leaf counts if it is visited in this share of the attempts
constexpr int kFewestOnASide = 15;      // attempts on either side of a threshold
constexpr int kQuantiles = 8;           // thresholds that are tried for a feature
constexpr double kPromising = 1.5;      // [standard errors] of the gain in training
constexpr double kWorthNothing = 0.01;  // [points] a rule whose removal surely costs less goes

/// A condition on one feature.
struct Split {
  std::string feature;
  bool below = true;
  float threshold = 0;

  bool holds(float value) const { return below ? value < threshold : value > threshold; }
};

/// A change that may be an improvement.
struct Candidate {
  std::string pointer;  // of the leaf's rule
  Json action;
  std::optional<Split> split;  // absent: the action replaces the leaf's
  double promise = 0;          // [standard errors] of its gain in training
  Change change;
};

/// The gains of an action at a leaf: one for each attempt at each exercise, with the moment of the first visit.
struct Gains {
  std::vector<double> gain;
  std::vector<const Moment*> moment;  // nullptr: not visited
  std::vector<double> weight;         // of the exercise

  /// Returns the gain in standard errors if the action is taken where `takes(moment)` is true.
  template <class Takes>
  double promise(Takes&& takes) const {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < gain.size(); ++i) {
      if (!moment[i] || !takes(*moment[i])) continue;
      const double weighted = weight[i] * gain[i];
      sum += weighted, squares += weighted * weighted;
    }
    return squares > 0 ? sum / std::sqrt(squares) : 0;
  }
};

/// Returns the value nearest to `value` that a person would write as a threshold of the feature, and its text.
std::pair<float, std::string> written(const std::string& feature, float value) {
  const agent::FeatureInfo& info = info_of(agent::find_feature(feature));
  Knob knob{.name = "",
            .place = "",
            .expected = io::expected_of(info),
            .least = value - 1,
            .most = value + 1,
            .skills = {},
            .features = {}};
  if (knob.expected.most <= 4) knob.least = value - 0.5f, knob.most = value + 0.5f;
  const float nearest = rounded(knob, value);
  return {nearest, text_of(knob, nearest)};
}

std::string text_of(const Split& split) {
  return split.feature + (split.below ? " < " : " > ") + written(split.feature, split.threshold).second;
}

/// Returns the split with which the action promises most, and its promise.
std::pair<std::optional<Split>, double> best_split(const Gains& gains, const std::vector<std::string>& features) {
  std::pair<std::optional<Split>, double> best{std::nullopt, gains.promise([](const Moment&) { return true; })};
  for (std::size_t f = 0; f < features.size(); ++f) {
    std::vector<float> values;
    for (const Moment* moment : gains.moment)
      if (moment && !std::isnan((*moment)[f])) values.push_back((*moment)[f]);
    std::ranges::sort(values);
    for (int q = 1; q < kQuantiles && !values.empty(); ++q) {
      const std::size_t place = values.size() * static_cast<std::size_t>(q) / kQuantiles;
      if (place < kFewestOnASide || values.size() - place < kFewestOnASide) continue;
      const float threshold = written(features[f], values[place]).first;
      for (const bool below : {true, false}) {
        const Split split{features[f], below, threshold};
        const double promise = gains.promise([&](const Moment& moment) { return split.holds(moment[f]); });
        if (promise > best.second) best = {split, promise};
      }
    }
  }
  return best;
}

/// Learns the structure of one layer.
class Growing {
 public:
  Growing(const Json& strategy, const Layer& layer, const GrowingPlan& plan, const Practice& practice)
      : layer_(layer), plan_(plan), practice_(practice), features_(features_of(strategy, layer)) {
    learned_.strategy = strategy;
  }

  Result<Learned> run() {
    if (auto found = find_changes(); !found) return found.failure();
    if (auto tested = test_changes(); !tested) return tested.failure();
    if (auto pruned = prune(); !pruned) return pruned.failure();
    return std::move(learned_);
  }

 private:
  /// Returns the features of new conditions: those of the marks, or else of the layer. Only numbers split a leaf.
  static std::vector<std::string> features_of(const Json& strategy, const Layer& layer) {
    std::vector<std::string> names = layer.conditions;
    if (strategy.contains("learn")) names = strategy["learn"]["conditions"].get<std::vector<std::string>>();
    std::erase_if(names, [](const std::string& name) {
      return info_of(agent::find_feature(name)).kind != agent::FeatureInfo::Kind::number;
    });
    return names;
  }

  /// Plays each (leaf, action) on the same seeds, and finds for each leaf the change that promises most.
  Result<void> find_changes() {
    const std::vector<LeafRule> leaves = leaves_of(learned_.strategy, layer_);
    const std::uint64_t first = practice_.seeds.take(Purpose::training, static_cast<std::uint64_t>(plan_.attempts));
    // the visits of each exercise
    std::vector<std::map<std::string, Visits>> visits;
    for (std::size_t e = 0; e < practice_.arena.size(); ++e) {
      const Arena::Exercise& exercise = practice_.arena.exercise(e);
      if (exercise.is_game) {
        visits.emplace_back();  // a game visits every leaf soon; its attempts part too early
        continue;
      }
      auto seen = visits_of(learned_.strategy, exercise, features_, first, plan_.attempts, practice_.arena.threads());
      if (!seen) return seen.failure();
      visits.push_back(*std::move(seen));
    }
    int tried = 0;
    for (std::size_t l = 0; l < leaves.size(); ++l) {
      practice_.tell("values of actions", static_cast<double>(l) / static_cast<double>(leaves.size()));
      if (!is_visited(leaves[l].pointer, visits)) continue;
      visited_.insert(leaves[l].pointer);
      tried += static_cast<int>(leaves[l].alternatives.size());
      if (auto found = find_change(leaves[l], visits, first); !found) return found.failure();
    }
    std::ranges::stable_sort(candidates_, std::ranges::greater{}, &Candidate::promise);
    if (candidates_.size() > static_cast<std::size_t>(plan_.most))
      candidates_.resize(static_cast<std::size_t>(plan_.most));
    learned_.notes.push_back(robot::formatted("%d actions at %zu leaves: %zu changes promise a gain", tried,
                                              visited_.size(), candidates_.size()));
    return {};
  }

  bool is_visited(const std::string& pointer, const std::vector<std::map<std::string, Visits>>& visits) const {
    for (const auto& of_exercise : visits)
      if (const auto found = of_exercise.find(pointer); found != of_exercise.end()) {
        const auto count = std::ranges::count_if(found->second, [](const auto& moment) { return moment.has_value(); });
        if (static_cast<double>(count) >= kOften * plan_.attempts) return true;
      }
    return false;
  }

  Result<void> find_change(const LeafRule& leaf, const std::vector<std::map<std::string, Visits>>& visits,
                           std::uint64_t first) {
    std::vector<Json> strategies{learned_.strategy};
    for (const Json& action : leaf.alternatives)
      strategies.push_back(with_action(learned_.strategy, leaf.pointer, action));
    const auto scores = practice_.play_on(strategies, first, plan_.attempts);
    if (!scores) return scores.failure();
    Candidate best;
    for (std::size_t a = 0; a < leaf.alternatives.size(); ++a) {
      const Gains gains = gains_of((*scores)[0], (*scores)[a + 1], visits, leaf.pointer);
      auto [split, promise] = best_split(gains, features_);
      if (promise <= best.promise) continue;
      best = {leaf.pointer,
              leaf.alternatives[a],
              split,
              promise,
              {leaf.name, words_of(leaf.action), words_of(leaf.alternatives[a])}};
      if (split) best.change.after += " when " + text_of(*split);
    }
    if (best.promise > kPromising) candidates_.push_back(std::move(best));
    return {};
  }

  Gains gains_of(const Scores& own, const Scores& other, const std::vector<std::map<std::string, Visits>>& visits,
                 const std::string& pointer) const {
    Gains gains;
    for (std::size_t e = 0; e < own.size(); ++e) {
      const auto of_leaf = visits[e].find(pointer);
      if (of_leaf == visits[e].end()) continue;
      for (std::size_t i = 0; i < own[e].size(); ++i) {
        gains.gain.push_back(static_cast<double>(other[e][i].points) - static_cast<double>(own[e][i].points));
        gains.moment.push_back(of_leaf->second[i] ? &*of_leaf->second[i] : nullptr);
        gains.weight.push_back(practice_.arena.exercise(e).weight);
      }
    }
    return gains;
  }

  /// Tests each change on seeds of its own, upon those that are kept. One leaf has one change, so pointers stay valid but
  /// for those behind a new rule in the same list: the changes go from the last rule to the first.
  Result<void> test_changes() {
    const int tests = static_cast<int>(candidates_.size());
    std::ranges::stable_sort(candidates_, std::ranges::greater{},
                             [](const Candidate& candidate) { return place_in_list(candidate.pointer); });
    for (int i = 0; i < tests; ++i) {
      practice_.tell("testing changes", static_cast<double>(i) / tests);
      const auto& [pointer, action, split, promise, change] = candidates_[static_cast<std::size_t>(i)];
      const Json changed = split ? with_split(learned_.strategy, pointer, text_of(*split), action)
                                 : with_action(learned_.strategy, pointer, action);
      const auto gain = tested(changed);
      if (!gain) return gain.failure();
      const bool kept = is_sure(*gain, tests);
      learned_.notes.push_back(robot::formatted("%s: gain %+.3f ± %.3f%s", text_of(change).c_str(), gain->mean,
                                                kSure * gain->error, kept ? "" : ", not kept"));
      if (!kept) continue;
      learned_.strategy = changed;
      learned_.changes.push_back(change);
      learned_.gain = *gain;
    }
    return {};
  }

  /// Returns the number of the rule in its list, or 0.
  static std::uint64_t place_in_list(const std::string& pointer) {
    return std::strtoull(pointer.c_str() + pointer.rfind('/') + 1, nullptr, 10);
  }

  Result<contest::Mean> tested(const Json& changed) const {
    const auto scores = practice_.play({learned_.strategy, changed}, Purpose::selection, plan_.selection);
    if (!scores) return scores.failure();
    return practice_.arena.gain_of((*scores)[0], (*scores)[1]);
  }

  /// Removes rules that the exercises visit and whose removal surely costs almost nothing.
  Result<void> prune() {
    std::vector<SpareRule> spare = spare_rules(learned_.strategy, layer_);
    std::erase_if(spare, [&](const SpareRule& rule) { return !visited_.contains(rule.pointer); });
    std::ranges::reverse(spare);  // so that the places of the rest stay
    for (std::size_t i = 0; i < spare.size(); ++i) {
      practice_.tell("pruning", static_cast<double>(i) / static_cast<double>(spare.size()));
      const Json pruned = without_rule(learned_.strategy, spare[i].pointer);
      const auto gain = tested(pruned);
      if (!gain) return gain.failure();
      const bool goes = gain->mean >= 0 && gain->error > 0 && gain->mean - kSure * gain->error > -kWorthNothing;
      if (!goes) continue;
      learned_.notes.push_back(
          robot::formatted("without %s: gain %+.3f ± %.3f", spare[i].name.c_str(), gain->mean, kSure * gain->error));
      learned_.strategy = pruned;
      learned_.changes.push_back({spare[i].name, "", ""});
    }
    return {};
  }

  const Layer& layer_;
  const GrowingPlan plan_;
  const Practice& practice_;
  const std::vector<std::string> features_;
  std::set<std::string> visited_;  // leaves by pointer
  std::vector<Candidate> candidates_;
  Learned learned_;
};

}  // namespace

Result<Learned> grow(const Json& strategy, const Layer& layer, const GrowingPlan& plan, const Practice& practice) {
  return Growing(strategy, layer, plan, practice).run();
}

}  // namespace sim::learn
