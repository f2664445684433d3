#include "robot/fit/radio/radio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/fit/radio/packet_ages.h"
#include "robot/fit/radio/packet_contents.h"
#include "robot/fit/radio/packets.h"
#include "robot/fit/radio/radio_model.h"
#include "tests/support/planted_packets.h"

namespace robot::fit {
namespace {

using tests::planted_packets, tests::PlantedPackets;

constexpr sim::perception::Radio kBefore{.delay = 0.1f, .loss = 0.1f};

bool covers(const Figure& figure, double planted) { return figure.low <= planted && planted <= figure.high; }

/// Counts of intervals that cover the planted values, of `repetitions`.
struct Covered {
  int delay = 0, loss = 0;
  double delay_bias = 0, loss_bias = 0, delay_width = 0, loss_width = 0;
};

Covered cover(const PlantedPackets& planted, int repetitions) {
  Covered covered;
  for (int i = 0; i < repetitions; ++i) {
    const Report report = fit_packets(planted_packets(planted, static_cast<std::uint64_t>(i) + 100), kBefore);
    const Figure *delay = report.figure("radio.delay"), *loss = report.figure("radio.loss");
    if (!delay || !loss) return covered;
    covered.delay += covers(*delay, planted.delay);
    covered.loss += covers(*loss, planted.loss);
    covered.delay_bias += (delay->value - planted.delay) / repetitions;
    covered.loss_bias += (loss->value - planted.loss) / repetitions;
    covered.delay_width += (delay->high - delay->low) / repetitions;
    covered.loss_width += (loss->high - loss->low) / repetitions;
  }
  return covered;
}

void expect_covered(PlantedPackets planted) {
  planted.minutes = 3;
  const Covered covered = cover(planted, 10);
  EXPECT_GE(covered.delay, 8);
  EXPECT_GE(covered.loss, 8);
  EXPECT_LT(std::abs(covered.delay_bias), covered.delay_width / 3);
  EXPECT_LT(std::abs(covered.loss_bias), covered.loss_width / 3);
  EXPECT_LT(covered.loss_width, 0.12);
}

TEST(Radio, IntervalsCoverThePlantedDelayAndLoss) { expect_covered({}); }

TEST(Radio, IntervalsCoverThemWhereDelaysAreWholeTicks) { expect_covered({.ticks = true}); }

TEST(Radio, IntervalsCoverThemForOtherValues) {
  expect_covered({.delay = 0.03, .loss = 0.02, .ticks = true});
  expect_covered({.delay = 0.3, .loss = 0.6, .interval = 1.5});
}

TEST(Radio, TheErrorsOfTheClocksAddToTheIntervalOfTheDelay) {
  const PlantedPackets planted{.minutes = 5, .robots = 2, .clock_error = 0.02};
  expect_covered(planted);
  const auto width = [](const PlantedPackets& of) { return cover(of, 1).delay_width; };
  // with as many packets from one to the other as back, errors of the clocks cancel
  EXPECT_LT(width(planted), 1.3 * width({.minutes = 5, .robots = 2}));
  auto one_way = planted_packets(planted, 1);
  one_way[0].heard.clear();
  const Figure delay = *fit_packets(one_way, kBefore).figure("radio.delay");
  EXPECT_GT(delay.high - delay.low, 2 * 1.96 * 0.02) << "the error of one way does not cancel";
}

TEST(Radio, PacketsWithoutATimeOfSendingAreMatchedByTheirArrival) { expect_covered({.dated = false}); }

TEST(Radio, TheOrderOfRecordingsDoesNotMatter) {
  auto records = planted_packets({}, 1);
  const Report one = fit_packets(records, kBefore);
  std::ranges::reverse(records);
  const Report other = fit_packets(records, kBefore);
  ASSERT_EQ(one.figures.size(), other.figures.size());
  for (std::size_t i = 0; i < one.figures.size(); ++i) {
    EXPECT_NEAR(one.figures[i].value, other.figures[i].value, 1e-9);
    EXPECT_NEAR(one.figures[i].low, other.figures[i].low, 0.02 * one.figures[i].value);
  }
}

TEST(Radio, SingleWrongDelaysHardlyCount) {
  auto records = planted_packets({}, 1);
  const double good = fit_packets(records, kBefore).figure("radio.delay")->value;
  for (std::size_t i = 0; i < records[0].heard.size(); i += 100) records[0].heard[i].arrived += 1.8;
  EXPECT_NEAR(fit_packets(records, kBefore).figure("radio.delay")->value, good, 0.004);
}

TEST(Radio, TimesThatAreNotNumbersAreDropped) {
  auto records = planted_packets({}, 1);
  for (HeardPacket& packet : records[0].heard) packet.sent = packet.arrived = NAN;
  const Report report = fit_packets(records, kBefore);
  ASSERT_TRUE(report.figure("radio.delay"));
  for (const Figure& one : report.figures) EXPECT_TRUE(std::isfinite(one.low) && std::isfinite(one.high)) << one.name;
}

TEST(Radio, ReportsTheTimeBetweenPackets) {
  const Report report = fit_packets(planted_packets({.jitter = 0}, 1), kBefore);
  EXPECT_NEAR(report.figure("radio.interval")->value, 1, 1e-6);
  EXPECT_EQ(report.figure("radio.interval")->kind, "packets");
}

TEST(Radio, PacketsThatTheNextOneFollowsSoonDoNotCountForTheLoss) {
  // every packet is followed within less than three mean delays
  const Report report = fit_packets(planted_packets({.delay = 0.5}, 1), kBefore);
  EXPECT_TRUE(report.figure("radio.delay"));
  EXPECT_FALSE(report.figure("radio.loss"));
  EXPECT_NE(std::ranges::find(
                report.kept,
                "radio.loss: expected at least 50 packets in the recordings of their sender and of a mate, got 0"),
            report.kept.end());
}

TEST(Radio, AReceiverThatWritesLateCountsForNoLoss) {
  auto records = planted_packets({}, 1);
  for (TeamRecord& record : records) record.late = 0.4;
  EXPECT_FALSE(fit_packets(records, kBefore).figure("radio.loss"));
}

TEST(Radio, APauseOfTheReceiverIsNoLoss) {
  auto records = planted_packets({}, 1);
  for (TeamRecord& record : records) {
    std::erase_if(record.heard, [](const HeardPacket& packet) { return packet.arrived > 100 && packet.arrived < 300; });
    std::erase_if(record.written, [](double at) { return at > 100 && at < 300; });
  }
  EXPECT_TRUE(covers(*fit_packets(records, kBefore).figure("radio.loss"), 0.25));
}

TEST(Radio, PacketsOfOtherGamesAreNoLoss) {
  auto records = planted_packets({}, 1), others = planted_packets({}, 2);
  records.insert(records.end(), others.begin(), others.end());
  const Report both = fit_packets(records, kBefore);
  EXPECT_TRUE(covers(*both.figure("radio.loss"), 0.25));
  EXPECT_EQ(both.results.front().title, "errors on packets held out: each of 2 games");
}

TEST(Radio, WithoutSendersRegularGapsGiveTheLoss) {
  auto records = planted_packets({.interval = 0.5, .jitter = 0.02, .minutes = 20}, 1);
  for (TeamRecord& record : records) record.sent.clear(), record.game = nullptr;
  const Report report = fit_packets(records, kBefore);
  ASSERT_TRUE(report.figure("radio.loss_in_gaps"));
  EXPECT_NEAR(report.figure("radio.loss_in_gaps")->value, 0.25, 0.02);
  EXPECT_EQ(report.figure("radio.loss_in_gaps")->kind, "regular packets");
}

TEST(Radio, WithoutSendersIrregularGapsAreRefused) {
  auto records = planted_packets({.jitter = 1.5}, 1);
  for (TeamRecord& record : records) record.sent.clear(), record.game = nullptr;
  const Report report = fit_packets(records, kBefore);
  EXPECT_FALSE(report.figure("radio.loss"));
  EXPECT_TRUE(std::ranges::any_of(report.kept, [](const std::string& sentence) {
    return sentence.starts_with(
        "radio.loss: expected the recordings of the senders, or packets at regular times, got gaps of ");
  }));
}

TEST(Radio, NoRecordingIsASentence) {
  const Report report = fit_packets({}, kBefore);
  EXPECT_TRUE(report.empty());
  ASSERT_EQ(report.kept.size(), 3u);
  EXPECT_EQ(report.kept[0],
            "radio.delay: expected the times of sending and arrival, got no recording with packets of the team");
  EXPECT_EQ(report.kept[1],
            "radio.loss: expected at least 50 packets in the recordings of their sender and of a mate, got 0");
  EXPECT_EQ(report.kept[2], "radio.interval: expected at least 50 packets of robots that count their own, got 0");
  EXPECT_EQ(report.needs.size(), 2u);
}

TEST(Radio, FittedDistributionsPredictPacketsHeldOutBetterThanTheModelsBefore) {
  const Report report = fit_packets(planted_packets({}, 1), kBefore);
  ASSERT_FALSE(report.results.empty());
  const auto& rows = report.results.front().rows;
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows) EXPECT_LT(std::stod(row[2]), std::stod(row[3])) << row[0];
  EXPECT_LT(std::stod(rows[0][2]), std::stod(rows[0][4])) << "and better than a constant delay";
}

TEST(Radio, DrawsDelaysAndAges) {
  const Report report = fit_packets(planted_packets({}, 1), kBefore);
  ASSERT_EQ(report.pictures.size(), 2u);
  for (const Picture& picture : report.pictures) EXPECT_EQ(picture.marks.size(), 3u) << picture.title;
  EXPECT_EQ(report.tables.size(), 2u);
  EXPECT_NE(to_text(report).find("radio.delay"), std::string::npos);
}

TEST(RadioModel, TheMeanOfRoundedDelaysIsThatOfTheDistribution) {
  EXPECT_NEAR(mean_delay(0.1, 0), 0.1 * (1 - std::exp(-5.)), 1e-9);
  EXPECT_NEAR(mean_delay(0.1, 1e-4), mean_delay(0.1, 0), 1e-4);
  EXPECT_EQ(mean_delay(0, 0), 0);
}

TEST(RadioModel, TheIntervalOfNoLossEndsAboveZero) {
  const Bounded none = fit_share(std::vector<Shared>(100, Shared{.sum = 0, .count = 4}));
  EXPECT_EQ(none.value, 0);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.037, 0.003) << "of 100 packets, because receivers of one share their luck";
}

