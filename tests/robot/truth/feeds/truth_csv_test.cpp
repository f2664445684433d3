// Positions in a CSV file become moments, in both forms and all units. A wrong line is named with line and column.
#include "robot/truth/feeds/truth_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

const std::string kWide =
    "t,ball_x,ball_y,x_14_2,y_14_2,heading_14_2,x_5_20,y_5_20\n"
    "0,1,2,3,4,0.5,-1,-2\n"
    "0.033,1.5,2,,,,nan,NaN\n";

const std::string kLong =
    "t,team,player,x,y,heading\n"
    "0,ball,,1,2,\n"
    "0,14,2,3,4,0.5\n"
    "0,5,20,-1,-2,\n"
    "0.033,ball,,1.5,2,\n";

TruthCsv read(const std::string& text) {
  auto csv = read_truth_csv(text);
  EXPECT_TRUE(csv) << csv.error();
  return csv ? *std::move(csv) : TruthCsv();
}

std::string damage_of(const std::string& text) { return read(text).damage; }

TEST(TruthCsv, TheWideFormHasALineForEachMoment) {
  const TruthCsv csv = read(kWide);
  EXPECT_EQ(csv.damage, "");
  EXPECT_FALSE(csv.dated);
  ASSERT_EQ(csv.moments.size(), 2u);
  EXPECT_EQ(csv.moments[0].capture_ns, 0u);
  EXPECT_EQ(csv.moments[1].capture_ns, 33 * kMillisecond);
  const pb::GroundTruth& truth = csv.moments[0].truth;
  EXPECT_EQ(truth.ball().x(), 1);
  EXPECT_EQ(truth.ball().y(), 2);
  ASSERT_EQ(truth.robots_size(), 2);
  EXPECT_EQ(truth.robots(0).team(), 14u);
  EXPECT_EQ(truth.robots(0).player(), 2u);
  EXPECT_EQ(truth.robots(0).x(), 3);
  EXPECT_EQ(truth.robots(0).y(), 4);
  EXPECT_EQ(truth.robots(0).heading(), 0.5F);
  EXPECT_EQ(truth.robots(1).team(), 5u);
  EXPECT_EQ(truth.robots(1).player(), 20u);
  EXPECT_FALSE(truth.robots(1).has_heading());
}

TEST(TruthCsv, AnEmptyCellOrNanIsAThingThatWasNotSeen) {
  const TruthCsv csv = read(kWide);
  EXPECT_EQ(csv.moments[1].truth.robots_size(), 0);
  EXPECT_EQ(csv.moments[1].truth.ball().x(), 1.5F);
  EXPECT_FALSE(read("t,ball_x,ball_y\n1,,\n").moments[0].truth.has_ball());
}

TEST(TruthCsv, BothFormsAreTheSameMoments) {
  const TruthCsv wide = read(kWide), tall = read(kLong);
  EXPECT_EQ(tall.damage, "");
  ASSERT_EQ(tall.moments.size(), wide.moments.size());
  for (std::size_t i = 0; i < wide.moments.size(); ++i) {
    EXPECT_EQ(tall.moments[i].capture_ns, wide.moments[i].capture_ns);
    EXPECT_EQ(tall.moments[i].truth.SerializeAsString(), wide.moments[i].truth.SerializeAsString());
  }
}

TEST(TruthCsv, ALineOfTheLongFormWithoutTeamOrPlayerIsARobotThatIsNotIdentified) {
  const TruthCsv csv = read("x,y,team,player,time\n1,2,,,7\n3,4,14,,7\n");
  ASSERT_EQ(csv.moments.size(), 1u);
  ASSERT_EQ(csv.moments[0].truth.robots_size(), 2);
  EXPECT_FALSE(csv.moments[0].truth.robots(0).has_team());
  EXPECT_EQ(csv.moments[0].truth.robots(1).team(), 14u);
  EXPECT_FALSE(csv.moments[0].truth.robots(1).has_player());
}

TEST(TruthCsv, UnitsAreTheEndsOfNames) {
  const TruthCsv csv = read(
      "t_ms,ball_x_mm,ball_y_cm,x_14_2_m,y_14_2_mm,heading_14_2_deg\n"
      "1500,250,-30,1,2000,90\n");
  ASSERT_EQ(csv.moments.size(), 1u);
  EXPECT_EQ(csv.moments[0].capture_ns, 1500 * kMillisecond);
  EXPECT_FLOAT_EQ(csv.moments[0].truth.ball().x(), 0.25F);
  EXPECT_FLOAT_EQ(csv.moments[0].truth.ball().y(), -0.3F);
  EXPECT_FLOAT_EQ(csv.moments[0].truth.robots(0).x(), 1);
  EXPECT_FLOAT_EQ(csv.moments[0].truth.robots(0).y(), 2);
  EXPECT_FLOAT_EQ(csv.moments[0].truth.robots(0).heading(), static_cast<float>(M_PI / 2));
}

