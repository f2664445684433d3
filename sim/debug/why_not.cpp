#include "sim/debug/why_not.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace sim::debug {

using agent::Feature;
using agent::FeatureInfo;
using Kind = FeatureInfo::Kind;

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Returns the size of a change, by the rule of WhyNot::values.
float size_of(const FeatureInfo& info, float before, float after) {
  if (std::isnan(before) || std::isnan(after) || info.kind != Kind::number) return 1;
  return std::abs(after - before) / scale_of(info);
}

/// Returns all features that are compared with this one, directly or over others, and itself.
std::set<Feature> compared_with(const agent::Tree& tree, Feature feature) {
  std::set<Feature> all{feature};
  for (std::size_t before = 0; before != all.size();) {
    before = all.size();
    for (const agent::Node& node : tree.nodes) {
      if (node.other == agent::kNoFeature) continue;
      if (all.contains(node.feature)) all.insert(node.other);
      if (all.contains(node.other)) all.insert(node.feature);
    }
  }
  return all;
}

/// Adds values of an open cell (low, high): the one that is nearest to `value`, which is outside. Of `count` > 1 features
/// that are compared with each other it adds that many at each end, so that any order of them is possible.
void add_cell(float low, float high, float value, bool whole, std::size_t count, std::set<float>& values) {
  if (count == 1 && value > low && value < high) return;
  for (const bool from_above : {true, false}) {
    if (count == 1 && from_above != (value >= high)) continue;
    float at = from_above ? high : low;
    for (std::size_t i = 0; i < count; ++i) {
      at = nearest_passing(from_above ? agent::Comparison::less : agent::Comparison::greater, agent::kUnknown, at,
                           whole);
      if (at > low && at < high) values.insert(at);
    }
  }
}

/// Searches with at most `most` changed features.
class Search {
 public:
  Search(const agent::Tree& tree, const Values& values, const Goal& goal)
      : tree_(tree), values_(values), ball_known_(agent::find_feature("ball_known")), leads_(tree.nodes.size()) {
    goal_ = goal;
    candidates_.resize(values.size());
    for (const agent::Node& node : tree.nodes)
      for (const Feature feature : {node.feature, node.other}) {
        if (feature == agent::kNoFeature || !candidates_[index_of(feature)].empty()) continue;
        candidates_[index_of(feature)] = candidates_of(tree, values, feature);
        ++features_;
      }
    if (candidates_[index_of(ball_known_)].empty())
      candidates_[index_of(ball_known_)] = {1 - values[index_of(ball_known_)]}, ++features_;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) leads_[i] = leads(tree.nodes[i].yes) || leads(tree.nodes[i].no);
    state_.resize(values.size());
  }

  std::size_t features() const { return features_; }

  /// Finds the smallest change of at most `most` features, or with `any` the first one found.
  void run(std::size_t most, bool any) {
    most_ = most, any_ = any;
    found_.reset();
    visit(tree_.root, 0);
  }

  bool gave_up() const { return visits_ > kMostVisits; }
  const std::optional<std::vector<NewValue>>& found() const { return found_; }

 private:
  /// The decision about a feature on the present path.
  struct Decided {
    enum class How : std::uint8_t { undecided, kept, changed } how = How::undecided;
    std::vector<float> left;  // kept: its value; changed: the values that are still possible
  };
  using How = Decided::How;

  bool leads(std::uint16_t at) const {
    return at & agent::kLeafBit ? goal_[at & ~agent::kLeafBit] : static_cast<bool>(leads_[at]);
  }
  bool done() const { return gave_up() || (any_ && found_); }

  Decided& of(Feature feature) { return state_[index_of(feature)]; }

  /// Calls go() once for each way to decide the feature; undoes it afterwards.
  void decide(Feature feature, std::size_t changed, const std::function<void(std::size_t)>& go) {
    if (of(feature).how != How::undecided) return go(changed);
    const FeatureInfo& info = info_of(feature);
    if (info.needs_ball && of(ball_known_).how == How::undecided)
      return decide(ball_known_, changed, [&](std::size_t now) { decide(feature, now, go); });
    const float value = values_[index_of(feature)];
    const auto with = [&](How how, std::vector<float> left, std::size_t now) {
      of(feature) = {how, std::move(left)};
      go(now);
      of(feature) = {};
    };

    // a feature of the ball follows from whether the ball is known
    const bool was_known = values_[index_of(ball_known_)] > 0.5f;
    const bool is_known = info.needs_ball ? of(ball_known_).left.front() > 0.5f : was_known;
    if (info.needs_ball && !is_known) return with(How::kept, {agent::kUnknown}, changed);
    const bool newly_known = info.needs_ball && !was_known;
    if (!newly_known || info.at_times_unknown) with(How::kept, {value}, changed);
    const std::vector<float>& candidates = candidates_[index_of(feature)];
    if (changed < most_ && !candidates.empty() && !done()) with(How::changed, candidates, changed + 1);
  }

  void visit(std::uint16_t at, std::size_t changed) {
    if (done()) return;
    ++visits_;
    if (!leads(at)) return;
    if (at & agent::kLeafBit) return keep_best();
    const agent::Node& node = tree_.nodes[at];
    decide(node.feature, changed, [&](std::size_t now) {
      if (node.other == agent::kNoFeature)
        return split(node, node.feature, now,
                     [&](float value) { return holds(node.comparison, value, node.threshold); });
      decide(node.other, now, [&](std::size_t both) {
        // one side after the other, so that the comparison is with a number
        const std::vector<float> left = of(node.feature).left;
        for (const float value : left) {
          of(node.feature).left = {value};
          split(node, node.other, both, [&](float threshold) { return holds(node.comparison, value, threshold); });
        }
        of(node.feature).left = left;
      });
    });
  }

  /// Goes on with those values of the feature that pass, and with those that do not.
  template <class Passes>
  void split(const agent::Node& node, Feature feature, std::size_t changed, Passes&& passes) {
    const std::vector<float> left = of(feature).left;
    for (const bool result : {true, false}) {
      std::vector<float> those;
      for (const float value : left)
        if (passes(value) == result) those.push_back(value);
      if (those.empty()) continue;
      of(feature).left = std::move(those);
      visit(result ? node.yes : node.no, changed);
    }
    of(feature).left = left;
  }

  /// Takes the nearest of the possible values of each changed feature.
  void keep_best() {
    std::vector<NewValue> changes;
    float size = 0;
    for (std::size_t i = 0; i < state_.size(); ++i) {
      if (state_[i].how != How::changed) continue;
      const auto feature = static_cast<Feature>(i);
      const FeatureInfo& info = info_of(feature);
      const float before = values_[i];
      // known values come first
      const auto nearest = std::ranges::min_element(
          state_[i].left, {}, [&](float after) { return std::pair(std::isnan(after), size_of(info, before, after)); });
      changes.push_back({feature, before, *nearest});
      size += size_of(info, before, *nearest);
    }
    if (found_ && (changes.size() > found_->size() || (changes.size() == found_->size() && size >= size_))) return;
    found_ = std::move(changes);
    size_ = size;
  }

  const agent::Tree& tree_;
  const Values& values_;
  const Feature ball_known_;
  Goal goal_;
  std::vector<bool> leads_;                     // by node: some path from it ends at the goal
  std::vector<std::vector<float>> candidates_;  // by feature
  std::vector<Decided> state_;                  // by feature
  std::size_t features_ = 0, most_ = 0;
  bool any_ = false;
  std::int64_t visits_ = 0;
  std::optional<std::vector<NewValue>> found_;
  float size_ = 0;
};

}  // namespace

