#include "robot/core/little_endian.h"

#include <gtest/gtest.h>

#include <limits>

namespace robot {
namespace {

template <class Number>
class LittleEndian : public testing::Test {};
using Numbers = testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t, std::int32_t,
                               std::uint64_t, std::int64_t, float>;
TYPED_TEST_SUITE(LittleEndian, Numbers);

TYPED_TEST(LittleEndian, ReadsBackEveryNumberThatWasPut) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam value :
       {TypeParam{0}, TypeParam{1}, Limits::lowest(), Limits::max(), static_cast<TypeParam>(2)}) {
    std::string bytes;
    put(bytes, value);
    EXPECT_EQ(bytes.size(), sizeof value);
    ByteReader reader(bytes);
    EXPECT_EQ(reader.number<TypeParam>(), value);
    EXPECT_TRUE(reader.finished());
  }
}

TEST(LittleEndianBytes, TheLowestByteComesFirst) {
  std::string bytes;
  put(bytes, std::uint32_t{0x04030201});
  put(bytes, 0x070605, 3);
  put(bytes, 1.f);  // 0x3f800000
  put_text(bytes, "ab");
  EXPECT_EQ(bytes, std::string("\1\2\3\4\5\6\7\0\0\x80\x3f\2\0\0\0ab", 17));
  EXPECT_EQ(ByteReader(bytes).number(7), 0x07060504030201u);
  ByteReader wide(bytes);
  EXPECT_EQ(wide.number(bytes.size()), 0x0007060504030201u);  // more bytes than a number holds
  EXPECT_TRUE(wide.finished());
}

TEST(ByteReader, ReadsNothingAfterTheFirstReadBeyondTheEnd) {
  ByteReader reader(std::string_view("\1\2\3", 3));
  EXPECT_EQ(reader.number<std::uint8_t>(), 1);
  EXPECT_FALSE(reader.finished());
  EXPECT_EQ(reader.rest(), "\2\3");
  EXPECT_EQ(reader.number<std::uint32_t>(), 0u);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.number<std::uint8_t>(), 0);
  EXPECT_EQ(reader.take(0), "");
  EXPECT_EQ(reader.rest(), "");
  EXPECT_FALSE(reader.finished());
}

TEST(ByteReader, ATextMayNotBeLongerThanTheRestOfTheBytes) {
  std::string bytes;
  put_text(bytes, "Nao");
  EXPECT_EQ(ByteReader(bytes).text(), "Nao");
  ByteReader cut(std::string_view(bytes).substr(0, bytes.size() - 1));
  EXPECT_EQ(cut.text(), "");
  EXPECT_FALSE(cut.ok());
}

}  // namespace
}  // namespace robot
