// The commands of a session that change the game, and that compare the futures with and without a change.
#include <algorithm>
#include <optional>

#include "sim/agent/features.h"
#include "sim/check/event.h"
#include "sim/debug/argument_change.h"
#include "sim/debug/command_words.h"
#include "sim/debug/session.h"
#include "sim/io/strategy.h"
#include "sim/io/values.h"
#include "sim/math/angles.h"

namespace sim::debug {

using robot::Error;
using robot::Result;

namespace {

constexpr int kMostFutures = 10'000;

}  // namespace

std::string Session::edit(const State& state, SharedSetup setup, const std::string& what) {
  edits_.push_back({now_, timeline_});
  timeline_.change(state, std::move(setup));
  return what + "\n";
}

Session::Answer Session::set(const Words& words) {
  if (words.size() < 3) return usage("set");
  if (words[1] == "threshold") return set_threshold(words);
  if (words[1] == "argument") return set_argument(words);
  State state = timeline_.at(now_);
  if (words[1] == "ball") {
    const auto to = place_in(words, 2, params().rules.field);
    if (!to) return Error{"set ball: " + to.error()};
    place(state.world.ball, *to);
  } else if (words[1] == "luck") {
    const auto seed = number_in<std::uint64_t>(words[2]);
    if (!seed) return Error{"set luck: expected a whole number, got '" + words[2] + "'"};
    state.world.key = {*seed};
  } else if (const auto done = set_of_robot(words, state); !done) {
    return done.failure();
  }
  return edit(state, timeline_.setup_at(now_), "changed");
}

Result<void> Session::set_of_robot(const Words& words, State& state) const {
  const auto robot = robot_in(words, 1);
  if (!robot) return robot.failure();
  Body& body = state.world.bodies[*robot];
  if (!on_field(body)) return Error{name_of(*robot) + " is off the field"};
  agent::Beliefs& beliefs = state.robots[*robot].beliefs;
  const field::Field& field = params().rules.field;
  const bool believes = words[2] == "believes";
  const std::size_t what = believes ? 3 : 2;
  const std::string thing = words.size() > what ? words[what] : "";
  if (thing != "at" && !(believes && thing == "ball")) return usage("set");

  if (thing == "ball") {
    // in the robot's frame it may be as far as the field is long
    field::Field wide = field;
    wide.width = wide.length = 2 * field.length;
    const auto to = place_in(words, what + 1, wide);
    if (!to) return Error{"set " + words[1] + ": " + to.error()};
    beliefs.ball.position = *to;
    beliefs.ball.velocity = {};
    beliefs.ball.seen = state.world.tick > 0 ? state.world.tick - 1 : 0;
    return {};
  }
  const auto to = place_in(words, what + 1, field);
  if (!to) return Error{"set " + words[1] + ": " + to.error()};
  const auto heading = heading_in(words, what + 3);
  if (!heading) return Error{"set " + words[1] + ": " + heading.error()};
  if (believes) {
    Pose2& pose = beliefs.pose.pose;
    pose = {*to, heading->value_or(pose.heading)};
    return {};
  }
  body.position = *to;
  body.heading = heading->value_or(body.heading);
  const SinCos turned = sin_cos(body.heading);
  body.facing = {turned.cos, turned.sin};
  state.world.crowded = true;  // it may touch others now
  return {};
}

Session::Answer Session::set_threshold(const Words& words) {
  if (words.size() < 4) return usage("set");
  const auto played = tree();
  if (!played) return played.failure();
  const agent::Tree& tree = **played;
  const auto node = number_in<std::uint16_t>(words[2]);
  if (!node || *node >= tree.nodes.size())
    return Error{"set threshold: expected a node from 0 to " + std::to_string(tree.nodes.size() - 1) + ", got '" +
                 words[2] + "'"};
  const agent::Node& old = tree.nodes[*node];
  const agent::FeatureInfo& info = info_of(old.feature);
  if (old.other != agent::kNoFeature || info.kind == agent::FeatureInfo::Kind::yes_no)
    return Error{"set threshold: node " + words[2] + " is '" + tree.node_words[*node].condition +
                 "', which has no threshold"};
  const auto value = io::Values().read(std::string_view(rest_of(words, 3)), io::expected_of(info));
  if (!value) return Error{"set threshold: the value for " + std::string(info.name) + " " + value.error()};
  agent::Tree changed = with_threshold(tree, *node, *value);
  const std::string condition = changed.node_words[*node].condition;
  return edit(timeline_.at(now_), with_tree(timeline_.setup_at(now_), focus_, std::move(changed)), condition);
}

Session::Answer Session::set_argument(const Words& words) {
  const auto of = std::ranges::find(words, "of");
  const auto at = of - words.begin();
  if (of == words.end() || at < 4 || of + 1 == words.end()) return usage("set");
  const std::string value = rest_of({words.begin(), of}, 3), where = rest_of(words, static_cast<std::size_t>(at + 1));
  const auto played = tree();
  if (!played) return played.failure();
  auto changed = with_argument(**played, where, words[2], value);
  if (!changed) return Error{"set argument: " + changed.error()};
  return play_tree(timeline_.at(now_), *std::move(changed), words[2] + " " + value + " of " + where);
}

Session::Answer Session::play_tree(const State& state, agent::Tree tree, const std::string& what) {
  const Team& team = params().teams[static_cast<int>(side_of(focus_))];
  if (const auto kicks = io::check_kicks(tree, team); !kicks) return kicks.failure();
  return edit(state, with_tree(timeline_.setup_at(now_), focus_, std::move(tree)), what);
}

Session::Answer Session::strategy(const Words& words) {
  if (words.size() != 2) return usage("strategy");
  auto behaviour = io::load_strategy(words[1]);
  if (!behaviour) return behaviour.failure();
  State state = timeline_.at(now_);
  // a leaf of the old tree means nothing in the new one
  for_each_robot(state.world.players, [&](int robot) {
    if (tree_of(params(), robot) == tree_of(params(), focus_)) state.robots[robot].mind.leaf = agent::kNoLeaf;
  });
  return play_tree(state, (*behaviour)->tree(), "plays " + words[1]);
}

Session::Answer Session::undo() {
  if (edits_.empty()) return Error{"there is no edit to undo"};
  const Tick tick = edits_.back().tick;
  timeline_ = std::move(edits_.back().before);
  edits_.pop_back();
  return arrive(tick);
}

Session::Answer Session::run_futures(const Words& words) {
  if (words.size() > 3) return usage("futures");
  const auto count = words.size() > 1 ? number_in<int>(words[1]) : std::optional(200);
  if (!count || *count < 2 || *count > kMostFutures)
    return Error{"futures: expected a number from 2 to " + std::to_string(kMostFutures) + ", got '" + words[1] + "'"};
  const auto seconds = words.size() > 2 ? number_in<float>(words[2]) : std::optional(30.f);
  if (!seconds || !(*seconds >= 1 && *seconds <= 1200))
    return Error{"futures: expected 1 .. 1200 [s], got '" + words[2] + "'"};
  const auto pair = edited();
  if (!pair) return Error{"futures compares with and without an edit, and there is none"};
  const Tick length = ticks(*seconds);
  const std::vector<Pair> pairs(static_cast<std::size_t>(*count), *pair);
  return "for " + name_of(focus_) + "'s side\n" + text_of(debug::futures(pairs, focus_, length), length);
}

std::optional<Pair> Session::edited() {
  if (edits_.empty()) return {};
  // all edits at the moment of the last one count together
  const Tick tick = edits_.back().tick;
  auto first = edits_.end() - 1;
  while (first != edits_.begin() && (first - 1)->tick == tick) --first;
  Timeline before = first->before;
  const auto moment = [&](Timeline& game) {
    Moment made{.setup = game.setup_at(tick), .state = game.at(tick)};
    if (made.setup->lineup) made.past = std::make_shared<const Timeline>(game);
    return made;
  };
  return Pair{.without = moment(before), .with = moment(timeline_)};
}

}  // namespace sim::debug
