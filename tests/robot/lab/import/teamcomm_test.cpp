#include "robot/lab/import/teamcomm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "proto/foresight/team.pb.h"
#include "robot/core/files.h"
#include "tests/support/real_data.h"
#include "tests/support/recording_sink.h"

namespace robot::lab {
namespace {

/// A packet as it is sent.
struct Sent {
  unsigned time_ms = 0, player = 1, team = 14;
  float x = 1000, y = -500, heading = 0, ball_age = 0.5f;
};

/// Writes a log as the TeamCommunicationMonitor does: classes in full for the first packet, then references.
class TeamcommWriter {
 public:
  void add(const Sent& sent) {
    text_ += std::string("\x77\x09", 2) + big(sent.time_ms, 8) + '\x01' + '\x73';
    if (first_)
      text_ += '\x72' + string("teamcomm.net.SPLStandardMessagePackage") + std::string(8, 'v') + '\x02' + big(3, 2) +
               'I' + string("team") + 'L' + string("host") + '\x74' + string("Ljava/lang/String;") + '[' +
               string("message") + '\x74' + string("[B") + "\x78\x70";
    else
      text_ += '\x71' + big(0x7e0000, 4);
    text_ += big(sent.team, 4) + '\x74' + string("10.0.14.1") + '\x75';
    text_ += first_ ? '\x72' + string("[B") + std::string(8, 'v') + '\x02' + big(0, 2) + "\x78\x70"
                    : '\x71' + big(0x7e0005, 4);
    const std::string bytes = packet(sent);
    text_ += big(bytes.size(), 4) + bytes;
    first_ = false;
  }

  const std::string& file() const { return text_; }

 private:
  static std::string big(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
  }
  static std::string string(const std::string& text) { return big(text.size(), 2) + text; }
  static std::string packet(const Sent& sent) {
    std::string bytes = "SPL \x06";
    bytes += static_cast<char>(sent.player);
    bytes += static_cast<char>(sent.team);
    bytes += '\x01';
    const float numbers[10] = {sent.x, sent.y, sent.heading, 0, 0, 0, 0, sent.ball_age, 200, 100};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
    return bytes + std::string(20, '\0');
  }

