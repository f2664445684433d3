#include "sim/learn/visits.h"

#include <cstdlib>
#include <utility>

#include "robot/core/json_library.h"
#include "sim/agent/tree.h"
#include "sim/drills/attempt.h"
#include "sim/io/strategy.h"
#include "sim/io/vocabulary.h"
#include "sim/learn/rules.h"
#include "sim/match/step.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Result;

/// Plays the tree, and remembers the first visit of each leaf. For one game.
class Recorder final : public agent::Behaviour {
 public:
  Recorder(const agent::Tree& tree, const std::vector<agent::Feature>& features)
      : tree_(tree), features_(features), moments_(tree.leaves.size()) {}

  const std::string& name() const override { return tree_.name; }

  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                         agent::Trace* trace) const override {
    const agent::View view(surroundings, tree_.settings, game, beliefs, now, mind);
    if (!agent::plays(game)) return agent::wait(view, mind, trace);
    agent::prepare(view, mind);
    const std::uint16_t leaf = agent::leaf_of(tree_, view);
    if (std::optional<Moment>& moment = moments_[leaf]; !moment) {
      moment.emplace();
      for (const agent::Feature feature : features_) moment->push_back(value_of(feature, view));
    }
    return agent::play_leaf(tree_, leaf, view, mind, trace);
  }

  const std::optional<Moment>& first_visit(std::size_t leaf) const { return moments_[leaf]; }

 private:
  const agent::Tree& tree_;
  const std::vector<agent::Feature>& features_;
  mutable std::vector<std::optional<Moment>> moments_;  // by leaf; used by the thread of its game
};

/// Gives each leaf a name by which its rule is found again. Names do not change what a tree does.
Json with_numbers(Json strategy, std::vector<std::string>& pointers) {
  for_each_rule(Json(strategy), [&](const RulePlace& place, const Json& rule) {
    if (!rule.contains("do")) return;
    strategy.at(Json::json_pointer(place.pointer))["name"] = "#" + std::to_string(pointers.size());
    pointers.push_back(place.pointer);
  });
  return strategy;
}

/// Returns the number in a leaf's path "…/#17/kick".
std::size_t number_in(const std::string& path) {
  return static_cast<std::size_t>(std::strtoull(path.c_str() + path.rfind('#') + 1, nullptr, 10));
}

}  // namespace

Result<std::map<std::string, Visits>> visits_of(const Json& strategy, const Arena::Exercise& exercise,
                                                const std::vector<std::string>& features, std::uint64_t first_seed,
                                                int count, int threads) {
  std::vector<agent::Feature> asked;
  for (const std::string& name : features) {
    const auto feature = io::feature_named(name);
    if (!feature) return feature.failure();
    asked.push_back(*feature);
  }
  std::vector<std::string> pointers;
  const auto tree = io::parse_strategy(with_numbers(strategy, pointers).dump(), "strategy");
  if (!tree) return tree.failure();

  std::vector<std::vector<std::optional<Moment>>> moments(static_cast<std::size_t>(count));  // by attempt and leaf
  contest::for_each_game(count, threads, [&](int attempt) {
    const Recorder recorder(*tree, asked);
    Params params = exercise.params[variant_of(attempt, count, exercise.params.size())];
    params.teams[0].behaviour = &recorder;
    const State start = exercise.starts->draw(params, {first_seed + static_cast<std::uint64_t>(attempt)});
    State state = start;
    drills::Attempt judge(*exercise.drill, start);
    referee::Events events;
    do step(params, state, events);
    while (judge.see(state, events) == drills::Outcome::running);
    for (std::size_t leaf = 0; leaf < tree->leaves.size(); ++leaf)
      moments[static_cast<std::size_t>(attempt)].push_back(recorder.first_visit(leaf));
  });

  std::map<std::string, Visits> visits;
  for (const std::string& pointer : pointers) visits[pointer].resize(static_cast<std::size_t>(count));
  for (std::size_t leaf = 0; leaf < tree->leaves.size(); ++leaf) {
    // a rule of a subtree that is used twice has two leaves
    Visits& of_rule = visits[pointers[number_in(tree->leaf_words[leaf].path)]];
    for (std::size_t attempt = 0; attempt < moments.size(); ++attempt)
      if (!of_rule[attempt]) of_rule[attempt] = moments[attempt][leaf];
  }
  return visits;
}

}  // namespace sim::learn
