#include "sim/agent/tree.h"

#include <cassert>
#include <cmath>

#include "sim/agent/head.h"
#include "sim/agent/manners.h"
#include "sim/agent/place_skills.h"
#include "sim/agent/roles.h"
#include "sim/agent/trace.h"

namespace sim::agent {
namespace {

/// Remembers the ball for the time when nobody sees it, and the side to which it went.
void remember_ball(const View& view, Mind& mind) {
  if (!view.ball_known) return;
  mind.ball = view.ball_in_team;
  mind.ball_seen = view.ball_seen;
  if (view.ball_distance > 0.6f && std::abs(view.ball.y) > 0.2f) mind.search_side = left_or_right(view.ball.y);
}

void remember_leaf(Mind& mind, std::uint16_t leaf, Tick now) {
  if (mind.leaf != leaf) mind.leaf_since = now;
  mind.leaf = leaf;
}

Trace::Node explained(const Node& node, const Words& words, float value, float threshold, bool result) {
  return {.path = words.path.c_str(),
          .name = words.name.c_str(),
          .condition = words.condition.c_str(),
          .feature = info_of(node.feature).name,
          .value = value,
          .threshold = threshold,
          .known = !std::isnan(value),
          .result = result};
}

void explain_leaf(const Leaf& leaf, const Words& words, const Mind& mind, Trace& trace) {
  trace.visited.push_back({.path = words.path.c_str(), .name = words.name.c_str(), .condition = "", .feature = ""});
  const SkillInfo& skill = info_of(leaf.skill);
  trace.skill = skill.name;
  for (int i = 0; i < skill.count; ++i)
    if (is_given(leaf.arguments[i])) trace.arguments.push_back({skill.parameters[i].name, leaf.arguments[i]});
  trace.role = name_of(mind.role);
}

/// Walks from `at` to a leaf and returns its number. Calls see(node, its number, value, threshold, result) at each node.
template <class See>
std::uint16_t walk_down(const Tree& tree, std::uint16_t at, const View& view, See&& see) {
  const Node* nodes = tree.nodes.data();
  while (!(at & kLeafBit)) {
    const Node& node = nodes[at];
    const float value = value_of(node.feature, view);
    const float threshold = node.other == kNoFeature ? node.threshold : value_of(node.other, view);
    const bool result = holds(node.comparison, value, threshold);
    see(node, at, value, threshold, result);
    at = result ? node.yes : node.no;
  }
  return static_cast<std::uint16_t>(at & ~kLeafBit);
}

/// Walks from the root and explains each step.
std::uint16_t walk_down_explaining(const Tree& tree, const View& view, Trace& trace) {
  return walk_down(tree, tree.root, view,
                   [&](const Node& node, std::uint16_t at, float value, float threshold, bool result) {
                     trace.visited.push_back(explained(node, tree.node_words[at], value, threshold, result));
                   });
}

}  // namespace

void prepare(const View& view, Mind& mind) {
  remember_ball(view, mind);
  const auto since = static_cast<std::uint8_t>(view.now - mind.settled);
  if (mind.leaf == kNoLeaf || since >= kSettle) assign_role(view, mind);
}

std::uint16_t leaf_of(const Tree& tree, const View& view) { return leaf_from(tree, tree.root, view); }

std::uint16_t leaf_from(const Tree& tree, std::uint16_t entry, const View& view) {
  return walk_down(tree, entry, view, [](auto&&...) {});
}

motion::Command play_leaf(const Tree& tree, std::uint16_t number, const View& view, Mind& mind, Trace* trace) {
  remember_leaf(mind, number, view.now);
  const Leaf& leaf = tree.leaves[number];
  if (trace) explain_leaf(leaf, tree.leaf_words[number], mind, *trace);
  const SkillInfo& skill = info_of(leaf.skill);
  if (!skill.searches) mind.search_since = kNever;
  motion::Command command = skill.run(leaf.arguments, view, mind);
  mind_manners(view, command);
  return command;
}

motion::Command wait(const View& view, Mind& mind, Trace* trace) {
  remember_leaf(mind, kNoLeaf, view.now);
  mind.search_since = kNever;
  mind.aligned = 0;
  const bool walks = view.game.phase == Game::Phase::ready && !view.game.penalised;
  if (trace) trace->skill = walks ? "get_ready" : "stand", trace->role = name_of(mind.role);
  if (walks) return get_ready(view);
  return stand(view);
}

TreeBehaviour::TreeBehaviour(Tree tree) : tree_(std::move(tree)) {
  const Feature ball_known = find_feature("ball_known"), own_role = find_feature("role");
  assert(ball_known != kNoFeature && own_role != kNoFeature);
  for (int known = 0; known < 2; ++known)
    for (int role = 0; role < kRoleCount; ++role) {
      std::uint16_t at = tree_.root;
      while (!(at & kLeafBit)) {
        const Node& node = tree_.nodes[at];
        const bool settled = (node.feature == ball_known || node.feature == own_role) && node.other == kNoFeature;
        if (!settled) break;
        const int value = node.feature == own_role ? role : known;
        at = holds(node.comparison, static_cast<float>(value), node.threshold) ? node.yes : node.no;
      }
      entries_[known][role] = at;
    }
}

motion::Command TreeBehaviour::decide(const Surroundings& surroundings, const Game& game, const Beliefs& beliefs,
                                      Tick now, Mind& mind, Trace* trace) const {
  if (trace) trace->clear(), trace->strategy = tree_.name.c_str();
  const View view(surroundings, tree_.settings, game, beliefs, now, mind);
  if (!plays(game)) return wait(view, mind, trace);

  prepare(view, mind);
  const std::uint16_t entry = entries_[view.ball_known][static_cast<int>(mind.role)];
  const std::uint16_t number = trace ? walk_down_explaining(tree_, view, *trace) : leaf_from(tree_, entry, view);
  return play_leaf(tree_, number, view, mind, trace);
}

}  // namespace sim::agent
