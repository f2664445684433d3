#include "robot/lab/import/label_rows.h"

#include <gtest/gtest.h>

namespace robot::lab::labels {
namespace {

const std::string kHeader = "filename,label,x_min,y_min,x_max,y_max,color,number\n";

TEST(LabelRows, BecomeFramesByTime) {
  const auto rows = read_rows(kHeader +
                              "000066.jpg,0,10,20,30,60,2,1\r\n"
                              "half1_000033.jpg,1,1,2,3,4.5,-1,-1\n"
                              "000066.jpg,0,11,21,31,61,5,77\n");
  ASSERT_TRUE(rows) << rows.error();
  EXPECT_EQ(rows->damage, "");
  ASSERT_EQ(rows->frames.size(), 2u);
  EXPECT_EQ(rows->frames[0].time_ms, 33);
  ASSERT_EQ(rows->frames[0].balls.size(), 1u);
  EXPECT_EQ(rows->frames[0].balls[0].bottom, 4.5);
  ASSERT_EQ(rows->frames[1].robots.size(), 2u);
  EXPECT_EQ(rows->frames[1].robots[0].colour, 2);
  EXPECT_EQ(rows->frames[1].robots[0].number, 1);
  EXPECT_EQ(rows->frames[1].robots[1].number, -1);
}

TEST(LabelRows, OtherHeadersAreRefused) {
  EXPECT_TRUE(is_label_file(kHeader));
  EXPECT_FALSE(is_label_file("time,label"));
  EXPECT_EQ(read_rows("time,label\n").error(),
            "expected the header 'filename,label,x_min,y_min,x_max,y_max,color,number', got 'time,label'");
}

TEST(LabelRows, AWrongRowIsTheDamageAndEverythingBeforeIsKept) {
  const std::string good = "000033.jpg,0,10,20,30,60,2,1\n";
  for (const std::string wrong :
       {"000066.jpg,0,10,20,30", "x.jpg,0,1,2,3,4,5,6", "000066.jpg,0,10,20,5,60,2,1", "000066.jpg,0,1e9,20,30,60,2,1",
        "000066.jpg,0,nan,20,30,60,2,1", "000066.jpg,0,1,2,3,4,5,6,7"}) {
    const auto rows = read_rows(kHeader + good + wrong + "\n" + good);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->damage, "line 3: expected a time, a label and a box in pixels, got '" + wrong + "'");
    ASSERT_EQ(rows->frames.size(), 1u);
    EXPECT_EQ(rows->frames[0].robots.size(), 1u);
  }
}

}  // namespace
}  // namespace robot::lab::labels
