// Sessions with a planted offset between their clocks.
#include "robot/lab/clocks/clock_agreement.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "robot/lab/clocks/session_report.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/memory.h"
#include "tests/support/temporary_folder.h"

namespace robot::lab {
namespace {

constexpr std::uint64_t kStart = 1'700'000'000 * kSecond;

struct Planted : testing::Test {
  const tests::TemporaryFolder folder;

  struct Measured {
    std::string peer;
    std::int64_t offset_ns;
    std::uint64_t round_trip_ns;
  };

  /// Writes a session of `robot` with clock samples, one a second.
  logging::Session session(const std::string& robot, const std::vector<Measured>& samples,
                           const std::string& clock_of = "") {
    const auto path = folder / (robot.substr(0, 2) + "-" + robot.substr(3));
    auto writer = logging::SessionWriter::create(path, {.robot = robot});
    EXPECT_TRUE(writer);
    const memory::ChannelInfo info = memory::Memory(clock_of.empty() ? robot : clock_of, ManualClock()).clock.info();
    std::uint64_t at_ns = kStart;
    foresight::ClockSample own;
    own.set_source(foresight::ClockSample::SOURCE_SYSTEM);
    EXPECT_TRUE((*writer)->write(info, at_ns, own.SerializeAsString()));
    for (const Measured& measured : samples) {
      foresight::ClockSample sample;
      sample.set_source(foresight::ClockSample::SOURCE_PEER);
      sample.set_peer(measured.peer);
      sample.set_offset_ns(measured.offset_ns);
      sample.set_round_trip_ns(measured.round_trip_ns);
      EXPECT_TRUE((*writer)->write(info, at_ns += kSecond, sample.SerializeAsString()));
    }
    EXPECT_TRUE((*writer)->close());
    auto read = logging::read_session(path);
    EXPECT_TRUE(read);
    return std::move(*read);
  }
};

TEST_F(Planted, TheOffsetOfTwoRobotsFollowsFromAMachineThatMeasuredBoth) {
  // 14/3 is 0.35 s ahead of 14/2; long round trips have an error of half of them
  const RecordedClock two = read_clock(session("14/2", {{"10.0.14.7:50001", 90'000'000, 180'000'000},
                                                        {"10.0.14.7:50001", 1'000'000, 2'000'000},
                                                        {"10.0.14.7:50009", -40'000'000, 90'000'000}}));
  const RecordedClock three = read_clock(session("14/3", {{"10.0.14.7:50002", -349'000'000, 1'000'000},
                                                          {"10.0.14.7:50002", -300'000'000, 120'000'000},
                                                          {"10.0.14.9:50002", 7, 10}}));
  ASSERT_EQ(two.peers.size(), 1u);
  EXPECT_EQ(two.peers.at("10.0.14.7").offset_ns, 1'000'000);
  EXPECT_EQ(two.peers.at("10.0.14.7").error_ns, 1'000'000u);
  const auto found = compare(two, three);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->offset.offset_ns, 350'000'000);
  EXPECT_EQ(found->offset.error_ns, 1'500'000u);
  EXPECT_EQ(found->by, "10.0.14.7");
  EXPECT_EQ(compare(three, two)->offset.offset_ns, -350'000'000);

  const auto agreements = agree({two, three}, kSecond);
  ASSERT_TRUE(agreements);
  EXPECT_EQ(agreements->at(0).shift_ns, 0);
  EXPECT_EQ(agreements->at(1).shift_ns, -350'000'000);
  EXPECT_EQ(agreements->at(1).sentence,
            "14/3's clock is 0.350 s ahead (± 1.5 ms) of 14/2's, by 10.0.14.7: its times are shifted");