  std::string text_ = std::string("\xac\xed\x00\x05", 4);
  bool first_ = true;
};

std::string small_log() {
  TeamcommWriter writer;
  writer.add({.time_ms = 0});
  writer.add({.time_ms = 0});  // the same packet again
  writer.add({.time_ms = 100, .player = 2});
  writer.add({.time_ms = 200, .x = 1100});
  return writer.file();
}

constexpr std::uint64_t kEpoch = 1'000'000'000'000;

TEST(Teamcomm, EachPacketIsAMessageWithTheNewestOfEachSender) {
  tests::RecordingSink sink;
  const std::string log = small_log();
  ASSERT_TRUE(is_teamcomm_log(log));
  const auto report = import_teamcomm(log, kEpoch, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->warnings, std::vector<std::string>{"1 packets are there twice; left out"});
  const auto teams = sink.of<foresight::Team>("team");
  ASSERT_EQ(teams.size(), 3u);
  EXPECT_EQ(sink.entries[2].capture_ns, kEpoch + 200'000'000);
  ASSERT_EQ(teams[2]->teammates_size(), 2);
  const foresight::Teammate &one = teams[2]->teammates(0), &two = teams[2]->teammates(1);
  EXPECT_FLOAT_EQ(one.pose().x(), 1.1f);
  EXPECT_FLOAT_EQ(one.pose().y(), -0.5f);
  EXPECT_FLOAT_EQ(one.ball().x(), 0.2f);
  EXPECT_TRUE(one.fallen());
  EXPECT_EQ(one.sent_ns(), 0u) << "not known";
  EXPECT_EQ(one.received_ns() - one.ball().seen_ns(), 500'000'000u);
  EXPECT_EQ(two.player(), 2u);
  EXPECT_EQ(two.received_ns(), kEpoch + 100'000'000);
}

TEST(Teamcomm, HeadingsInDegreesAndAgesInImagesAreRecognised) {
  TeamcommWriter writer;
  writer.add({.time_ms = 0, .heading = 90, .ball_age = 0});
  writer.add({.time_ms = 200, .heading = -170, .ball_age = 90'000});
  tests::RecordingSink sink;
  const auto report = import_teamcomm(writer.file(), kEpoch, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->about, "packets of team 14; headings in degrees, ages of the ball in images");
  const auto teams = sink.of<foresight::Team>("team");
  EXPECT_NEAR(teams.at(0)->teammates(0).pose().heading(), 1.5708, 1e-4);
  const foresight::Teammate& mate = teams.at(1)->teammates(0);
  EXPECT_NEAR(static_cast<double>(mate.received_ns() - mate.ball().seen_ns()) * 1e-9, 0.1, 1e-6);
}

TEST(Teamcomm, ANegativeAgeIsABallThatWasNeverSeen) {
  TeamcommWriter writer;
  writer.add({.ball_age = -1});
  tests::RecordingSink sink;
  ASSERT_TRUE(import_teamcomm(writer.file(), kEpoch, sink));
  EXPECT_FALSE(sink.of<foresight::Team>("team").at(0)->teammates(0).has_ball());
}

TEST(Teamcomm, PacketsOfAnotherTeamAndWithoutNumbersAreCounted) {
  TeamcommWriter writer;
  writer.add({});
  writer.add({.player = 2, .team = 5});
  writer.add({.player = 3, .x = NAN});
  tests::RecordingSink sink;
  const auto report = import_teamcomm(writer.file(), kEpoch, sink);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->messages.at("team"), 1u);
  EXPECT_EQ(report->warnings,
            (std::vector<std::string>{"1 packets are not of version 6, or have no numbers; left out",
                                      "1 packets are of another team or have a wrong time; left out"}));
}

TEST(Teamcomm, EveryTruncationGivesThePacketsBeforeItAndNamesTheDamage) {
  const std::string file = small_log();
  tests::RecordingSink whole;
  ASSERT_TRUE(import_teamcomm(file, kEpoch, whole));
  for (std::size_t size = 0; size < file.size(); ++size) {
    tests::RecordingSink sink;
    const auto report = import_teamcomm(std::string_view(file).substr(0, size), kEpoch, sink);
    if (!report) continue;
    EXPECT_TRUE(tests::is_start_of(sink.entries, whole.entries)) << size;
    EXPECT_TRUE(!report->damage.empty() || sink.entries.size() < whole.entries.size()) << size;
  }
}

TEST(Teamcomm, SurvivesEveryFlippedByte) {
  const std::string file = small_log();
  for (std::size_t i = 0; i < file.size(); ++i) {
    std::string flipped = file;
    flipped[i] = static_cast<char>(~flipped[i]);
    tests::RecordingSink sink;
    const auto report = import_teamcomm(flipped, kEpoch, sink);
    EXPECT_LE(sink.entries.size(), 4u) << i;
    EXPECT_EQ(report ? 0u : sink.entries.size(), 0u) << "an Error is for another file";
  }
}

TEST(Teamcomm, AnotherFileIsRefused) {
  tests::RecordingSink sink;
  EXPECT_EQ(
      import_teamcomm("SPL ", 0, sink).error(),
      "log of the TeamCommunicationMonitor: expected a Java stream of SPLStandardMessagePackage, got another file");
  tests::FullSink full;
  EXPECT_EQ(import_teamcomm(small_log(), kEpoch, full).error(), "disk full");
}

TEST(TeamcommRecording, HasTheKnownPackets) {
  REAL_DATA_OR_SKIP(path, "teamcomm/teamcomm_2016-06-05_11-59-40-917.log");
  const Result<std::string> bytes = read_file(path, 1 << 24);
  ASSERT_TRUE(bytes);
  ASSERT_TRUE(is_teamcomm_log(*bytes));
  tests::RecordingSink sink;
  const auto report = import_teamcomm(*bytes, kEpoch, sink);
  ASSERT_TRUE(report) << report.error();
  EXPECT_EQ(report->damage, "");
  EXPECT_EQ(report->messages.at("team"), 2u * 609);
  EXPECT_EQ(report->warnings, std::vector<std::string>{"1218 packets are there twice; left out"});
  EXPECT_EQ(report->about, "packets of team 14; headings in degrees, ages of the ball in images");
  EXPECT_NEAR(static_cast<double>(sink.entries.back().capture_ns - kEpoch) * 1e-9, 124.5, 0.1);
  const foresight::Teammate& first = sink.of<foresight::Team>("team")[0]->teammates(0);
  EXPECT_NEAR(first.pose().x(), -2.337, 1e-3);
  EXPECT_NEAR(first.ball().x(), 0.1182, 1e-4);
}

}  // namespace
}  // namespace robot::lab
