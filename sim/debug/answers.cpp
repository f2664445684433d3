#include "sim/debug/answers.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "robot/core/text.h"
#include "sim/io/words.h"

namespace sim::debug {
namespace {

using robot::formatted;

constexpr const char* kDoing[] = {"stands",   "starts", "walks", "stops",   "kicks",
                                  "crouches", "squats", "lies",  "gets up", "is off the field"};

double shown(float value) { return static_cast<double>(value); }

std::string features_text(const WhyNot& answer, const agent::Tree& tree) {
  const bool one = answer.values.size() == 1;
  std::string text = std::to_string(answer.values.size()) +
                     (one ? " feature would have to be different:\n" : " features would have to be different:\n");
  for (const NewValue& change : answer.values)
    text +=
        formatted("  %-24s %12s -> ", info_of(change.feature).name, value_text(change.feature, change.before).c_str()) +
        bound_text(change) + "\n";
  return text + "  leads to " + leaf_text(tree, answer.leaf) + "\n";
}

std::string thresholds_text(const std::vector<NewThreshold>& changes, const agent::Tree& tree) {
  const bool one = changes.size() == 1;
  std::string text =
      "or " + std::to_string(changes.size()) + (one ? " threshold of the tree:\n" : " thresholds of the tree:\n");
  for (const NewThreshold& change : changes) {
    const agent::Feature feature = tree.nodes[change.node].feature;
    text += formatted("  node %-4d %-30s %12s -> ", change.node, tree.node_words[change.node].condition.c_str(),
                      value_text(feature, change.before).c_str()) +
            value_text(feature, change.after) + "\n";
  }
  return text;
}

}  // namespace

robot::Result<Goal> goal_of(const std::string& text, const agent::Tree& tree) {
  Goal goal(tree.leaves.size());
  bool any = false;
  for (std::size_t i = 0; i < goal.size(); ++i) {
    const agent::Words& words = tree.leaf_words[i];
    if (words.name == text || words.path == text || words.path.starts_with(text + "/")) goal[i] = any = true;
  }
  for (std::size_t i = 0; i < goal.size() && text.size() > 2; ++i)
    if (tree.leaf_words[i].path.find("/" + text + "/") != std::string::npos) goal[i] = any = true;
  if (any) return goal;
  std::vector<std::string_view> known;
  for (const agent::Words& words : tree.leaf_words)
    if (std::ranges::find(known, words.name) == known.end()) known.emplace_back(words.name);
  std::string all;
  for (const std::string_view name : known) all.append(all.empty() ? "" : ", ").append(name);
  const std::string hint = io::did_you_mean(text, known);
  return robot::Error{"strategy '" + tree.name + "' has no skill or rule '" + text + "'" +
                      (hint.empty() ? "; its skills are: " + all : hint)};
}

robot::Result<Alternative> alternative_to(const Params& params, const agent::Tree& tree, const Decision& decision,
                                          const Goal& goal, const std::string& name) {
  if (!agent::plays(decision.game))
    return robot::Error{name + " asks its tree nothing, because " +
                        (decision.game.penalised ? "it is penalised" : "the ball is not in play")};
  const Thought thought(params, tree, decision);
  const Values values = values_of(tree, thought.view());
  Alternative answer{.features = why_not(tree, values, goal), .thresholds = {}, .beliefs = {}};
  if (answer.features.kind == WhyNot::Kind::reached) return answer;
  answer.thresholds = nearest_thresholds(tree, values, goal);
  answer.beliefs = nearest_beliefs(params, tree, decision, goal);
  return answer;
}

std::string bound_text(const NewValue& change) {
  std::string value = value_text(change.feature, change.after);
  const bool is_number = info_of(change.feature).kind == agent::FeatureInfo::Kind::number;
  if (!is_number || std::isnan(change.after) || std::isnan(change.before)) return value;
  return (change.after < change.before ? "at most " : "at least ") + value;
}

std::string text_of(const Alternative& answer, const agent::Tree& tree, const std::string& name,
                    const std::string& what) {
  const WhyNot& features = answer.features;
  if (features.kind == WhyNot::Kind::reached)
    return name + " does play " + what + ": " + leaf_text(tree, features.leaf) + "\n";
  std::string text;
  if (features.kind == WhyNot::Kind::unreachable)
    text = what + " is unreachable: no possible values of the features lead there\n";
  else if (features.kind == WhyNot::Kind::unsure)
    text = "the tree is too large for a complete search, and no way to " + what + " was found\n";
  else
    text = features_text(features, tree);
  if (answer.thresholds) text += thresholds_text(*answer.thresholds, tree);
  if (answer.beliefs) {
    text += "beliefs that do it, with all features computed anew:\n";
    for (const std::string& change : answer.beliefs->changes) text += "  " + change + "\n";
    text += "  lead to " + leaf_text(tree, answer.beliefs->leaf) + "\n";
  } else if (features.kind == WhyNot::Kind::changed) {
    text += "no change of one or two beliefs was found that does it\n";
  }
  return text;
}

std::string place_text(const State& state) {
  const int seconds = static_cast<int>(static_cast<float>(state.book.clock) * kTickDuration);
  return formatted("at %.2f s, half %d, %d:%02d on the clock, %d:%d, %s", shown(age(state.world.tick, 0)),
                   state.book.half, seconds / 60, seconds % 60, state.book.score[0], state.book.score[1],
                   agent::kPhaseWords[static_cast<std::size_t>(state.book.phase)]);
}

std::string show_text(const Params& params, const State& state, const std::function<std::string(int)>& name) {
  const Ball& ball = state.world.ball;
  std::string text = place_text(state) + "\n";
  text += formatted("ball  (%.2f, %.2f) m, %.2f m/s   [field]\n", shown(ball.position.x), shown(ball.position.y),
                    shown(length(ball.velocity)));
  for_each_robot(state.world.players, [&](int robot) {
    const Body& body = state.world.bodies[robot];
    const agent::TreeBehaviour* tree = tree_of(params, robot);
    const Robot& self = state.robots[robot];
    const bool has_leaf = self.mind.leaf != agent::kNoLeaf && tree && self.mind.leaf < tree->tree().leaf_words.size();
    text += formatted("%-7s (%5.2f, %5.2f) m %4.0f deg  %-16s %-14s", name(robot).c_str(), shown(body.position.x),
                      shown(body.position.y), shown(kDegrees * body.heading), kDoing[static_cast<int>(body.doing)],
                      has_leaf ? tree->tree().leaf_words[self.mind.leaf].name.c_str() : "-");
    if (on_field(body)) {
      const agent::Beliefs truth = true_beliefs(state, robot);
      text += formatted(" pose %.2f m off", shown(distance(self.beliefs.pose.pose.position, truth.pose.pose.position)));
      if (self.beliefs.ball.seen != kNever)
        text += formatted(", ball %.2f m off, seen %.1f s ago",
                          shown(distance(self.beliefs.ball.position, truth.ball.position)),
                          shown(age(state.world.tick, self.beliefs.ball.seen)));
    }
    text += "\n";
  });
  return text;
}

}  // namespace sim::debug
