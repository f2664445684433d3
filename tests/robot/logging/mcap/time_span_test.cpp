#include "robot/logging/mcap/time_span.h"

#include <gtest/gtest.h>

#include "robot/core/clock.h"
#include "tests/support/mcap_text.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kToday = 1'764'000'000 * kSecond;

/// Returns the span of a file with messages at these times, in chunks of `chunk` messages.
TimeSpan span_of(const std::vector<std::uint64_t>& times_ns, std::size_t chunk) {
  tests::Disk disk;
  McapWriter writer = tests::writer_to(disk);
  for (std::size_t i = 0; i < times_ns.size(); ++i) {
    EXPECT_TRUE(writer.write(0, tests::word("word", times_ns[i]), 0));
    EXPECT_TRUE((i + 1) % chunk != 0 || writer.flush());
  }
  EXPECT_TRUE(writer.close());
  const MemorySource source(disk.bytes);
  return time_span(source, *read_index(source));
}

TEST(TimeSpan, IsFromTheFirstMessageToTheLast) {
  const TimeSpan span = span_of({kToday + 2, kToday, kToday + kSecond}, 2);
  EXPECT_EQ(span.start_ns, kToday);
  EXPECT_EQ(span.end_ns, kToday + kSecond);
  EXPECT_EQ(span.note(), "");
  EXPECT_EQ(span_of({}, 1).end_ns, 0u);
}

TEST(TimeSpan, LeavesOutMessagesThatWouldStretchItToDecades) {
  for (const std::size_t chunk : {1u, 3u, 100u}) {
    const TimeSpan span =
        span_of({0, 5, kToday, kToday + 1, kToday + 2, kToday + kSecond, std::uint64_t{1} << 63}, chunk);
    EXPECT_EQ(span.start_ns, kToday);
    EXPECT_EQ(span.end_ns, kToday + kSecond);
    EXPECT_EQ(span.note(),
              "2 messages before 2025-11-24 16:00:00 UTC and 1 message after 2025-11-24 16:00:01 UTC left out of the "
              "strip, because more than 30 days lie between");
  }
}

TEST(TimeSpan, OfARecordingIn1970IsIn1970) {
  EXPECT_EQ(span_of({0, 5, 7}, 1).end_ns, 7u);
  EXPECT_EQ(span_of({0, 5, 7, kToday}, 1).end_ns, 7u);
}

}  // namespace
}  // namespace robot::logging