TEST(TruthCsv, HeadingsAreInOneTurn) {
  const TruthCsv csv = read("t,team,player,x,y,heading_deg\n0,1,1,0,0,270\n1,1,1,0,0,-180\n2,1,1,0,0,725\n");
  const auto heading = [&](std::size_t i) { return csv.moments[i].truth.robots(0).heading(); };
  EXPECT_NEAR(heading(0), -M_PI / 2, 1e-6);
  EXPECT_NEAR(heading(1), M_PI, 1e-6);
  EXPECT_NEAR(heading(2), 5 * M_PI / 180, 1e-6);
}

TEST(TruthCsv, TimesAreSecondsNanosecondsOrIso) {
  const TruthCsv nanoseconds = read("t_ns,ball_x,ball_y\n1700000000123456789,0,0\n");
  EXPECT_EQ(nanoseconds.moments[0].capture_ns, 1'700'000'000'123'456'789u);  // all digits
  EXPECT_TRUE(nanoseconds.dated);
  const TruthCsv iso = read("time,ball_x,ball_y\n2026-03-14T12:00:00Z,0,0\n2026-03-14 12:00:00.5,0,0\n");
  EXPECT_EQ(iso.damage, "");
  EXPECT_EQ(iso.moments[1].capture_ns, 1'773'489'600'500'000'000u);
  EXPECT_TRUE(iso.dated);
  const TruthCsv seconds = read("t,ball_x,ball_y\n1700000000.25,0,0\n");
  EXPECT_EQ(seconds.moments[0].capture_ns, 1'700'000'000'250'000'000u);
  EXPECT_EQ(read("t,ball_x,ball_y\n1e-3,0,0\n").moments[0].capture_ns, kMillisecond);
}

TEST(TruthCsv, FilesOfManyProgramsAreRead) {
  for (const char* text :
       {"t;ball_x;ball_y\r\n1;2;3\r\n", "t\tball_x\tball_y\n1\t2\t3\n", "# t,ball_x,ball_y\n1,2,3",
        "\"t\", \"ball_x\", \"ball_y\"\n\"1\", 2 ,3\n", "\xef\xbb\xbft,ball_x,ball_y\n\n1,2,3\n\n"}) {
    const TruthCsv csv = read(text);
    ASSERT_EQ(csv.moments.size(), 1u) << text << csv.damage;
    EXPECT_EQ(csv.moments[0].capture_ns, kSecond);
    EXPECT_EQ(csv.moments[0].truth.ball().x(), 2);
    EXPECT_EQ(csv.moments[0].truth.ball().y(), 3);
  }
}

TEST(TruthCsv, OtherColumnsAreIgnoredAndNamed) {
  const TruthCsv csv = read("frame,t,ball_x,ball_y,ball_z,x_14,score_kg\n9,1,2,3,4,5,6\n");
  EXPECT_EQ(csv.moments.size(), 1u);
  EXPECT_EQ(csv.ignored, (std::vector<std::string>{"frame", "ball_z", "x_14", "score_kg"}));
}

TEST(TruthCsv, AWrongHeaderIsRefused) {
  const auto refusal = [](const char* text) { return read_truth_csv(text).error(); };
  EXPECT_EQ(refusal(""), "line 1: expected a column t, such as 't', 't_ns' or 'time', got none");
  EXPECT_EQ(refusal("ball_x,ball_y"), "line 1: expected a column t, such as 't', 't_ns' or 'time', got none");
  EXPECT_EQ(refusal("t,a,b"), "line 1: expected columns ball_x, x_<team>_<player> or x, got none");
  EXPECT_EQ(refusal("t,ball_x"), "line 1: expected both columns ball_x and ball_y, got at most one of them");
  EXPECT_EQ(refusal("t,x_14_2,y_14_2,heading_14_3"),
            "line 1: expected both columns x_14_3 and y_14_3, got at most one of them");
  EXPECT_EQ(refusal("t,team,player,x"), "line 1: expected both columns x and y, got at most one of them");
  EXPECT_EQ(refusal("t,ball_x,ball_y,ball_x_mm"),
            "line 1: expected each column once, got 'ball_x_mm' and another one like it");
  EXPECT_EQ(refusal("t,x,y"), "line 1: expected columns team and player, and no others of places, beside a column x");
  EXPECT_EQ(refusal("t,team,ball_x,ball_y"), "line 1: expected columns x and y beside team and player");
}

