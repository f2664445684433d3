#include "robot/fit/radio/team_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "proto/foresight/team.pb.h"
#include "robot/core/files.h"
#include "robot/fit/radio/packet_contents.h"
#include "robot/fit/radio/radio.h"
#include "robot/lab/import/session_sink.h"
#include "robot/lab/import/teamcomm.h"
#include "robot/logging/sessions/session_writer.h"
#include "tests/support/real_data.h"
#include "tests/support/simulated_robots.h"
#include "tests/support/temporary_folder.h"

namespace robot::fit {
namespace {

constexpr std::uint64_t kStartNs = 1'246'406'400ull * 1'000'000'000, kSecondNs = 1'000'000'000;

/// A session of robot 14/5 and its evidence, without a truth.
class RecordedTeam {
 public:
  explicit RecordedTeam(const std::function<Result<void>(lab::ImportSink& sink)>& fill) {
    logging::SessionInfo info;
    info.name = "game";
    info.robot = "14/5";
    info.start_ns = kStartNs;
    const Result<void> written =
        logging::write_session(folder_ / "game", info, [&](logging::SessionWriter& writer) -> Result<void> {
          lab::SessionSink sink("14/5", writer);
          return fill(sink);
        });
    EXPECT_TRUE(written) << written.error();
    if (Result<Evidence> gathered = gather({folder_ / "game"}, {}, 0)) evidence = *std::move(gathered);
  }

  Evidence evidence;

