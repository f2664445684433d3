#include "tests/support/simulated_robots.h"

#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "robot/bridge/narrator.h"
#include "robot/bridge/simulated_game.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/session_writer.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"

namespace robot::tests {
namespace {

constexpr std::uint64_t kEpochNs = 1'700'000'000 * kSecond;

/// Returns the value, or throws what is wrong: a test or a bench that cannot go on.
template <class T>
T expected(Result<T> result) {
  if (!result) throw std::runtime_error(result.error());
  return std::move(*result);
}
void expect(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error());
}

/// Writes each new version of all objects.
class Scribe {
 public:
  Scribe(const std::filesystem::path& folder, const bridge::Narrator& narrator)
      : writer_(expected(logging::SessionWriter::create(folder, {.robot = "14/1"}, logging::Compression::none))) {
    expect(narrator.list(channels_));
    for (const auto& channel : channels_.all()) streams_.push_back({.channel = channel});
  }

  void write() {
    for (Stream& stream : streams_) {
      const auto newest = stream.channel->newest();
      if (!newest || newest->sequence() == stream.written) continue;
      stream.written = newest->sequence();
      expect(writer_->write(stream.channel->info(), newest->capture_ns(), newest->bytes()));
    }
  }

  void close() { expect(writer_->close()); }

 private:
  struct Stream {
    std::shared_ptr<memory::Channel> channel;
    std::uint64_t written = 0;
  };
  std::unique_ptr<logging::SessionWriter> writer_;
  memory::Channels channels_;
  std::vector<Stream> streams_;
};

void record(const std::filesystem::path& folder, const SimulatedPlan& plan) {
  const auto prepared = expected(sim::io::prepare({.rules = plan.rules,
                                                   .strategies = {plan.strategy, plan.strategy},
                                                   .models = {plan.models, plan.models},
                                                   .players = plan.players,
                                                   .pace = plan.pace}));
  sim::referee::Events events;
  bridge::SimulatedGame game(prepared.params, {.rules = plan.rules},
                             sim::begin(prepared.params, {.seed = plan.seed}, events));
  const ManualClock clock;
  bridge::Narrator narrator(game, 0, clock);
  Scribe scribe(folder, narrator);
  const sim::Tick end = sim::ticks(static_cast<float>(plan.seconds));
  const auto write = [&] {
    narrator.write(game, {.epoch_ns = kEpochNs});
    narrator.write_status(game, {}, {.epoch_ns = kEpochNs});
    scribe.write();
  };
  write();
  while (!game.finished() && game.state().world.tick < end) {
    game.tick(events);
    write();
  }
  scribe.close();
}

/// Adds the errors to a truth, and to the robots that were watched in it.
void spoil(fit::Evidence& evidence, const SimulatedPlan& plan) {
  std::mt19937_64 random(plan.seed * 7919 + 1);
  std::normal_distribution<double> normal;
  const double late = plan.clock_error * normal(random);
  lab::TruthRecord record = evidence.games.front()->record;
  const auto move = [&](lab::Path& path) {
    for (lab::PlaceAt& place : path) {
      place.at += late;
      place.x += plan.place_error * normal(random), place.y += plan.place_error * normal(random);
      place.heading = std::remainder(place.heading + plan.heading_error * normal(random), 2 * M_PI);
    }
  };
  move(record.ball);
  for (lab::Sighting& sighting : record.sightings) sighting.at += late;
  for (lab::TrueRobotPath& robot : record.robots) move(robot.path);
  record.ball_deviation = plan.place_error;
  const auto game = std::make_shared<const fit::TrueGame>(
      fit::TrueGame{.name = evidence.games.front()->name, .record = std::move(record)});
  evidence.games.front() = game;
  for (fit::WatchedRobot& robot : evidence.robots) {
    robot.game = game;
    robot.clock.deviation = plan.clock_error;
    for (const lab::TrueRobotPath& one : game->record.robots)
      if (one.name == robot.session.info.robot) robot.path = one.path;
  }
}

}  // namespace

fit::Evidence simulated_robots(const std::filesystem::path& folder, const SimulatedPlan& plan) {
  record(folder, plan);
  fit::Evidence evidence = expected(fit::gather({folder}, {}, 60 * kSecond));
  spoil(evidence, plan);
  return evidence;
}

void append(fit::Evidence& evidence, fit::Evidence other) {
  for (auto& game : other.games) evidence.games.push_back(std::move(game));
  for (auto& robot : other.robots) evidence.robots.push_back(std::move(robot));
  for (auto& robot : other.untracked) evidence.untracked.push_back(std::move(robot));
  for (auto& sentence : other.left_out) evidence.left_out.push_back(std::move(sentence));
}

}  // namespace robot::tests