std::vector<float> candidates_of(const agent::Tree& tree, const Values& values, Feature feature) {
  const FeatureInfo& info = info_of(feature);
  const float now = values[index_of(feature)];
  std::vector<float> all;
  if (info.fixed) return all;
  const auto add = [&](float value) {
    if (value >= info.least && value <= info.most && value != now) all.push_back(value);
  };
  if (info.kind != Kind::number) {
    for (float value = info.least; value <= info.most; value += 1) add(value);
  } else {
    const bool whole = counts(info);
    const std::set<Feature> connected = compared_with(tree, feature);
    std::set<float> cuts;
    for (const agent::Node& node : tree.nodes)
      if (connected.contains(node.feature) && node.other == agent::kNoFeature) cuts.insert(node.threshold);
    if (connected.size() > 1)
      for (const Feature other : connected)
        if (const float value = values[index_of(other)]; !std::isnan(value)) cuts.insert(value);
    std::set<float> those;
    const float low = std::nextafter(info.least, -kFar), high = std::nextafter(info.most, kFar);
    float before = low;
    for (const float cut : cuts) {
      add_cell(before, cut, now, whole, connected.size(), those);
      if (!whole || cut == std::floor(cut)) those.insert(cut);
      before = std::max(before, cut);
    }
    add_cell(before, high, now, whole, connected.size(), those);
    for (const float value : those) add(value);
  }
  if (info.at_times_unknown && !std::isnan(now)) all.push_back(agent::kUnknown);
  return all;
}

Values with_values(Values values, const std::vector<NewValue>& changes) {
  for (const NewValue& change : changes) values[index_of(change.feature)] = change.after;
  if (values[index_of(agent::find_feature("ball_known"))] < 0.5f)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (info_of(static_cast<Feature>(i)).needs_ball) values[i] = agent::kUnknown;
  return values;
}

WhyNot why_not(const agent::Tree& tree, const Values& values, const Goal& goal) {
  WhyNot answer;
  answer.leaf = leaf_of(tree, values);
  if (goal[answer.leaf]) return answer;
  Search search(tree, values, goal);
  // any way at all, then the smallest number of features that has one
  search.run(search.features(), true);
  if (!search.found()) {
    answer.kind = search.gave_up() ? WhyNot::Kind::unsure : WhyNot::Kind::unreachable;
    return answer;
  }
  std::vector<NewValue> best = *search.found();
  for (std::size_t most = 1; most <= best.size() && !search.gave_up(); ++most) {
    search.run(most, false);
    if (!search.found()) continue;
    best = *search.found();
    break;
  }
  answer.kind = WhyNot::Kind::changed;
  answer.values = std::move(best);
  answer.leaf = leaf_of(tree, with_values(values, answer.values));
  return answer;
}

}  // namespace sim::debug
