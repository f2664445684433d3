// The debugger as a command language: one line in, one text out. It reads no terminal and no clock.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "sim/debug/answers.h"
#include "sim/debug/commands.h"
#include "sim/debug/futures.h"
#include "sim/debug/stop.h"
#include "sim/debug/timeline.h"
#include "sim/io/situation.h"

namespace sim::debug {

/// The reasons of a decision, with the tree that made it.
struct Explanation {
  SharedSetup setup;  // owns the tree
  const agent::Tree* tree = nullptr;
  Why why;
};

/// A debugged game: the place in it, the robot in focus, and the edits so far.
class Session {
 public:
  /// Begins at `start`, with home/2 in focus, or home/1 where there is no other player.
  Session(SharedSetup setup, const State& start, io::SituationTeams teams);

  /// Runs a line. An empty line and one that begins with '#' do nothing. The Error is one sentence, and nothing has changed,
  /// except when a behaviour from outside fails: the game is then wrong from there on.
  robot::Result<std::string> run(std::string_view line);

  /// Explains the newest decision of a robot, by its index, without the sources of its comparisons.
  robot::Result<Explanation> explain(int robot);
  /// Finds what would have led that decision to a skill or a part of the tree.
  robot::Result<Alternative> alternative(const Explanation& to, const std::string& what) const;

  /// Returns the moment of the last edit, without and with all edits of that moment. Nothing: there is no edit.
  std::optional<Pair> edited();

  Tick now() const { return now_; }
  /// Returns the index of the robot in focus.
  int focus() const { return focus_; }
  /// Returns the name of a robot, by its index: "14/3".
  std::string name_of(int robot) const;
  /// Returns how the past of behaviours from outside comes again, as a sentence; empty if trees play both sides.
  std::string note() const;
  /// Returns "812.30 s 14/3> ".
  std::string prompt() const;
  /// Returns the conditions of the breakpoints, each with the names of its robots.
  std::vector<std::string> breakpoints() const;
  /// Returns all words that can end a line with this beginning.
  std::vector<std::string> completions(std::string_view line) const;

 private:
  using Words = std::vector<std::string>;
  using Answer = robot::Result<std::string>;

  struct Edit {
    Tick tick;
    Timeline before;
  };

  Answer carry_out(const Words& words);
  Answer go_to(const Words& words);
  Answer run_until(const Words& words, bool forward);
  Answer set_breakpoint(const Words& words);
  Answer remove_breakpoint(const Words& words);
  Answer run_to_breakpoint(const Words& words, bool forward);
  Answer put_in_focus(const Words& words);
  Answer why(const Words& words);
  Answer why_not(const Words& words);
  Answer nodes();
  Answer set(const Words& words);
  robot::Result<void> set_of_robot(const Words& words, State& state) const;
  Answer set_threshold(const Words& words);
  Answer set_argument(const Words& words);
  /// Gives the side of the robot in focus another tree.
  Answer play_tree(const State& state, agent::Tree tree, const std::string& what);
  Answer strategy(const Words& words);
  Answer undo();
  Answer run_futures(const Words& words);

  /// Returns the tree of the robot in focus, or the Error that it plays none.
  robot::Result<const agent::Tree*> tree() const { return tree_in(params(), focus_); }
  robot::Result<const agent::Tree*> tree_in(const Params& params, int robot) const;
  /// Reads a condition for this game.
  robot::Result<Stop> stop_in(const std::string& text) const;

  /// Moves by a number of decisions, seconds or ticks.
  Answer move(const Words& words, bool forward);
  Answer arrive(Tick tick);
  /// Puts the edited state and setup here.
  std::string edit(const State& state, SharedSetup setup, const std::string& what);
  /// Returns the robot that the words name, or the one in focus.
  robot::Result<int> robot_in(const Words& words, std::size_t index) const;
  const Params& params() const { return timeline_.setup_at(now_)->params; }
  int players() const { return params().rules.players; }

  Timeline timeline_;
  io::SituationTeams teams_;
  Tick now_;
  int focus_;
  std::vector<Edit> edits_;
  std::vector<Stop> breakpoints_;
};

}  // namespace sim::debug
