#include "sim/debug/session.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/core/text.h"
#include "sim/check/event.h"
#include "sim/debug/answers.h"
#include "sim/debug/argument_change.h"
#include "sim/debug/command_words.h"
#include "sim/debug/decision.h"
#include "sim/io/saved_moment.h"
#include "sim/io/vocabulary.h"
#include "sim/io/words.h"

namespace sim::debug {

using robot::Error;
using robot::Result;

namespace {

using robot::formatted;

constexpr std::size_t kMostLine = 2000;  // [bytes]
constexpr int kMostMoves = 100'000;
constexpr std::size_t kMostBreakpoints = 100;

}  // namespace

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
  Answer done = carry_out(words);
  if (const std::string problem = timeline_.problem(); !problem.empty()) return Error{problem};
  return done;
}

Session::Answer Session::carry_out(const Words& words) {
  const std::string& name = words[0];
  if (name == "goto") return go_to(words);
  if (name == "step") return move(words, true);
  if (name == "back") return move(words, false);
  if (name == "until") return run_until(words, true);
  if (name == "reverse-until") return run_until(words, false);
  if (name == "break") return set_breakpoint(words);
  if (name == "unbreak") return remove_breakpoint(words);
  if (name == "continue") return run_to_breakpoint(words, true);
  if (name == "reverse-continue") return run_to_breakpoint(words, false);
  if (name == "robot") return put_in_focus(words);
  if (name == "why") return why(words);
  if (name == "whynot") return why_not(words);
  if (name == "show") return show_text(params(), timeline_.at(now_), [&](int robot) { return name_of(robot); });
  if (name == "nodes") return nodes();
  if (name == "leaves") {
    const auto played = tree();
    return played ? Answer(leaves_text(**played)) : Answer(played.failure());
  }
  if (name == "set") return set(words);
  if (name == "strategy") return strategy(words);
  if (name == "undo") return undo();
  if (name == "futures") return run_futures(words);
  if (name == "help") return help_text();
  std::vector<std::string_view> known;
  for (const CommandInfo& info : commands()) known.push_back(info.name);
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
    for (const CommandInfo& info : commands()) add(info.name);
    return all;
  }
  for_each_robot(players(), [&](int robot) { add(name_of(robot)); });
  const std::string_view command = line.substr(0, line.find(' '));
  if (command == "whynot") {
    if (const auto* tree = tree_of(params(), focus_))
      for (const agent::Words& words : tree->tree().leaf_words) add(words.name);
  } else if (command == "until" || command == "reverse-until" || command == "break") {
    for (const std::string_view name : io::all_features()) add(name);
    for (const char* word : {"skill", "leaf", "role", "changes", "ball_error", "pose_error", "decides", "falls"})
      add(word);
    for (int i = 0; i < check::quantity_count(); ++i) add(check::quantity(i).name);
  } else if (command == "set") {
    for (const char* word : {"ball", "threshold", "argument", "of", "luck", "believes", "at"}) add(word);
  }
  return all;
}

std::string Session::name_of(int robot) const {
  return std::to_string(teams_.of(side_of(robot))) + "/" + std::to_string(player_of(robot));
}

Result<const agent::Tree*> Session::tree_in(const Params& params, int robot) const {
  if (const agent::TreeBehaviour* played = tree_of(params, robot)) return &played->tree();
  return Error{name_of(robot) + " plays '" + params.teams[static_cast<int>(side_of(robot))].behaviour->name() +
               "', which is no decision tree"};
}

std::string Session::note() const {
  if (!timeline_.setup_at(now_)->lineup) return {};
  return timeline_.saves()
             ? "The behaviours from outside save their memory: any moment is loaded."
             : "A behaviour from outside cannot save its memory: for an earlier moment, and for each future, "
               "the game is played again from its first tick.";
}

Result<Stop> Session::stop_in(const std::string& text) const {
  auto stop = parse_stop(text, players(), teams_, focus_);
  if (!stop) return stop;
  if (const auto robot = robot_without_tree(*stop, params())) return tree_in(params(), *robot).failure();
  return stop;
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
  const std::string text = rest_of(words, 1);
  const auto stop = stop_in(text);
  if (!stop) return stop.failure();
  const auto tick = forward ? next_stop(timeline_, *stop, now_) : previous_stop(timeline_, *stop, now_);
  if (!tick) return Error{"'" + text + "' does not become true " + (forward ? "after" : "before") + " this moment"};
  return arrive(*tick);
}

std::vector<std::string> Session::breakpoints() const {
  std::vector<std::string> texts;
  for (const Stop& breakpoint : breakpoints_) texts.push_back(text_of(breakpoint));
  return texts;
}

