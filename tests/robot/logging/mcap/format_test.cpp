#include "robot/logging/mcap/format.h"

#include <gtest/gtest.h>

namespace robot::logging::mcap {
namespace {

using namespace std::string_literals;

template <class Record>
std::string encoded(const Record& record) {
  std::string out;
  append(out, record);
  return out;
}

/// One record of each kind, every field different from its default.
template <class See>
void each_record(See&& see) {
  see(Header{"profile", "library"});
  see(Footer{1, 2, 3});
  see(Schema{1, "name", "encoding", "data\0data"s});
  see(Channel{1, 2, "topic", "protobuf", {{"a", "b"}, {"c", ""}}});
  see(Message{1, 2, 3, 4, "data"});
  see(ChunkHead{1, 2, 3, 4, "zstd", 5});
  see(MessageIndex{1, {{2, 3}, {4, 5}}});
  see(ChunkIndex{1, 2, 3, 4, {{5, 6}}, 7, "lz4", 8, 9});
  see(Attachment{1, 2, "name", "text/plain", "data", 3});
  see(AttachmentIndex{1, 2, 3, 4, 5, "name", "text/plain"});
  see(Statistics{1, 2, 3, 4, 5, 6, 7, 8, {{9, 10}}});
  see(Metadata{"name", {{"a", "b"}}});
  see(MetadataIndex{1, 2, "name"});
  see(SummaryOffset{Op::chunk_index, 1, 2});
  see(DataEnd{0x12345678});
}

// written by hand from the specification
TEST(McapFormat, ASchemaHasTheBytesOfTheSpecification) {
  EXPECT_EQ(encoded(Schema{0x0102, "N", "E", "D"}),
            "\x03"s                // op
            "\x11\0\0\0\0\0\0\0"s  // length
            "\x02\x01"s            // id
            "\x01\0\0\0N"
            "\x01\0\0\0"
            "E"
            "\x01\0\0\0"
            "D"s);
}

TEST(McapFormat, AChannelHasTheBytesOfTheSpecification) {
  EXPECT_EQ(encoded(Channel{1, 2, "T", "M", {{"k", "v"}}}),
            "\x04\x1c\0\0\0\0\0\0\0"s
            "\x01\0\x02\0"s
            "\x01\0\0\0T"s
            "\x01\0\0\0M"s
            "\x0a\0\0\0"s
            "\x01\0\0\0k"s
            "\x01\0\0\0v"s);
}

TEST(McapFormat, AMessageHasTheBytesOfTheSpecification) {
  EXPECT_EQ(encoded(Message{1, 2, 3, 4, "x"}),
            "\x05\x17\0\0\0\0\0\0\0"s
            "\x01\0"s
            "\x02\0\0\0"s
            "\x03\0\0\0\0\0\0\0"s
            "\x04\0\0\0\0\0\0\0x"s);
}

TEST(McapFormat, AMessageIndexHasTheBytesOfTheSpecification) {
  EXPECT_EQ(encoded(MessageIndex{1, {{2, 3}}}),
            "\x07\x16\0\0\0\0\0\0\0"s
            "\x01\0"s
            "\x10\0\0\0"s
            "\x02\0\0\0\0\0\0\0"s
            "\x03\0\0\0\0\0\0\0"s);
}

TEST(McapFormat, EveryRecordRoundTrips) {
  each_record([](const auto& record) {
    using Record = std::decay_t<decltype(record)>;
    const std::string bytes = encoded(record);
    std::size_t at = 0;
    const auto view = take_record(bytes, at);
    ASSERT_TRUE(view) << view.error();
    EXPECT_EQ(at, bytes.size());
    EXPECT_EQ(view->op, Record::kOp);
    const auto back = decode<Record>(view->content, 0);
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(encoded(*back), bytes);
  });
}

TEST(McapFormat, SurvivesEveryTruncation) {
  each_record([](const auto& record) {
    using Record = std::decay_t<decltype(record)>;
    const std::string content = encoded(record).substr(kRecordHeadBytes);
    std::size_t least = content.size();
    if constexpr (Record::kOp == Op::message) least -= record.data.size();  // data may have any size
    for (std::size_t n = 0; n < least; ++n)
      EXPECT_FALSE(decode<Record>(content.substr(0, n), 0)) << name(Record::kOp) << n;
  });
}

TEST(McapFormat, IgnoresFieldsOfLaterVersions) {
  EXPECT_TRUE(decode<DataEnd>("\x01\0\0\0 and more"s, 0));
  EXPECT_EQ(decode<Header>(encoded(Header{"p", "l"}).substr(kRecordHeadBytes) + "more", 0)->library, "l");
}

TEST(McapFormat, NamesTheMissingFieldAndItsPlace) {
  EXPECT_EQ(decode<Schema>("\x01\0\x09\0\0\0foresi"s, 31).error(), "Schema at byte 31: name: expected 9 bytes, got 6");
  EXPECT_EQ(decode<MessageIndex>("\x01\0\x03\0\0\0abc"s, 8).error(),
            "MessageIndex at byte 8: entries: expected entries of 16 bytes, got 3");
  EXPECT_EQ(decode_record_head("\x06\xff\0\0\0\0\0\0\0"s, 100, 20).error(),
            "Chunk at byte 100: expected 255 bytes, 11 are left");
  EXPECT_EQ(decode_record_head("\0\0\0\0\0\0\0\0\0"s, 100, 20).error(),
            "record at byte 100: expected an op from 1 on, got 0");
  EXPECT_EQ(decode_record_head("\x06\xff"s, 100, 2).error(), "record at byte 100: expected 9 bytes, 2 are left");
  EXPECT_EQ(name(static_cast<Op>(0x2a)), "record 0x2a");
}

TEST(McapFormat, TheChecksumIsThatOfZlib) {
  EXPECT_EQ(crc32("123456789"), 0xcbf43926u);
  EXPECT_EQ(crc32("6789", crc32("12345")), 0xcbf43926u);
  EXPECT_EQ(crc32_of_both(crc32("12345"), crc32("6789"), 4), 0xcbf43926u);
}

}  // namespace
}  // namespace robot::logging::mcap