TEST(TruthCsv, AWrongLineIsNamedAndTheLinesBeforeItAreKept) {
  const TruthCsv csv = read("t,ball_x,ball_y\n0,1,1\n1,1,1\n2,1,wide\n3,1,1\n");
  EXPECT_EQ(csv.damage, "line 4, column ball_y: expected a number of -100 .. 100 [m], got 'wide'");
  EXPECT_EQ(csv.moments.size(), 2u);
}

TEST(TruthCsv, EveryKindOfWrongCellHasASentence) {
  EXPECT_EQ(damage_of("t,ball_x_mm,ball_y\n0,100001,1\n"),
            "line 2, column ball_x_mm: expected a number of -100000 .. 100000 [mm], got '100001'");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\n0,inf,1\n"),
            "line 2, column ball_x: expected a number of -100 .. 100 [m], got 'inf'");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\n0,1\n"), "line 2, expected 3 cells, got 2");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\n0,1,\n"),
            "line 2, column ball_y: expected a number, because x or y is there, got ''");
  EXPECT_EQ(damage_of("t_ms,ball_x,ball_y\n-1,1,1\n"),
            "line 2, column t_ms: expected a time [ms] of at least 0 or as in 2026-03-14T15:09:26Z, got '-1'");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\n1e300,1,1\n"),
            "line 2, column t: expected a time [s] of at least 0 or as in 2026-03-14T15:09:26Z, got '1e300'");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\nnan,1,1\n"),
            "line 2, column t: expected a time [s] of at least 0 or as in 2026-03-14T15:09:26Z, got 'nan'");
  EXPECT_EQ(damage_of("t,ball_x,ball_y\n2,1,1\n1,1,1\n"),
            "line 3, column t: expected a time that is not before that of the line above, got '1'");
  EXPECT_EQ(damage_of("t,team,player,x,y\n0,300,1,0,0\n"),
            "line 2, column team: expected a whole number of 0 .. 255, got '300'");
  EXPECT_EQ(damage_of("t,team,player,x,y\n0,14,0,0,0\n"),
            "line 2, column player: expected a whole number of 1 .. 20, got '0'");
  EXPECT_EQ(damage_of("t,team,player,x,y\n0,ball,,0,0\n0,ball,,1,1\n"),
            "line 3, column team: expected one ball at a time, got 'ball'");
}

TEST(TruthCsv, AMomentOfTheLongFormHasAtMost500Robots) {
  std::string text = "t,team,player,x,y\n";
  for (int i = 0; i < 501; ++i) text += "0,,,0,0\n";
  const TruthCsv csv = read(text);
  EXPECT_EQ(csv.damage, "line 502, column t: expected at most 500 robots at a time, got '0'");
  EXPECT_EQ(csv.moments.at(0).truth.robots_size(), 500);
}

TEST(TruthCsv, IsRecognisedByItsHeader) {
  EXPECT_TRUE(is_truth_csv(kWide));
  EXPECT_TRUE(is_truth_csv(kLong));
  EXPECT_FALSE(is_truth_csv("filename,label,x_min,y_min,x_max,y_max,color,number\n"));
  EXPECT_FALSE(is_truth_csv(std::string("\0\0\0\0t,ball_x", 12)));
  EXPECT_FALSE(is_truth_csv(""));
}

TEST(TruthCsv, EveryTruncationAndEveryFlippedByteIsReadOrRefusedWithASentence) {
  for (const std::string& whole : {kWide, kLong}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const auto csv = read_truth_csv(whole.substr(0, size));
      EXPECT_TRUE(csv || !csv.error().empty());
      EXPECT_TRUE(!csv || csv->moments.size() <= 2);
    }
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const int change : {0x01, 0x10, 0x80, 0xff}) {
        std::string bytes = whole;
        bytes[i] = static_cast<char>(bytes[i] ^ change);
        const auto csv = read_truth_csv(bytes);
        EXPECT_TRUE(csv || !csv.error().empty());
      }
  }
}

}  // namespace
}  // namespace robot::truth
