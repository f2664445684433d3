#include "sim/debug/commands.h"

#include "robot/core/text.h"

namespace sim::debug {
namespace {

constexpr CommandInfo kCommands[] = {
    {"goto", "goto MOMENT", "to [s] since the first tick, or half:minutes:seconds on the clock"},
    {"step", "step [N] [s|ticks]", "on by decisions of the robot in focus, by seconds or by ticks"},
    {"back", "back [N] [s|ticks]", "likewise back"},
    {"until", "until CONDITION", "on to the first moment at which it becomes true"},
    {"reverse-until", "reverse-until CONDITION", "back to the last one"},
    {"break", "break [CONDITION]", "sets a breakpoint; without a condition it lists them"},
    {"unbreak", "unbreak N", "removes one"},
    {"continue", "continue", "on to the first moment at which a breakpoint is met"},
    {"reverse-continue", "reverse-continue", "back to the last one"},
    {"robot", "robot 14/3", "puts a robot in focus"},
    {"why", "why [ROBOT]", "explains its newest decision"},
    {"whynot", "whynot SKILL|LEAF", "the smallest change that leads there, for the robot in focus"},
    {"show", "show", "ball and robots, and how far their beliefs are off"},
    {"nodes", "nodes", "the comparisons of the tree, with their numbers"},
    {"leaves", "leaves", "the leaves of the tree, with their arguments"},
    {"set", "set ball X Y", "[m, field] puts the ball down"},
    {"set", "set ROBOT at X Y [DEG]", "[m, field] puts a robot there"},
    {"set", "set ROBOT believes ball X Y", "[m, robot] it has just seen the ball there"},
    {"set", "set ROBOT believes at X Y [DEG]", "[m, team_field] its own pose"},
    {"set", "set threshold NODE VALUE", "of the tree of the robot in focus"},
    {"set", "set argument NAME VALUE of SKILL|LEAF",
     "likewise of its leaves, as in a strategy: tolerance 10 deg of kick"},
    {"set", "set luck N", "another seed from here on"},
    {"strategy", "strategy NAME", "another tree for the side of the robot in focus"},
    {"undo", "undo", "takes the last edit back, and goes to its moment"},
    {"futures", "futures [N] [SECONDS]", "plays on N times with and without the edits of the last edited moment"},
    {"help", "help", "this list"},
    {"quit", "quit", "ends"},
};

}  // namespace

std::span<const CommandInfo> commands() { return kCommands; }

std::string help_text() {
  std::string text;
  for (const CommandInfo& info : kCommands) {
    text += robot::formatted("  %-40s %s\n", std::string(info.usage).c_str(), std::string(info.about).c_str());
  }
  return text;
}

robot::Error usage(std::string_view name) {
  std::string all;
  for (const CommandInfo& info : kCommands)
    if (info.name == name) all += (all.empty() ? "" : ", ") + std::string(info.usage);
  return {"expected: " + all};
}

}  // namespace sim::debug
