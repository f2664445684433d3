// A log of the Small Size League is read message by message; a damaged one up to its damage.
#include "robot/truth/feeds/ssl_log.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/robot/truth/feeds/ssl_logs.h"

namespace robot::truth {
namespace {

using tests::ssl_log_message;

const std::string kLog = tests::kSslLogHead + ssl_log_message(1'700'000'000'000'000'001, 4, "vision") +
                         ssl_log_message(5, 3, "referee") + ssl_log_message(6, 0, "") +
                         ssl_log_message(7, 2, "old vision") + ssl_log_message(8, 1, "unknown") +
                         ssl_log_message(9, 5, "tracker") + ssl_log_message(10, 6, "index");

struct LogRead {
  std::vector<SslLogMessage> messages;
  std::string error;
};

LogRead read_log(const std::string& file) {
  LogRead all;
  auto reader = SslLogReader::open(file);
  if (!reader) return {{}, reader.error()};
  while (true) {
    const auto message = reader->next();
    if (!message) {
      all.error = message.error();
      EXPECT_FALSE(*reader->next());  // after damage nothing comes
      return all;
    }
    if (!*message) return all;
    all.messages.push_back(**message);
  }
}

TEST(SslLog, EachMessageHasItsTimeItsTypeAndItsBytes) {
  const LogRead log = read_log(kLog);
  EXPECT_EQ(log.error, "");
  ASSERT_EQ(log.messages.size(), 7u);
  EXPECT_EQ(log.messages[0].received_ns, 1'700'000'000'000'000'001u);
  EXPECT_EQ(log.messages[0].bytes, "vision");
  std::string vision;
  for (const SslLogMessage& message : log.messages) vision += message.vision ? 'v' : '-';
  EXPECT_EQ(vision, "v--vv--");
  EXPECT_EQ(log.messages[6].received_ns, 10u);
}

TEST(SslLog, IsRecognisedByItsFirstBytes) {
  EXPECT_TRUE(is_ssl_log(kLog));
  EXPECT_FALSE(is_ssl_log("SSL_LOG"));
}

TEST(SslLog, AnotherFileIsRefused) {
  EXPECT_EQ(read_log("").error, "expected a log of the SSL that begins with SSL_LOG_FILE, got another file");
  EXPECT_EQ(read_log("\x1f\x8b\x08").error, "expected a log of the SSL, got a packed file: unpack it with gunzip");
  EXPECT_EQ(read_log("SSL_LOG_FILE\1").error, "expected a version after SSL_LOG_FILE, got the end of the file");
  EXPECT_EQ(read_log(std::string("SSL_LOG_FILE\0\0\0\2", 16)).error,
            "expected version 1 of a log of the SSL, got version 2");
}

TEST(SslLog, DamageIsNamedWithItsPlace) {
  EXPECT_EQ(read_log(tests::kSslLogHead + "short").error, "byte 16: expected a message, got the last 5 bytes");
  EXPECT_EQ(read_log(tests::kSslLogHead + ssl_log_message(1, 4, "vision").substr(0, 20)).error,
            "byte 16: expected a message of 6 bytes, got 4");
  EXPECT_EQ(read_log(tests::kSslLogHead + std::string(16, '\xff')).error,
            "byte 16: expected a time since 1970, got an earlier one");
}

TEST(SslLog, EveryTruncationKeepsTheMessagesBeforeIt) {
  for (std::size_t size = tests::kSslLogHead.size(); size < kLog.size(); ++size) {
    const std::string begin = kLog.substr(0, size);  // the messages point into it
    const LogRead log = read_log(begin);
    EXPECT_LT(log.messages.size(), 7u);
    EXPECT_TRUE(log.messages.empty() || log.messages[0].bytes == "vision");
  }
}

TEST(SslLog, EveryFlippedByteIsReadOrRefusedWithASentence) {
  for (std::size_t i = 0; i < kLog.size(); ++i)
    for (const int change : {0x01, 0x80, 0xff}) {
      std::string bytes = kLog;
      bytes[i] = static_cast<char>(bytes[i] ^ change);
      const LogRead log = read_log(bytes);
      EXPECT_TRUE(!log.messages.empty() || !log.error.empty());
    }
}

}  // namespace
}  // namespace robot::truth