  const auto refused = agree({two, three}, 100 * kMillisecond);
  ASSERT_FALSE(refused);
  EXPECT_EQ(
      refused.error(),
      "14/3's clock is 0.350 s ahead (± 1.5 ms), more than the 0.1 s of --max-clock-offset: set the clock right, or "
      "allow more");
}

TEST_F(Planted, ARelaysRecordingIsInTheRelaysTimeAndComparedWithTheRobots) {
  const RecordedClock robot = read_clock(session("14/2", {}));
  const RecordedClock lab = read_clock(session("14/9", {{"14/2", -2'000'000'000, 400'000}}, "lab/1"));
  EXPECT_EQ(lab.who, "lab/1");
  const auto agreements = agree({lab, robot}, 60 * kSecond);
  ASSERT_TRUE(agreements);
  EXPECT_EQ(agreements->at(1).shift_ns, 2'000'000'000);
  EXPECT_EQ(agree({robot, lab}, 60 * kSecond)->at(1).shift_ns, -2'000'000'000);
}

TEST_F(Planted, ClocksThatAgreeAreNotShifted) {
  const RecordedClock two = read_clock(session("14/2", {{"10.0.14.7:1", 1'000'000, 1'000'000}}));
  const RecordedClock three = read_clock(session("14/3", {{"10.0.14.7:1", 4'000'000, 1'000'000}}));
  const auto agreements = agree({two, three}, kSecond);
  ASSERT_TRUE(agreements);
  EXPECT_EQ(agreements->at(1).shift_ns, 0);
  EXPECT_EQ(agreements->at(1).sentence,
            "the clocks of 14/3 and 14/2 agree: 14/3's is 0.003 s behind (± 1.0 ms), by 10.0.14.7");
}

TEST(AgreementBy, AClockThatDriftsIsShiftedAlsoIfItsOffsetIsSmall) {
  const ClockOffset small{.offset_ns = 2'000'000, .error_ns = 3'000'000};
  const auto drifting = agreement_by({.reference = "the ground truth", .other = "14/2"}, small, "the ball", kSecond,
                                     {.growth = 30e-6, .around_ns = kStart});
  ASSERT_TRUE(drifting);
  EXPECT_EQ(drifting->shift()(kStart), kStart - 2'000'000);
  EXPECT_EQ(drifting->shift()(kStart + 1000 * kSecond), kStart + 1000 * kSecond - 32'000'000);
  EXPECT_EQ(
      drifting->sentence,
      "14/2's clock is 0.002 s ahead (± 3.0 ms) of the ground truth's and gains 30.0 ppm, by the ball: its times are "
      "shifted");
  EXPECT_FALSE(agreement_by({.reference = "a", .other = "b"}, {.offset_ns = 2'000'000'000, .error_ns = 0}, "", kSecond,
                            {.growth = 30e-6, .around_ns = kStart}));
}

TEST_F(Planted, ClocksThatCannotBeComparedAreNotShiftedAndTheSentenceSaysSo) {
  const RecordedClock two = read_clock(session("14/2", {{"10.0.14.7:1", 0, 10}, {"127.0.0.1:1", 0, 10}}));
  const RecordedClock three =
      read_clock(session("14/3", {{"10.0.14.8:1", 5, 10}, {"127.0.0.1:1", 5 * 1'000'000'000ll, 10}}));
  EXPECT_FALSE(two.peers.contains("127.0.0.1")) << "a loopback address is another machine for each robot";
  EXPECT_FALSE(compare(two, three));
  EXPECT_NE(agree({two, three}, kSecond)->at(1).sentence.find("cannot be compared: no clock samples of one machine"),
            std::string::npos);
  // the peer's clock was stepped by 3 s: samples that contradict the best one increase its error
  const RecordedClock stepped =
      read_clock(session("14/4", {{"10.0.14.7:1", 0, 10}, {"10.0.14.7:2", 3'000'000'000, 10}}));
  EXPECT_GE(stepped.peers.at("10.0.14.7").error_ns, 2'999'999'000u);
  const auto unsure = agree({two, stepped}, kSecond);
  ASSERT_TRUE(unsure);
  EXPECT_EQ(unsure->at(1).shift_ns, 0);
  EXPECT_NE(unsure->at(1).sentence.find("cannot be compared: by their samples the offset is 0.000 s ahead (± "),
            std::string::npos);
}

TEST_F(Planted, InfoReportsThePeers) {
  const auto planted = session("14/2", {{"10.0.14.7:50001", 350'000'000, 2'000'000}});
  const auto report = inspect(planted.folder);
  ASSERT_TRUE(report);
  EXPECT_NE(to_text(*report).find("clock    10.0.14.7 is 0.350 s ahead (± 1.0 ms) of that of 14/2\n"),
            std::string::npos);
  EXPECT_EQ(to_json(*report)["clock"]["peers"]["10.0.14.7"]["offset_ns"], "350000000");
}

}  // namespace
}  // namespace robot::lab
