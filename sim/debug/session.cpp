#include "sim/debug/session.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/check/event.h"
#include "sim/debug/answers.h"
#include "sim/debug/belief_change.h"
#include "sim/debug/decision.h"
#include "sim/debug/futures.h"
#include "sim/debug/stop.h"
#include "sim/debug/why.h"
#include "sim/debug/why_not.h"
#include "sim/io/saved_moment.h"
#include "sim/io/strategy.h"
#include "sim/io/values.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"
#include "sim/math/angles.h"

namespace sim::debug {

using robot::Error;
using robot::Result;

namespace {

using robot::formatted;

constexpr std::size_t kMostLine = 2000;  // [bytes]
constexpr int kMostMoves = 100'000;
constexpr int kMostFutures = 10'000;
const io::Json kNoParameters = io::Json::object();

constexpr CommandInfo kCommands[] = {
    {"goto", "goto MOMENT", "to [s] since the first tick, or half:minutes:seconds on the clock"},
    {"step", "step [N] [s|ticks]", "on by decisions of the robot in focus, by seconds or by ticks"},
    {"back", "back [N] [s|ticks]", "likewise back"},
    {"until", "until CONDITION", "on to the first moment at which it becomes true"},
    {"reverse-until", "reverse-until CONDITION", "back to the last one"},
    {"robot", "robot 14/3", "puts a robot in focus"},
    {"why", "why [ROBOT]", "explains its newest decision"},
    {"whynot", "whynot SKILL|LEAF", "the smallest change that leads there, for the robot in focus"},
    {"show", "show", "ball and robots, and how far their beliefs are off"},
    {"nodes", "nodes", "the comparisons of the tree, with their numbers"},
    {"set", "set ball X Y", "[m, field] puts the ball down"},
    {"set", "set ROBOT at X Y [DEG]", "[m, field] puts a robot there"},
    {"set", "set ROBOT believes ball X Y", "[m, robot] it has just seen the ball there"},
    {"set", "set ROBOT believes at X Y [DEG]", "[m, team_field] its own pose"},
    {"set", "set threshold NODE VALUE", "of the tree of the robot in focus"},
    {"set", "set luck N", "another seed from here on"},
    {"strategy", "strategy NAME", "another tree for the side of the robot in focus"},
    {"undo", "undo", "takes the last edit back, and goes to its moment"},
    {"futures", "futures [N] [SECONDS]", "plays on N times with and without the edits of the last edited moment"},
    {"help", "help", "this list"},
    {"quit", "quit", "ends"},
};

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r\n");
    if (begin == line.npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r\n"), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::string joined(const std::vector<std::string>& words, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < words.size(); ++i) text += (i > from ? " " : "") + words[i];
  return text;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

Result<float> number(const std::string& text, float least, float most, const char* unit) {
  const auto value = io::Values(kNoParameters).read(std::string_view(text), {unit, least, most, nullptr});
  if (!value) return Error{value.error()};
  return *value;
}

/// Reads "X Y" on the field and the ground round it [m].
Result<Vec2> place_in(const std::vector<std::string>& words, std::size_t at, const field::Field& field) {
  if (words.size() < at + 2) return Error{"expected X and Y [m], got '" + joined(words, at) + "'"};
  const auto x = number(words[at], -field.length / 2 - field.border, field.length / 2 + field.border, "m");
  if (!x) return Error{"X " + x.error()};
  const auto y = number(words[at + 1], -field.width / 2 - field.border, field.width / 2 + field.border, "m");
  if (!y) return Error{"Y " + y.error()};
  return Vec2{*x, *y};
}

/// Reads the heading [deg] behind a place, if there is one.
Result<std::optional<float>> heading_in(const std::vector<std::string>& words, std::size_t at) {
  if (words.size() <= at) return std::optional<float>{};
  const auto degrees = number(words[at], -180, 180, "");
  if (!degrees) return Error{"the heading in degrees " + degrees.error()};
  return std::optional(*degrees * kPi / 180);
}

Error usage(std::string_view name) {
  std::string all;
  for (const CommandInfo& info : kCommands)
    if (info.name == name) all += (all.empty() ? "" : ", ") + std::string(info.usage);
  return {"expected: " + all};
}

}  // namespace

std::span<const CommandInfo> commands() { return kCommands; }

std::string help_text() {
  std::string text;
  for (const CommandInfo& info : kCommands) {
    text += formatted("  %-34s %s\n", std::string(info.usage).c_str(), std::string(info.about).c_str());
  }
  return text;
}

Session::Session(SharedSetup setup, const State& start, io::SituationTeams teams)
    : timeline_(std::move(setup), start),
      teams_(teams),
      now_(start.world.tick),
      focus_(robot_of(Side::home, std::min(2, start.world.players))) {}

Result<std::string> Session::run(std::string_view line) {
  if (line.size() > kMostLine)
    return Error{"a line must have at most " + std::to_string(kMostLine) + " bytes, got " +
                 std::to_string(line.size())};
  const Words words = words_of(line);
  if (words.empty() || words[0].starts_with('#')) return std::string();
  const std::string& name = words[0];
  if (name == "goto") return go_to(words);
  if (name == "step") return move(words, true);
  if (name == "back") return move(words, false);
  if (name == "until") return run_until(words, true);
  if (name == "reverse-until") return run_until(words, false);
  if (name == "robot") return focus(words);
  if (name == "why") return why(words);
  if (name == "whynot") return why_not(words);
  if (name == "show") return show_text(params(), timeline_.at(now_), [&](int robot) { return name_of(robot); });
  if (name == "nodes") return nodes();
  if (name == "set") return set(words);
  if (name == "strategy") return strategy(words);
  if (name == "undo") return undo();
  if (name == "futures") return run_futures(words);
  if (name == "help") return help_text();
  std::vector<std::string_view> known;
  for (const CommandInfo& info : kCommands) known.push_back(info.name);
  const std::string hint = io::did_you_mean(name, known);
  return Error{"no command '" + name + "'" + (hint.empty() ? "; 'help' lists all" : hint)};
}

std::string Session::prompt() const {
  return formatted("%.2f s %s> ", static_cast<double>(age(now_, 0)), name_of(focus_).c_str());
}

std::vector<std::string> Session::completions(std::string_view line) const {
  const std::size_t blank = line.rfind(' ');
  const std::string_view begun = blank == line.npos ? line : line.substr(blank + 1);
  std::vector<std::string> all;
  const auto add = [&](std::string_view word) {
    if (word.starts_with(begun) && std::ranges::find(all, word) == all.end()) all.emplace_back(word);
  };
  if (blank == line.npos) {
    for (const CommandInfo& info : kCommands) add(info.name);
    return all;
  }
  for_each_robot(players(), [&](int robot) { add(name_of(robot)); });
  const std::string_view command = line.substr(0, line.find(' '));
  if (command == "whynot") {
    if (const auto* tree = tree_of(params(), focus_))
      for (const agent::Words& words : tree->tree().leaf_words) add(words.name);
  } else if (command == "until" || command == "reverse-until") {
    for (const std::string_view name : io::all_features()) add(name);
    for (const char* word : {"skill", "leaf", "role", "changes", "ball_error", "pose_error", "decides", "falls"})
      add(word);
    for (int i = 0; i < check::quantity_count(); ++i) add(check::quantity(i).name);
  } else if (command == "set") {
    for (const char* word : {"ball", "threshold", "luck", "believes", "at"}) add(word);
  }
  return all;
}

std::string Session::name_of(int robot) const {
  return std::to_string(teams_.of(side_of(robot))) + "/" + std::to_string(player_of(robot));
}

Result<int> Session::robot_in(const Words& words, std::size_t index) const {
  if (words.size() <= index) return focus_;
  const int robot = check::robot_named(words[index], players(), teams_);
  if (robot == kNobody)
    return Error{"expected " + check::robot_names(players(), teams_) + ", got '" + words[index] + "'"};
  return robot;
}

Session::Answer Session::arrive(Tick tick) {
  now_ = tick;
  return place_text(timeline_.at(now_)) + "\n";
}

Session::Answer Session::go_to(const Words& words) {
  if (words.size() != 2) return usage("goto");
  const auto moment = io::SavedMoment::parse(words[1]);
  if (!moment) return moment.failure();
  std::optional<Tick> found;
  const State start = timeline_.at(timeline_.first());
  if (moment->comes_with(start)) return arrive(timeline_.first());
  const State last =
      timeline_.replay(timeline_.first(), kNever, [&](const State&, const State& after, const referee::Events&) {
        if (moment->comes_with(after)) found = after.world.tick;
        return !found;
      });
  if (found) return arrive(*found);
  return Error{formatted("the game ends %.2f s after its first tick, got %s",
                         static_cast<double>(age(last.world.tick, 0)), words[1].c_str())};
}

Session::Answer Session::move(const Words& words, bool forward) {
  const auto count = words.size() > 1 ? number_in<double>(words[1]) : std::optional(1.);
  const std::string unit = words.size() > 2 ? words[2] : "";
  const bool by_ticks = unit == "s" || unit == "tick" || unit == "ticks";
  if (!count || words.size() > 3 || (!unit.empty() && !by_ticks)) return usage(words[0]);
  if (!(*count > 0 && *count <= kMostMoves) || (unit != "s" && *count != std::floor(*count)))
    return Error{words[0] + ": expected a number from 1 to " + std::to_string(kMostMoves) + ", got " + words[1]};

  if (by_ticks) {
    const Tick ticks_to_go = unit == "s" ? ticks(static_cast<float>(*count)) : static_cast<Tick>(*count);
    if (forward) return arrive(timeline_.at(now_ + ticks_to_go).world.tick);
    return arrive(now_ - timeline_.first() > ticks_to_go ? now_ - ticks_to_go : timeline_.first());
  }
  Tick tick = now_;
  for (int left = static_cast<int>(*count); left > 0; --left) {
    std::optional<Tick> next;
    if (forward) {
      timeline_.replay(tick, kNever, [&](const State& before, const State&, const referee::Events&) {
        if (before.world.tick > tick && decides(before, focus_)) next = before.world.tick;
        return !next;
      });
    } else if (tick > timeline_.first()) {
      if (const auto decision = decision_before(timeline_, tick - 1, focus_)) next = decision->tick;
    }
    if (!next) {
      if (tick == now_) return Error{name_of(focus_) + " has no decision " + (forward ? "after" : "before") + " this"};
      break;
    }
    tick = *next;
  }
  return arrive(tick);
}

Session::Answer Session::run_until(const Words& words, bool forward) {
  if (words.size() < 2) return usage(words[0]);
  const std::string text = joined(words, 1);
  const auto stop = parse_stop(text, players(), teams_, focus_);
  if (!stop) return stop.failure();
  const auto tick = forward ? next_stop(timeline_, *stop, now_) : previous_stop(timeline_, *stop, now_);
  if (!tick) return Error{"'" + text + "' does not become true " + (forward ? "after" : "before") + " this moment"};
  return arrive(*tick);
}

Session::Answer Session::focus(const Words& words) {
  if (words.size() != 2) return usage("robot");
  const auto robot = robot_in(words, 1);
  if (!robot) return robot.failure();
  focus_ = *robot;
  return std::string();
}

Session::Answer Session::why(const Words& words) {
  if (words.size() > 2) return usage("why");
  const auto robot = robot_in(words, 1);
  if (!robot) return robot.failure();
  const auto decision = decision_before(timeline_, now_, *robot);
  if (!decision) return Error{name_of(*robot) + " has not decided yet"};
  const Params& played = timeline_.setup_at(decision->tick)->params;
  const agent::TreeBehaviour& behaviour = *tree_of(played, *robot);
  const State state = timeline_.at(decision->tick);
  Why reasons = debug::why(played, behaviour, *decision, state);
  find_sources(played, behaviour.tree(), reasons);
  return text_of(reasons, behaviour.tree(), name_of(*robot)) + "decided " + place_text(state) + "\n";
}

Result<Goal> Session::goal_of(const std::string& text, const agent::Tree& tree) const {
  Goal goal(tree.leaves.size());
  bool any = false;
  for (std::size_t i = 0; i < goal.size(); ++i)
    if (tree.leaf_words[i].name == text) goal[i] = any = true;
  for (std::size_t i = 0; i < goal.size() && text.size() > 2; ++i)
    if (tree.leaf_words[i].path.find("/" + text + "/") != std::string::npos) goal[i] = any = true;
  if (any) return goal;
  std::vector<std::string_view> known;
  for (const agent::Words& words : tree.leaf_words)
    if (std::ranges::find(known, words.name) == known.end()) known.emplace_back(words.name);
  std::string all;
  for (const std::string_view name : known) all.append(all.empty() ? "" : ", ").append(name);
  const std::string hint = io::did_you_mean(text, known);
  return Error{"strategy '" + tree.name + "' has no skill or rule '" + text + "'" +
               (hint.empty() ? "; its skills are: " + all : hint)};
}

Session::Answer Session::why_not(const Words& words) {
  if (words.size() < 2) return usage("whynot");
  const auto decision = decision_before(timeline_, now_, focus_);
  if (!decision) return Error{name_of(focus_) + " has not decided yet"};
  const Params& played = timeline_.setup_at(decision->tick)->params;
  const agent::Tree& tree = tree_of(played, focus_)->tree();
  const std::string what = joined(words, 1);
  const auto goal = goal_of(what, tree);
  if (!goal) return goal.failure();
  if (!agent::plays(decision->game))
    return Error{name_of(focus_) + " asks its tree nothing, because " +
                 (decision->game.penalised ? "it is penalised" : "the ball is not in play")};
  const Thought thought(played, tree, *decision);
  const Values values = values_of(tree, thought.view());
  const WhyNot answer = debug::why_not(tree, values, *goal);
  const bool asks_more = answer.kind != WhyNot::Kind::reached;
  return text_of(answer, asks_more ? nearest_thresholds(tree, values, *goal) : std::nullopt,
                 asks_more ? nearest_beliefs(played, tree, *decision, *goal) : std::nullopt, tree, name_of(focus_),
                 what);
}

Session::Answer Session::nodes() {
  const agent::Tree& tree = tree_of(params(), focus_)->tree();
  std::string text;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    text += formatted("%4zu  %-40s %s\n", i, tree.node_words[i].condition.c_str(), tree.node_words[i].path.c_str());
  }
  return text;
}

std::string Session::edit(const State& state, SharedSetup setup, const std::string& what) {
  edits_.push_back({now_, timeline_});
  timeline_.change(state, std::move(setup));
  return what + "\n";
}

Session::Answer Session::set(const Words& words) {
  if (words.size() < 3) return usage("set");
  if (words[1] == "threshold") return set_threshold(words);
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
  if (body.doing == Body::Doing::removed) return Error{name_of(*robot) + " is off the field"};
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
  const agent::Tree& tree = tree_of(params(), focus_)->tree();
  const auto node = number_in<std::uint16_t>(words[2]);
  if (!node || *node >= tree.nodes.size())
    return Error{"set threshold: expected a node from 0 to " + std::to_string(tree.nodes.size() - 1) + ", got '" +
                 words[2] + "'"};
  const agent::Node& old = tree.nodes[*node];
  const agent::FeatureInfo& info = info_of(old.feature);
  if (old.other != agent::kNoFeature || info.kind == agent::FeatureInfo::Kind::yes_no)
    return Error{"set threshold: node " + words[2] + " is '" + tree.node_words[*node].condition +
                 "', which has no threshold"};
  const auto value = io::Values(kNoParameters)
                         .read(std::string_view(joined(words, 3)), {info.unit, info.least, info.most, info.names});
  if (!value) return Error{"set threshold: the value for " + std::string(info.name) + " " + value.error()};
  agent::Tree changed = with_threshold(tree, *node, *value);
  const std::string condition = changed.node_words[*node].condition;
  return edit(timeline_.at(now_), with_tree(timeline_.setup_at(now_), focus_, std::move(changed)), condition);
}

Session::Answer Session::strategy(const Words& words) {
  if (words.size() != 2) return usage("strategy");
  auto behaviour = io::load_strategy(words[1]);
  if (!behaviour) return behaviour.failure();
  agent::Tree tree = (*behaviour)->tree();
  const Team& team = params().teams[static_cast<int>(side_of(focus_))];
  if (const auto kicks = io::check_kicks(tree, team); !kicks) return kicks.failure();
  State state = timeline_.at(now_);
  // a leaf of the old tree means nothing in the new one
  for_each_robot(state.world.players, [&](int robot) {
    if (tree_of(params(), robot) == tree_of(params(), focus_)) state.robots[robot].mind.leaf = agent::kNoLeaf;
  });
  return edit(state, with_tree(timeline_.setup_at(now_), focus_, std::move(tree)), "plays " + words[1]);
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
  if (edits_.empty()) return Error{"futures compares with and without an edit, and there is none"};
  // all edits at the moment of the last one count together
  const Tick tick = edits_.back().tick;
  auto first = edits_.end() - 1;
  while (first != edits_.begin() && (first - 1)->tick == tick) --first;
  Timeline before = first->before;
  const Moment without{before.setup_at(tick), before.at(tick)}, with{timeline_.setup_at(tick), timeline_.at(tick)};
  const Tick length = ticks(*seconds);
  return "for " + name_of(focus_) + "'s side\n" +
         text_of(debug::futures(without, with, side_of(focus_), *count, length), length);
}

}  // namespace sim::debug
