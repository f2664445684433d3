// Ground truth that other programs recorded becomes /truth/world of a session.
#include "robot/lab/import/truth_feeds.h"

#include <gtest/gtest.h>

#include <string>

#include "proto/foresight/truth.pb.h"
#include "robot/core/clock.h"
#include "robot/lab/clocks/session_report.h"
#include "robot/lab/import/session_sink.h"
#include "robot/logging/sessions/session.h"
#include "robot/truth/feeds/truth_csv.h"
#include "tests/robot/truth/feeds/ssl_logs.h"
#include "tests/robot/truth/feeds/ssl_packets.h"
#include "tests/support/read_stream.h"
#include "tests/support/recording_sink.h"
#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kEpochNs = 1'246'406'400 * kSecond;
constexpr std::uint64_t kReceivedNs = 1'700'000'000 * kSecond;

/// A second of a ball that rolls, 30 times a second.
std::string rolling_ball() {
  std::string text = "t,ball_x,ball_y,x_14_2,y_14_2,heading_14_2,note\n";
  for (int i = 0; i < 30; ++i)
    text += std::to_string(i / 30.0) + "," + std::to_string(0.1 * i) + ",0.5,-1,2,0.25,rolls\n";
  return text;
}

TEST(ImportTruthCsv, BecomesASessionThatInspectReads) {
  const tests::TemporaryFolder folder;
  const std::string text = rolling_ball();
  const auto written = logging::write_session(
      folder / "session", {.name = "csv", .robot = "0/1", .profile = "import", .start_ns = kEpochNs},
      [&](logging::SessionWriter& writer) -> Result<void> {
        SessionSink sink("0/1", writer);
        const auto report = import_truth_csv(text, kEpochNs, sink);
        if (!report) return report.failure();
        return {};
      });
  ASSERT_TRUE(written) << written.error();

  const auto report = inspect(folder / "session");
  ASSERT_TRUE(report) << report.error();
  ASSERT_EQ(report->streams.size(), 1u);
  EXPECT_EQ(report->streams[0].topic, "/truth/world");
  EXPECT_EQ(report->streams[0].messages, 30u);
  EXPECT_EQ(report->session.start_ns, kEpochNs);

  // each message is the moment of its line
  const auto records = tests::read_stream(folder / "session" / report->streams[0].file);
  const auto csv = truth::read_truth_csv(text);
  ASSERT_EQ(records.size(), csv->moments.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].capture_ns, kEpochNs + csv->moments[i].capture_ns);
    EXPECT_EQ(records[i].bytes, csv->moments[i].truth.SerializeAsString());
  }
}

TEST(ImportTruthCsv, AFileWithADateKeepsIt) {
  const std::string text = "t_ns,ball_x,ball_y\n1700000000000000007,1,2\n";
  tests::RecordingSink sink;
  ASSERT_TRUE(import_truth_csv(text, kEpochNs, sink));
  EXPECT_EQ(sink.entries.at(0).capture_ns, kReceivedNs + 7);
  EXPECT_EQ(truth_csv_date(text), kReceivedNs + 7);
  EXPECT_EQ(truth_csv_date(rolling_ball()), std::nullopt);
  EXPECT_EQ(truth_csv_date("no table"), std::nullopt);
}

TEST(ImportTruthCsv, ReportsDamageAndColumnsOfOtherData) {
  tests::RecordingSink sink;
  const auto report = import_truth_csv("t,ball_x,ball_y,note\n0,1,2,a\n1,x,2,a\n", kEpochNs, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "line 3, column ball_x: expected a number of -100 .. 100 [m], got 'x'");
  EXPECT_EQ(report->warnings, std::vector<std::string>{"columns of other data: note"});
  EXPECT_EQ(report->messages.at("/truth/world"), 1u);
}

TEST(ImportTruthCsv, AWrongHeaderAndAFullDiskAreErrors) {
  tests::RecordingSink sink;
  EXPECT_EQ(import_truth_csv("a,b\n", 0, sink).error(),
            "line 1: expected a column t, such as 't', 't_ns' or 'time', got none");
  tests::FullSink full;
  EXPECT_EQ(import_truth_csv(rolling_ball(), 0, full).error(), "disk full");
}

/// A log of two cameras, with a referee's message and a wrong packet between.
std::string ssl_log() {
  std::string log = tests::kSslLogHead + tests::ssl_log_message(kReceivedNs, 4, tests::field_packet(12000, 9000, 300));
  for (std::uint32_t i = 1; i <= 10; ++i) {
    const std::uint64_t received_ns = kReceivedNs + i * 16 * kMillisecond;
    const double sent = 100 + 0.016 * i;
    const auto x = static_cast<float>(1000 + i);
    log += tests::ssl_log_message(
        received_ns, 4,
        tests::PacketFrame{.camera = 0, .frame = i, .sent = sent, .balls = {{.x = x}}, .yellow = {{.id = 2, .x = 500}}}
            .bytes());
    log += tests::ssl_log_message(received_ns, 3, "referee");
    log +=
        tests::ssl_log_message(received_ns + kMillisecond, 4,
                               tests::PacketFrame{.camera = 1, .frame = i, .sent = sent, .blue = {{.id = 3}}}.bytes());
  }
  return log + tests::ssl_log_message(kReceivedNs + kSecond, 4, "noise");
}

TEST(ImportSslLog, TheWorldsOfAllCamerasAreImported) {
  tests::RecordingSink sink;
  const auto report = import_ssl_log(ssl_log(), {.yellow = 14, .blue = 5}, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->about, "field of 12.00 x 9.00 m; yellow is team 14, blue is team 5");
  EXPECT_EQ(report->warnings, std::vector<std::string>{"1 packets could not be read, such as: expected a packet of "
                                                       "SSL-Vision, got 5 other bytes"});
  const auto worlds = sink.of<pb::GroundTruth>("/truth/world");
  ASSERT_EQ(worlds.size(), 11u);  // two with one camera each, until both are known
  ASSERT_EQ(worlds[5]->robots_size(), 2);
  EXPECT_EQ(worlds[5]->robots(0).team(), 14u);
  EXPECT_EQ(worlds[5]->robots(0).player(), 2u);
  EXPECT_EQ(worlds[5]->robots(1).team(), 5u);
  EXPECT_NEAR(worlds[5]->ball().x(), 1.005, 1e-5);
  EXPECT_EQ(ssl_log_date(ssl_log()), kReceivedNs);
}

TEST(ImportSslLog, EveryTruncationImportsWhatIsBeforeIt) {
  const std::string whole = ssl_log();
  tests::RecordingSink all;
  ASSERT_TRUE(import_ssl_log(whole, {}, all));
  for (std::size_t size = 16; size < whole.size(); size += 7) {
    tests::RecordingSink some;
    const auto report = import_ssl_log(whole.substr(0, size), {}, some);
    ASSERT_TRUE(report) << report.error();
    EXPECT_TRUE(tests::is_start_of(some.entries, all.entries));
  }
}

TEST(ImportSslLog, AnotherFileAndAFullDiskAreErrors) {
  tests::RecordingSink sink;
  EXPECT_EQ(import_ssl_log("\x1f\x8b", {}, sink).error(),
            "expected a log of the SSL, got a packed file: unpack it with gunzip");
  EXPECT_EQ(ssl_log_date("other"), std::nullopt);
  tests::FullSink full;
  EXPECT_EQ(import_ssl_log(ssl_log(), {}, full).error(), "disk full");
}

}  // namespace
}  // namespace robot::lab
