// A robot's memory in the middle of a simulated game, for tests.
#pragma once

#include <memory>
#include <string>

#include "robot/bridge/from_messages.h"
#include "robot/bridge/to_messages.h"
#include "robot/core/clock.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"

namespace robot::bridge::test {

namespace pb = ::foresight;

/// 14/2 in a game of `models`, `seconds` after its beginning.
struct Played {
  sim::io::PreparedGame setup;
  sim::State state;
  SessionClock clock;
  std::shared_ptr<memory::Memory> memory = std::make_shared<memory::Memory>("14/2", clock);
  memory::Channels channels;
  Timeline timeline;

  explicit Played(const std::string& models = "match", float seconds = 80) {
    auto prepared = sim::io::prepare({.models = {models, models}, .pace = sim::Pace::every_tick});
    if (!prepared) throw std::runtime_error(prepared.error());
    setup = std::move(*prepared);
    sim::referee::Events events;
    state = sim::begin(setup.params, {.seed = 3}, events);
    while (state.world.tick < sim::ticks(seconds)) sim::step(setup.params, state, events);
    timeline.epoch_ns = clock.now_ns() - timeline.since_start_ns(state.world.tick);
    if (auto listed = list(memory, channels); !listed) throw std::runtime_error(listed.error());
    write();
  }

  std::uint64_t now_ns() const { return timeline.at(state.world.tick); }

  /// All memory objects of 14/2.
  void write() {
    constexpr int kRobot = 1;
    const TeamNumbers teams;
    const sim::agent::Beliefs& beliefs = state.robots[kRobot].beliefs;
    const sim::Models& models = setup.params.teams[0].models;
    const auto put = [&](auto& object, auto&& fill) {
      auto draft = object.draft();
      fill(*draft);
      object.write(std::move(draft), now_ns());
    };
    if (beliefs.ball.seen != sim::kNever)
      put(memory->ball, [&](pb::Ball& ball) { to_proto(beliefs.ball, models.ball.deceleration, timeline, ball); });
    put(memory->simulation,
        [&](pb::Simulation& simulation) { simulation.set_speed(static_cast<float>(timeline.speed)); });
    put(memory->pose, [&](pb::Pose& pose) { to_proto(beliefs.pose, pose); });
    put(memory->team, [&](pb::Team& team) { to_proto(beliefs, 2, timeline, team); });
    put(memory->opponents, [&](pb::Opponents& opponents) { to_proto(beliefs, timeline, opponents); });
    put(memory->game, [&](pb::GameState& game) { to_proto(setup.params, state, kRobot, teams, timeline, game); });
    put(memory->motion_status, [&](pb::MotionStatus& status) {
      to_proto(state.world.bodies[kRobot], state.robots[kRobot].command, models.motion, state.world.tick, status);
    });
  }

  Recollection recollection() const { return recollect(channels, "14/2", now_ns()); }
};

/// Both teams' players 1 .. 4 wear these numbers, the first keeps, and all others of 20 are substitutes.
constexpr std::uint32_t kNumbers[] = {9, 12, 14, 20};

inline Recollection renumbered(Recollection from) {
  const auto renumber = [](auto& told) { told.set_player(kNumbers[told.player() - 1]); };
  pb::GameState& game = from.game->value;
  game.set_own_player(kNumbers[game.own_player() - 1]);
  for (pb::TeamState* team : {game.mutable_own(), game.mutable_opponent()}) {
    const pb::TeamState before = *team;
    team->set_goalkeeper(kNumbers[0]);
    team->clear_players();
    for (int i = 0; i < 20; ++i) {
      team->add_players()->set_penalised(true);
      team->mutable_players(i)->set_penalty(pb::PlayerState::PENALTY_SUBSTITUTE);
    }
    for (int i = 0; i < before.players_size(); ++i)
      *team->mutable_players(static_cast<int>(kNumbers[i]) - 1) = before.players(i);
  }
  for (pb::Teammate& mate : *from.team->value.mutable_teammates()) renumber(mate);
  for (auto& opponent : *from.opponents->value.mutable_opponents())
    if (opponent.has_player()) renumber(opponent);
  return from;
}

}  // namespace robot::bridge::test
