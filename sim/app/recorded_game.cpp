#include "sim/app/recorded_game.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/sim.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/bridge/from_messages.h"
#include "robot/bridge/teams_seen.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/read_all.h"

namespace sim::app {
namespace {

namespace pb = ::foresight;

using robot::Error;
using robot::Result;
using robot::logging::Session;
using Truths = std::vector<robot::logging::Recorded<pb::GroundTruth>>;

constexpr std::uint64_t kLongestNs = 6ull * 3600 * robot::kSecond;
constexpr auto kRate = static_cast<std::uint64_t>(kTicksPerSecond);
constexpr std::uint32_t kMostPlayers = 20;

std::optional<pb::Simulation> simulation_of(const Session& session) {
  const auto all = robot::logging::read_all<pb::Simulation>(session, robot::memory::kSimulationTopic);
  if (all.empty()) return {};
  return all.front().value;
}

/// Returns the half in which the recording begins: 1 if nobody says.
int half_of(const Session& session) {
  for (const robot::logging::StreamFile& stream : session.streams) {
    if (!stream.topic.ends_with("/game") || stream.schema != pb::GameState::descriptor()->full_name()) continue;
    const auto all = robot::logging::read_in_order<pb::GameState>(session, stream.topic);
    if (!all.empty()) return static_cast<int>(std::clamp(all.front().value.half(), 1u, 4u));
  }
  return 1;
}

/// The samples of a team by jersey number, then as tracks by place.
class Squad {
 public:
  void add(std::uint32_t player, const replay::Sample& sample) { samples_[player].push_back(sample); }

  void fill(Side side, int players, RecordedGame& into) {
    // numbers of the simulator first, then the others in the places that are free
    for (const bool own : {true, false})
      for (auto& [player, samples] : samples_) {
        const bool fits = player <= static_cast<std::uint32_t>(players);
        if (fits != own) continue;
        const int place = fits ? static_cast<int>(player) : free_place(side, players, into);
        if (place == 0) continue;
        const auto robot = static_cast<std::size_t>(robot_of(side, place));
        into.players[robot] = player;
        into.recording.robots[robot] = replay::Track(std::move(samples));
      }
  }

 private:
  static int free_place(Side side, int players, const RecordedGame& game) {
    // the first place is the goalkeeper's: it is used last
    for (int place = 2; place <= players; ++place)
      if (game.players[static_cast<std::size_t>(robot_of(side, place))] == 0) return place;
    return game.players[static_cast<std::size_t>(robot_of(side, 1))] == 0 ? 1 : 0;
  }

  std::map<std::uint32_t, std::vector<replay::Sample>> samples_;  // by jersey number
};

}  // namespace

std::string recorded_rules(const Session& session) {
  const auto simulation = simulation_of(session);
  return simulation ? simulation->rules() : "";
}

Result<RecordedGame> read_recorded_game(const Session& session, int players, const WantedTeams& wanted) {
  const Truths truths = robot::logging::read_in_order<pb::GroundTruth>(session, robot::memory::kTruthTopic);
  if (truths.empty()) return Error{session.id() + " has no " + robot::memory::kTruthTopic};
  const std::uint64_t start_ns = truths.front().capture_ns;
  if (truths.back().capture_ns - start_ns > kLongestNs)
    return Error{session.id() + ": " + robot::memory::kTruthTopic + " is longer than 6 hours"};

  RecordedGame game;
  const auto simulation = simulation_of(session);
  if (simulation && simulation->home().number() != simulation->away().number()) {
    game.teams = {.home = simulation->home().number(), .away = simulation->away().number()};
  } else if (wanted.home == 0 || wanted.away == 0) {
    const auto seen = robot::bridge::teams_seen(truths);
    if (!seen) return seen.failure(session.id());
    game.teams = *seen;
  }
  if (wanted.home != 0) game.teams.home = wanted.home;
  if (wanted.away != 0) game.teams.away = wanted.away;
  if (game.teams.home == game.teams.away)
    return Error{"the teams must have different numbers, got " + std::to_string(game.teams.home) + " twice"};

  Squad squads[2];
  std::vector<replay::Sample> ball;
  for (const auto& truth : truths) {
    const auto at = static_cast<Tick>(((truth.capture_ns - start_ns) * kRate + robot::kSecond / 2) / robot::kSecond);
    game.recording.length = at;
    if (truth.value.has_ball())
      ball.push_back({.at = at, .position = {truth.value.ball().x(), truth.value.ball().y()}, .heading = {}});
    for (const auto& robot : truth.value.robots()) {
      if (!robot.has_team() || robot.player() < 1 || robot.player() > kMostPlayers) continue;
      if (robot.team() != game.teams.home && robot.team() != game.teams.away) continue;
      replay::Sample sample{
          .at = at, .position = {robot.x(), robot.y()}, .heading = {}, .fallen = robot.has_fallen() && robot.fallen()};
      if (robot.has_heading()) sample.heading = robot.heading();
      squads[robot.team() == game.teams.home ? 0 : 1].add(robot.player(), sample);
    }
  }
  game.recording.half = half_of(session);
  game.recording.ball = replay::Track(std::move(ball));
  squads[0].fill(Side::home, players, game);
  squads[1].fill(Side::away, players, game);
  return game;
}

}  // namespace sim::app
