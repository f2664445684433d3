#include "sim/debug/decision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "sim/agent/trace.h"
#include "sim/match/fields.h"
#include "tests/sim/debug/played.h"

namespace sim::debug {
namespace {

using test::for_each_decision;
using test::setup_of;
using test::timeline_of;

/// Returns the first field in which two values differ, or "".
template <class Value>
std::string difference_of(Value a, Value b) {
  std::vector<std::uint64_t> bits;
  visit_fields(a, [&](const FieldPath&, auto field) { bits.push_back(bits_of(field)); });
  std::size_t i = 0;
  std::string first;
  visit_fields(b, [&](const FieldPath& path, auto field) {
    if (bits[i++] != bits_of(field) && first.empty()) first = path.text();
  });
  return first;
}

TEST(Decision, MadeAgainHasTheSameCommandAndMemoryToTheBit) {
  int seen = 0;
  for_each_decision(
      2000, 7,
      [&](const Params& params, const State& before, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        State after = before;
        referee::Events events;
        step(params, after, events);
        const Outcome outcome = decide(params, behaviour, decision);
        EXPECT_EQ(difference_of(outcome.command, after.robots[decision.robot].command), "");
        EXPECT_EQ(difference_of(outcome.mind, after.robots[decision.robot].mind), "");
        ++seen;
      });
  EXPECT_EQ(seen, 2000);
}

TEST(Decision, ThereIsOneExactlyWhereTheStepTracesOne) {
  const SharedSetup setup = setup_of("baseline", "passing", 60);
  State state = sim::test::begun(setup->params, 4);
  referee::Events events;
  std::vector<agent::Trace> traces(kMaxRobots);
  while (!finished(state) && !HasFailure()) {
    const State before = state;
    for (agent::Trace& trace : traces) trace.clear();
    step(setup->params, state, events, kEverybody, traces.data());
    for_each_robot(state.world.players, [&](int robot) {
      EXPECT_EQ(decides(before, robot), traces[static_cast<std::size_t>(robot)].skill[0] != 0)
          << robot << " in tick " << before.world.tick;
    });
  }
}

TEST(Decision, TheNewestOneBeforeATickIsFound) {
  const SharedSetup setup = setup_of("baseline", "baseline", 60);
  Timeline timeline = timeline_of(setup, 4);
  std::vector<Tick> newest(kMaxRobots, kNever);
  timeline.replay(0, 2500, [&](const State& before, const State&, const referee::Events&) {
    for_each_robot(before.world.players, [&](int robot) {
      if (decides(before, robot)) newest[static_cast<std::size_t>(robot)] = before.world.tick;
    });
    if (before.world.tick % 131 != 7) return true;
    for_each_robot(before.world.players, [&](int robot) {
      Timeline copy = timeline;
      const auto decision = decision_before(copy, before.world.tick, robot);
      EXPECT_EQ(decision ? decision->tick : kNever, newest[static_cast<std::size_t>(robot)]) << before.world.tick;
      if (decision) {
        EXPECT_EQ(decision->robot, robot);
      }
    });
    return true;
  });
}

TEST(Thought, FeaturesHaveTheValuesThatTheRobotCompared) {
  for_each_decision(
      1000, 11,
      [&](const Params& params, const State&, const Decision& decision, const agent::TreeBehaviour& behaviour) {
        agent::Trace trace;
        decide(params, behaviour, decision, &trace);
        const Thought thought(params, behaviour.tree(), decision);
        for (const agent::Trace::Node& node : trace.visited) {
          if (node.feature[0] == 0) continue;
          const float value = value_of(agent::find_feature(node.feature), thought.view());
          EXPECT_TRUE(value == node.value || (std::isnan(value) && std::isnan(node.value))) << node.feature;
        }
      });
}

}  // namespace
}  // namespace sim::debug
