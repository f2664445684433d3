#include "robot/net/websocket/frames.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/masked_frame.h"

namespace robot::net {
namespace {

constexpr std::size_t kCap = 1000;

/// Returns a parser's events as text: "text:abc ping: !1002" — one word per event, "!" and the code of a violation.
std::string events(Sender sender, std::string_view bytes, std::size_t portion = SIZE_MAX) {
  FrameParser parser(sender, kCap);
  std::string log;
  const auto sink = [&](Opcode opcode, const std::string& payload) {
    const char* names[] = {"?", "text", "binary", "?", "?", "?", "?", "?", "close", "ping", "pong"};
    log += (log.empty() ? "" : " ") + std::string(names[static_cast<int>(opcode)]) + ":" +
           (payload.size() > 20 ? std::to_string(payload.size()) : payload);
    return opcode != Opcode::close;
  };
  while (!bytes.empty()) {
    const std::string_view now = bytes.substr(0, portion);
    if (const auto violation = parser.feed(now, sink))
      log += (log.empty() ? "!" : " !") + std::to_string(violation->close_code);
    bytes.remove_prefix(now.size());
  }
  return log;
}

std::string masked(Opcode opcode, std::string_view payload, bool final = true) {
  std::string frame;
  tests::append_masked_frame(frame, opcode, payload, 0xfe21fa37, final);
  return frame;
}

std::string plain(Opcode opcode, std::string_view payload) {
  std::string frame;
  append_frame(frame, opcode, payload);
  return frame;
}

std::string raw(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

TEST(Frames, MatchTheExamplesOfRfc6455) {
  EXPECT_EQ(plain(Opcode::text, "Hello"), "\x81\x05Hello");
  EXPECT_EQ(events(Sender::client, raw({0x81, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58})),
            "text:Hello");
  EXPECT_EQ(events(Sender::server, raw({0x01, 0x03, 'H', 'e', 'l', 0x80, 0x02, 'l', 'o'})), "text:Hello");
  EXPECT_EQ(plain(Opcode::binary, std::string(256, 'x')).substr(0, 4), raw({0x82, 0x7e, 0x01, 0x00}));
  EXPECT_EQ(plain(Opcode::binary, std::string(65536, 'x')).substr(0, 10), raw({0x82, 0x7f, 0, 0, 0, 0, 0, 1, 0, 0}));
}

TEST(Frames, AreTheSameInPiecesOfAnySize) {
  std::string bytes = masked(Opcode::text, "first");
  bytes += masked(Opcode::binary, std::string(300, 'b'));
  bytes += masked(Opcode::text, "fra", false) + masked(Opcode::ping, "now") + masked(Opcode::continuation, "g", false);
  bytes += masked(Opcode::continuation, "ments") + masked(Opcode::pong, "") + masked(Opcode::text, "");
  const std::string expected = "text:first binary:300 ping:now text:fragments pong: text:";
  for (std::size_t portion = 1; portion <= bytes.size(); ++portion)
    EXPECT_EQ(events(Sender::client, bytes, portion), expected);
}

TEST(Frames, ComeBackFromBothDirectionsAtEverySize) {
  for (const std::size_t size : {0u, 1u, 125u, 126u, 127u, 999u, 1000u}) {
    const std::string expected = "binary:" + (size > 20 ? std::to_string(size) : std::string(size, 'x'));
    EXPECT_EQ(events(Sender::client, masked(Opcode::binary, std::string(size, 'x'))), expected);
    EXPECT_EQ(events(Sender::server, plain(Opcode::binary, std::string(size, 'x'))), expected);
  }
}

TEST(Frames, ViolationsAreNamed) {
  const struct {
    std::string bytes, expected;
  } cases[] = {
      {raw({0xc1, 0x80, 0, 0, 0, 0}), "!1002"},                                 // a reserved bit
      {raw({0x83, 0x80, 0, 0, 0, 0}), "!1002"},                                 // an opcode that is not defined
      {raw({0x8b, 0x80, 0, 0, 0, 0}), "!1002"},                                 // a control opcode that is not defined
      {"\x81\x05Hello", "!1002"},                                               // a client that does not mask
      {raw({0x09, 0x80, 0, 0, 0, 0}), "!1002"},                                 // a fragmented ping
      {raw({0x89, 0xfe, 0, 126, 0, 0, 0, 0}), "!1002"},                         // a ping of 126 bytes
      {masked(Opcode::continuation, "x"), "!1002"},                             // nothing to continue
      {masked(Opcode::text, "a", false) + masked(Opcode::text, "b"), "!1002"},  // a message within a message
      {raw({0x82, 0xfe, 0, 125, 0, 0, 0, 0}), "!1002"},                         // a length longer than needed
      {raw({0x82, 0xff, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0, 0, 0, 0}), "!1002"},   // likewise, of 8 bytes
      {raw({0x82, 0xff, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), "!1002"},      // the highest bit of a length
      {raw({0x82, 0xff, 0, 0, 0, 0x7f, 0, 0, 0, 0, 0, 0, 0, 0}), "!1009"},      // 500 GB
      {masked(Opcode::binary, std::string(1001, 'x')), "!1009"},                // a message beyond the cap
      {masked(Opcode::binary, std::string(600, 'x'), false) + masked(Opcode::continuation, std::string(401, 'x')),
       "!1009"},
      {masked(Opcode::text, "\xff"), "!1007"},
      {masked(Opcode::text, "\xc3", false) + masked(Opcode::continuation, "\xb6"),
       "text:\xc3\xb6"},  // one character, two frames
      {masked(Opcode::close, "x"), "!1002"},
      {masked(Opcode::close, close_payload(1005, "")), "!1002"},
      {masked(Opcode::close, close_payload(999, "")), "!1002"},
      {masked(Opcode::close, close_payload(5000, "")), "!1002"},
      {masked(Opcode::close, raw({0x03, 0xe8, 0xff})), "!1007"},
  };
  for (const auto& [bytes, expected] : cases) {
    EXPECT_EQ(events(Sender::client, bytes), expected) << "case " << &bytes - &cases[0].bytes;
    EXPECT_EQ(events(Sender::client, bytes, 1), expected);
  }
}

TEST(Frames, NothingIsReadAfterAViolationOrAClose) {
  const std::string after = masked(Opcode::text, "late");
  EXPECT_EQ(events(Sender::client, masked(Opcode::text, "\xff") + after), "!1007");
  EXPECT_EQ(events(Sender::client, masked(Opcode::close, "") + after), "close:");
  EXPECT_EQ(events(Sender::client, masked(Opcode::close, "") + after, 1), "close:");
}

TEST(Frames, ACloseHoldsItsReason) {
  const CloseInfo info = parse_close(close_payload(kGoingAway, "the server stops"));
  EXPECT_EQ(info.code, 1001);
  EXPECT_EQ(info.reason, "the server stops");
  EXPECT_EQ(parse_close("").code, kNoCodeGiven);
  // a reason that is too long is cut between two characters
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "\xc3\xb6";
  EXPECT_EQ(close_payload(1000, umlauts).size(), 2u + 122u);
}

}  // namespace
}  // namespace robot::net