TEST(RadioModel, ReceiversThatLosePacketsTogetherCountAsOne) {
  std::vector<Shared> apart, together;
  for (int i = 0; i < 400; ++i) {
    apart.push_back({.sum = 1, .count = 4});
    together.push_back({.sum = i % 4 == 0 ? 4. : 0., .count = 4});
  }
  const Bounded one = fit_share(apart), other = fit_share(together);
  EXPECT_DOUBLE_EQ(one.value, other.value);
  EXPECT_LT(1.8 * (one.high - one.low), other.high - other.low);
}

TEST(RadioModel, TheScoreOfADelayIsLeastForTheTrueMean) {
  const auto score = [](double mean) {
    double sum = 0;
    for (int i = 0; i < 1000; ++i) sum += delay_score(mean, -0.2 * std::log(1 - (i + 0.5) / 1000));
    return sum;
  };
  EXPECT_LT(score(0.2), score(0.17));
  EXPECT_LT(score(0.2), score(0.23));
}

TEST(PacketAges, TheExpectedCurveIsTheObservedOneForTheSameRadio) {
  const auto records = planted_packets({.minutes = 30}, 1);
  const AgeCurve seen = observed_ages(records), expected = expected_ages(records, 0.15, 0.25);
  ASSERT_EQ(seen.ages, expected.ages);
  for (std::size_t i = 0; i < seen.ages.size(); ++i) EXPECT_NEAR(seen.shares[i], expected.shares[i], 0.02) << i;
}

TEST(PacketContents, SummarisesWhatTheSendersSay) {
  const auto summaries = summaries_of(planted_packets({.loss = 0, .jitter = 0}, 1));
  ASSERT_EQ(summaries.size(), 5u);
  EXPECT_EQ(summaries[0].sender, "14/1");
  EXPECT_NEAR(summaries[0].gap, 1, 1e-6);
  EXPECT_NEAR(summaries[0].speed, 0.1, 0.01);
  EXPECT_EQ(summaries[0].ball, 1);
  EXPECT_NEAR(static_cast<double>(summaries[0].jumps), 60, 1) << "the planted pose jumps back every ten seconds";
}

}  // namespace
}  // namespace robot::fit