 private:
  ::tests::TemporaryFolder folder_;
};

/// A packet of player 2 that `team` shows at `shown_ns`.
foresight::Team team_with(std::uint64_t sent_ns, std::uint64_t received_ns) {
  foresight::Team team;
  foresight::Teammate& mate = *team.add_teammates();
  mate.set_player(2);
  mate.set_sent_ns(sent_ns);
  mate.set_received_ns(received_ns);
  mate.mutable_pose()->set_x(1);
  mate.mutable_ball()->set_seen_ns(received_ns - kSecondNs / 2);
  return team;
}

TEST(TeamRecord, ARobotWithoutATruthKeepsItsPackets) {
  const RecordedTeam recorded([](lab::ImportSink& sink) -> Result<void> {
    for (std::uint64_t i = 0; i < 5; ++i) {
      const std::uint64_t received_ns = kStartNs + i * kSecondNs;
      foresight::Team team = team_with(received_ns - 100'000'000, received_ns);
      team.set_sent_ns(received_ns - 50'000'000);
      team.set_messages_sent(static_cast<std::uint32_t>(i + 1));
      // the same packet again is not a new one
      for (const std::uint64_t later_ns : {10'000'000, 500'000'000})
        if (auto taken = sink.message("team", received_ns + later_ns, team); !taken) return taken;
    }
    return {};
  });
  ASSERT_EQ(recorded.evidence.untracked.size(), 1u);
  ASSERT_EQ(recorded.evidence.left_out.size(), 1u) << "the reason why it has no truth";
  const TeamRecord record = read_team(recorded.evidence.untracked[0]);
  EXPECT_EQ(record.robot, "14/5");
  EXPECT_FALSE(record.simulated);
  ASSERT_EQ(record.heard.size(), 5u);
  EXPECT_EQ(record.sent.size(), 5u);
  EXPECT_NEAR(record.heard[1].arrived - record.heard[1].sent, 0.1, 1e-6);
  EXPECT_NEAR(record.heard[1].ball_age, 0.4, 1e-6);
  EXPECT_EQ(record.heard[1].x, 1);
  EXPECT_NEAR(record.late, 0.01, 1e-6);
}

TEST(TeamRecord, ASimulatedPacketArrivesATickBeforeTheFirstMessageWithIt) {
  const RecordedTeam recorded([](lab::ImportSink& sink) -> Result<void> {
    for (std::uint64_t i = 0; i < 5; ++i) {
      const std::uint64_t sent_ns = kStartNs + i * kSecondNs;
      if (auto taken = sink.message("team", sent_ns + 6 * kSecondNs / 30, team_with(sent_ns, sent_ns)); !taken)
        return taken;
    }
    return {};
  });
  const TeamRecord record = read_team(recorded.evidence.untracked.at(0));
  EXPECT_TRUE(record.simulated);
  EXPECT_TRUE(std::isnan(record.heard.at(0).arrived)) << "it may have come before the recording";
  EXPECT_NEAR(record.heard.at(3).arrived - record.heard[3].sent, 5 / 30., 1e-6);
  EXPECT_EQ(record.late, 0);
}

TEST(TeamRecord, PacketsWithTimesThatCannotBeAreCounted) {
  const RecordedTeam recorded([](lab::ImportSink& sink) -> Result<void> {
    for (std::uint64_t i = 0; i < 5; ++i) {
      const std::uint64_t now_ns = kStartNs + i * kSecondNs;
      // the third has an arrival of another epoch, the fourth a time of sending
      foresight::Team team = team_with(i == 3 ? 5 + i : now_ns - 100'000'000, i == 2 ? 7 : now_ns);
      if (auto taken = sink.message("team", now_ns, team); !taken) return taken;
    }
    return {};
  });
  const TeamRecord record = read_team(recorded.evidence.untracked.at(0));
  EXPECT_EQ(record.damaged, 2u);
  EXPECT_EQ(record.heard.size(), 4u);
  EXPECT_TRUE(std::isnan(record.heard[2].sent));
}

TEST(TeamRecord, PlantedFiguresComeOutOfSimulatedGames) {
  const ::tests::TemporaryFolder folder;
  const Evidence evidence = tests::simulated_robots(
      folder / "game",
      {.models = "match,radio.delay=0.15,radio.loss=0.25", .seconds = 120, .seed = 3, .clock_error = 0.02});
  const Report report = fit_radio(evidence, {});
  for (const auto& [name, planted] : {std::pair("radio.delay", 0.15), {"radio.loss", 0.25}}) {
    const auto figure = std::ranges::find(report.figures, name, &Figure::name);
    ASSERT_NE(figure, report.figures.end()) << name;
    EXPECT_LT(figure->low, planted) << name;
    EXPECT_GT(figure->high, planted) << name;
    EXPECT_TRUE(figure->is_known()) << name;
  }
}

// --- two real robots ---

TEST(RealPackets, TwoRobotsOf2016SendFiveTimesASecond) {
  REAL_DATA_OR_SKIP(path, "teamcomm/teamcomm_2016-06-05_11-59-40-917.log");
  const RecordedTeam recorded([&](lab::ImportSink& sink) -> Result<void> {
    const Result<std::string> bytes = read_file(path, 1 << 24);
    if (!bytes) return bytes.failure();
    const auto report = lab::import_teamcomm(*bytes, kStartNs, sink);
    if (!report) return report.failure();
    return {};
  });
  ASSERT_EQ(recorded.evidence.untracked.size(), 1u);
  const auto summaries = summaries_of(read_teams(recorded.evidence));
  ASSERT_EQ(summaries.size(), 2u);
  for (const SenderSummary& summary : summaries) {
    EXPECT_EQ(summary.packets, 609u);
    EXPECT_NEAR(summary.seconds, 124.5, 0.1);
    EXPECT_NEAR(summary.gap, 0.205, 0.001);
    EXPECT_NEAR(summary.longest_gap, 0.237, 0.014);
  }

  const Report report = fit_radio(recorded.evidence, {});
  EXPECT_NE(std::ranges::find(report.kept,
                              "radio.delay: expected the times of sending and arrival, got packets without a time of "
                              "sending by a clock that is known"),
            report.kept.end());
  ASSERT_EQ(report.figures.size(), 2u);
  EXPECT_EQ(report.figures[0].name, "radio.loss_in_gaps");
  EXPECT_EQ(report.figures[0].value, 0) << "no gap is as long as two intervals";
  EXPECT_EQ(report.figures[0].low, 0);
  EXPECT_LT(report.figures[0].high, 0.01);
  EXPECT_EQ(report.figures[1].name, "radio.interval");
  EXPECT_NEAR(report.figures[1].value, 0.205, 0.001);
  // robot 1 turns and sees the ball in two thirds of its packets, robot 2 almost always
  EXPECT_NEAR(summaries[0].ball, 0.65, 0.02);
  EXPECT_GT(summaries[1].ball, 0.99);
  EXPECT_EQ(summaries[0].jumps + summaries[1].jumps, 0u);
}

}  // namespace
}  // namespace robot::fit
