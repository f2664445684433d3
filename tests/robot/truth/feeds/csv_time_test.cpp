// ISO times are read in all their usual spellings.
#include "robot/truth/feeds/csv_time.h"

#include <gtest/gtest.h>

#include <string>

#include "robot/core/clock.h"

namespace robot::truth {
namespace {

TEST(IsoTime, KnownMomentsAreReadToTheNanosecond) {
  EXPECT_EQ(parse_iso_time("1970-01-01T00:00:00Z"), 0u);
  EXPECT_EQ(parse_iso_time("2009-07-01T00:00:00Z"), 1'246'406'400u * kSecond);
  EXPECT_EQ(parse_iso_time("2026-03-14T15:09:26.535897932Z"), 1'773'500'966'535'897'932u);
  EXPECT_EQ(parse_iso_time("2024-02-29T23:59:59.5Z"), 1'709'251'199'500'000'000u);
}

TEST(IsoTime, ZonesAndBlanksAreAllowed) {
  const auto noon = parse_iso_time("2026-03-14T12:00:00Z");
  EXPECT_EQ(parse_iso_time("2026-03-14 12:00:00"), noon);
  EXPECT_EQ(parse_iso_time("2026-03-14T14:00:00+02:00"), noon);
  EXPECT_EQ(parse_iso_time("2026-03-14T08:30:00-0330"), noon);
}

TEST(IsoTime, OtherTextsAreRefused) {
  for (const char* text :
       {"", "12", "2026-03-14", "2026-03-14T12:00", "2026-13-14T12:00:00Z", "2026-02-30T12:00:00Z",
        "2026-03-14T24:00:00Z", "2026-03-14T12:00:00.Z", "2026-03-14T12:00:00Zulu", "1969-12-31T23:59:59Z",
        "1970-01-01T00:00:00+01:00", "2263-01-01T00:00:00Z", "x026-03-14T12:00:00Z", "2026-03-14T12:00:00+2"})
    EXPECT_EQ(parse_iso_time(text), std::nullopt) << text;
  const std::string whole = "2026-03-14T12:00:00.25+02:00";
  for (std::size_t size = 0; size < 19; ++size) EXPECT_FALSE(parse_iso_time(whole.substr(0, size))) << size;
}

}  // namespace
}  // namespace robot::truth
