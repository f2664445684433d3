#include "tests/support/recorded_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "robot/bridge/narrator.h"
#include "robot/bridge/simulated_game.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/session_writer.h"
#include "sim/io/matchup.h"
#include "sim/match/step.h"

namespace tests {
namespace {

constexpr std::uint64_t kEpochNs = 1'700'000'000 * robot::kSecond;

/// The recording of one machine.
struct Recording {
  std::unique_ptr<robot::logging::SessionWriter> writer;
  std::int64_t ahead_ns = 0;
  std::vector<std::pair<std::shared_ptr<robot::memory::Channel>, std::uint64_t>> channels;  // and the newest written

  Recording(const std::filesystem::path& path, const std::string& robot, double ahead)
      : ahead_ns(std::llround(ahead * 1e9)) {
    auto created = robot::logging::SessionWriter::create(path, {.robot = robot});
    EXPECT_TRUE(created) << created.error();
    writer = std::move(*created);
  }

  void write(const robot::memory::ChannelInfo& info, std::uint64_t capture_ns, const std::string& bytes) {
    EXPECT_TRUE(writer->write(info, capture_ns + static_cast<std::uint64_t>(ahead_ns), bytes));
  }

  void write_news(const std::function<void(foresight::GroundTruth&)>& change) {
    for (auto& [channel, written] : channels) {
      const auto newest = channel->newest();
      if (!newest || newest->sequence() == written) continue;
      written = newest->sequence();
      std::string bytes(newest->bytes());
      if (change && channel->info().topic == "/truth/world") {
        foresight::GroundTruth truth;
        EXPECT_TRUE(truth.ParseFromString(bytes));
        change(truth);
        bytes = truth.SerializeAsString();
      }
      write(channel->info(), newest->capture_ns(), bytes);
    }
  }
};

}  // namespace

void record_game(const std::filesystem::path& folder, const RecordedTruthPlan& plan) {
  const auto prepared = sim::io::prepare({.models = {plan.models, plan.models}, .pace = sim::Pace::every_tick});
  ASSERT_TRUE(prepared) << prepared.error();
  sim::referee::Events events;
  robot::bridge::SimulatedGame game(prepared->params, {}, sim::begin(prepared->params, {.seed = 7}, events));
  const robot::ManualClock clock;
  robot::bridge::Narrator narrator(game, 0, clock);
  robot::memory::Channels channels;
  ASSERT_TRUE(narrator.list(channels));
  std::vector<Recording> recordings;
  recordings.emplace_back(folder / "truth", "truth/1", 0);
  recordings.back().channels.emplace_back(channels.find("/truth/world"), 0);
  for (const auto& [name, ahead] : plan.ahead) {
    recordings.emplace_back(folder / (name.substr(0, name.find('/')) + "-" + name.substr(name.find('/') + 1)), name,
                            ahead);
    for (const char* object : {"ball", "pose"})
      recordings.back().channels.emplace_back(channels.find("/" + name + "/" + object), 0);
  }
  while (game.state().world.tick < sim::ticks(plan.from + plan.seconds)) {
    game.tick(events);
    if (game.state().world.tick < sim::ticks(plan.from)) continue;
    narrator.write(game, {.epoch_ns = kEpochNs});
    for (Recording& recording : recordings) recording.write_news(plan.change);
  }
  for (Recording& recording : recordings) EXPECT_TRUE(recording.writer->close());
}

void leave_tracks(foresight::GroundTruth& truth) {
  for (auto& robot : *truth.mutable_robots()) {
    robot.set_track(100 * robot.team() + robot.player());
    robot.clear_team(), robot.clear_player();
  }
}

void leave_places(foresight::GroundTruth& truth) {
  for (auto& robot : *truth.mutable_robots()) robot.clear_team(), robot.clear_player();
}

}  // namespace tests