Session::Answer Session::set_breakpoint(const Words& words) {
  if (words.size() == 1) {
    std::string all;
    for (std::size_t i = 0; i < breakpoints_.size(); ++i)
      all += formatted("%3zu  %s\n", i + 1, text_of(breakpoints_[i]).c_str());
    return all.empty() ? "no breakpoints\n" : all;
  }
  auto stop = stop_in(rest_of(words, 1));
  if (!stop) return stop.failure();
  if (breakpoints_.size() == kMostBreakpoints)
    return Error{"there are " + std::to_string(kMostBreakpoints) + " breakpoints at most"};
  breakpoints_.push_back(*std::move(stop));
  return formatted("breakpoint %zu\n", breakpoints_.size());
}

Session::Answer Session::remove_breakpoint(const Words& words) {
  if (words.size() != 2) return usage("unbreak");
  const auto number = number_in<std::size_t>(words[1]);
  if (!number || *number < 1 || *number > breakpoints_.size())
    return Error{"unbreak: expected the number of a breakpoint, got '" + words[1] + "'; 'break' lists them"};
  breakpoints_.erase(breakpoints_.begin() + static_cast<std::ptrdiff_t>(*number - 1));
  return std::string();
}

Session::Answer Session::run_to_breakpoint(const Words& words, bool forward) {
  if (words.size() != 1) return usage(words[0]);
  if (breakpoints_.empty()) return Error{words[0] + ": there is no breakpoint; 'break CONDITION' sets one"};
  std::optional<Tick> nearest;
  std::string met;
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    const Stop& stop = breakpoints_[i];
    const auto tick = forward ? next_stop(timeline_, stop, now_) : previous_stop(timeline_, stop, now_);
    if (!tick || (nearest && (forward ? *tick > *nearest : *tick < *nearest))) continue;
    if (nearest != tick) met.clear();
    nearest = tick;
    met += formatted("breakpoint %zu: %s\n", i + 1, text_of(stop).c_str());
  }
  if (!nearest) return Error{std::string("no breakpoint is met ") + (forward ? "after" : "before") + " this moment"};
  const auto there = arrive(*nearest);
  return *there + met;
}

Session::Answer Session::put_in_focus(const Words& words) {
  if (words.size() != 2) return usage("robot");
  const auto robot = robot_in(words, 1);
  if (!robot) return robot.failure();
  focus_ = *robot;
  return std::string();
}

Result<Explanation> Session::explain(int robot) {
  const auto decision = decision_before(timeline_, now_, robot);
  if (!decision) return Error{name_of(robot) + " has not decided yet"};
  SharedSetup setup = timeline_.setup_at(decision->tick);
  if (const auto played = tree_in(setup->params, robot); !played) return played.failure();
  const agent::TreeBehaviour& behaviour = *tree_of(setup->params, robot);
  Why reasons = debug::why(setup->params, behaviour, *decision, timeline_.at(decision->tick));
  return Explanation{.setup = std::move(setup), .tree = &behaviour.tree(), .why = std::move(reasons)};
}

Session::Answer Session::why(const Words& words) {
  if (words.size() > 2) return usage("why");
  const auto robot = robot_in(words, 1);
  if (!robot) return robot.failure();
  auto explained = explain(*robot);
  if (!explained) return explained.failure();
  find_sources(explained->setup->params, *explained->tree, explained->why);
  return text_of(explained->why, *explained->tree, name_of(*robot)) + "decided " + place_text(explained->why.state) +
         "\n";
}

Result<Alternative> Session::alternative(const Explanation& to, const std::string& what) const {
  const auto goal = goal_of(what, *to.tree);
  if (!goal) return goal.failure();
  const Decision& decision = to.why.decision;
  return alternative_to(to.setup->params, *to.tree, decision, *goal, name_of(decision.robot));
}

Session::Answer Session::why_not(const Words& words) {
  if (words.size() < 2) return usage("whynot");
  const auto explained = explain(focus_);
  if (!explained) return explained.failure();
  const std::string what = rest_of(words, 1);
  const auto answer = alternative(*explained, what);
  if (!answer) return answer.failure();
  return text_of(*answer, *explained->tree, name_of(focus_), what);
}

Session::Answer Session::nodes() {
  const auto played = tree();
  if (!played) return played.failure();
  const std::vector<agent::Words>& words = (*played)->node_words;
  std::string text;
  for (std::size_t i = words.size(); i-- > 0;)
    text += formatted("%4zu  %-40s %s\n", i, words[i].condition.c_str(), words[i].path.c_str());
  return text;
}

}  // namespace sim::debug
