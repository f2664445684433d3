// The client against servers that answer well, badly or not at all.
#include "robot/net/websocket/web_socket_client.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "robot/core/clock.h"
#include "tests/robot/net/scripted_server.h"
#include "tests/support/masked_frame.h"

namespace robot::net {
namespace {

using tests::begun_frame;
using tests::ScriptedPeer;
using tests::ScriptedServer;
using tests::server_frame;

/// A bound for failures only: no test waits for it when all is well.
constexpr std::uint64_t kConnectPatience = 60 * kSecond;

/// Returns the next message as "opcode:payload", "nothing", or the sentence without the address.
std::string next(WebSocketClient& client, std::uint64_t patience_ns = kConnectPatience) {
  const auto message = client.receive(monotonic_ns() + patience_ns);
  if (!message) return message.error().substr(std::min(message.error().find("/: ") + 3, message.error().size()));
  if (!*message) return "nothing";
  return std::to_string(static_cast<int>((*message)->opcode)) + ":" + (*message)->payload;
}

/// Returns what the client says of a server that sends `bytes` after the handshake and then waits.
std::string said_of(const std::string& bytes) {
  ScriptedServer server([&](ScriptedPeer& peer) {
    peer.send(peer.read_request() + bytes);
    peer.wait_closed();
  });
  WebSocketClient client;
  EXPECT_TRUE(client.connect(server.url(), kConnectPatience));
  return next(client);
}

/// Returns the sentence of connect() for a server that answers the request with `answer(response)`.
template <class Answer>
std::string refused_by(Answer&& answer, std::uint64_t patience_ns = kConnectPatience) {
  ScriptedServer server([&](ScriptedPeer& peer) { peer.send(answer(peer.read_request())); });
  WebSocketClient client;
  const auto connected = client.connect(server.url() + "?token=secret", patience_ns);
  if (connected) return "agreed";
  EXPECT_TRUE(connected.error().starts_with(server.url() + ": ")) << connected.error();
  return connected.error().substr(server.url().size() + 2);
}

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), with);
}

TEST(WebSocketClient, CarriesMessagesOfEverySizeBothWays) {
  ScriptedServer server([](ScriptedPeer& peer) {
    peer.send(peer.read_request());
    for (std::string frame = peer.next_frame(); frame != "end"; frame = peer.next_frame())
      peer.send(server_frame(Opcode{static_cast<std::uint8_t>(frame[0] - '0')}, frame.substr(2)));
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  for (const std::size_t size : {0u, 1u, 125u, 126u, 1536u, 65535u, 65536u, 65537u, 5'000'000u})
    for (const Opcode opcode : {Opcode::text, Opcode::binary}) {
      const std::string payload(size, 'x');
      ASSERT_TRUE(client.send(opcode, payload));
      EXPECT_TRUE(next(client) == std::to_string(static_cast<int>(opcode)) + ":" + payload) << size;
    }
}

TEST(WebSocketClient, ReadsFramesThatComeWithTheHandshake) {
  const std::string large(3000, 'x');
  ScriptedServer server([&](ScriptedPeer& peer) {
    peer.send(peer.read_request() + server_frame(Opcode::binary, large) + server_frame(Opcode::text, "two"));
    peer.wait_closed();
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client), "2:" + large);
  EXPECT_EQ(next(client), "1:two");
}

TEST(WebSocketClient, AnswersAPingBetweenFragments) {
  std::promise<std::string> pong;
  ScriptedServer server([&](ScriptedPeer& peer) {
    peer.send(peer.read_request() + server_frame(Opcode::text, "Hel", false) + server_frame(Opcode::ping, "between"));
    pong.set_value(peer.next_frame());
    peer.send(server_frame(Opcode::pong, "unasked") + server_frame(Opcode::continuation, "", false) +
              server_frame(Opcode::continuation, "lo"));
    peer.wait_closed();
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client), "1:Hello");
  EXPECT_EQ(pong.get_future().get(), "10:between");
}

TEST(WebSocketClient, ReturnsNothingAfterTheServersGoodbye) {
  std::promise<std::string> answer;
  ScriptedServer server([&](ScriptedPeer& peer) {
    peer.send(peer.read_request() + server_frame(Opcode::text, "last") +
              server_frame(Opcode::close, close_payload(kGoingAway, "the server stops")));
    answer.set_value(peer.next_frame().substr(0, 4));
    peer.wait_closed();  // the server leaves the socket open
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client), "1:last");
  EXPECT_FALSE(client.closed());
  EXPECT_EQ(next(client), "nothing");
  ASSERT_TRUE(client.closed());
  EXPECT_EQ(client.closed()->code, kGoingAway);
  EXPECT_EQ(client.closed()->reason, "the server stops");
  EXPECT_EQ(answer.get_future().get(), "8:" + close_payload(kGoingAway, ""));
  EXPECT_EQ(next(client), "nothing");
  EXPECT_FALSE(client.send(Opcode::text, "too late"));
}

TEST(WebSocketClient, KnowsAGoodbyeWithoutACode) {
  ScriptedServer server([](ScriptedPeer& peer) { peer.send(peer.read_request() + server_frame(Opcode::close, "")); });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client), "nothing");
  ASSERT_TRUE(client.closed());
  EXPECT_EQ(client.closed()->code, kNoCodeGiven);
}

TEST(WebSocketClient, SaysWhenTheConnectionEndsInAFrame) {
  ScriptedServer server([](ScriptedPeer& peer) {
    peer.send(peer.read_request() + server_frame(Opcode::text, "whole") + begun_frame(Opcode::binary, 100, "part"));
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client), "1:whole");
  EXPECT_EQ(next(client), "the connection ended without a goodbye");
  EXPECT_EQ(next(client), "the connection ended without a goodbye") << "every later call says it, too";
  EXPECT_FALSE(client.closed());
}

TEST(WebSocketClient, RefusesMessagesAboveTheCap) {
  const std::string sentence = "a message has more than 67108864 bytes";
  const std::size_t cap = WebSocketClient::kMaxMessageBytes;
  EXPECT_EQ(said_of(begun_frame(Opcode::text, cap + 1, "begin")), sentence);
  EXPECT_EQ(said_of(begun_frame(Opcode::binary, UINT64_MAX >> 1, "begin")), sentence);
  EXPECT_EQ(said_of(server_frame(Opcode::text, "12", false) + begun_frame(Opcode::continuation, cap - 1, "begin")),
            sentence);
}

TEST(WebSocketClient, SaysHowAServerBreaksTheProtocol) {
  std::string masked, long_ping = server_frame(Opcode::ping, std::string(126, 'x'));
  tests::append_masked_frame(masked, Opcode::text, "x", 1);
  const std::pair<std::string, std::string> cases[] = {
      {masked, "frame was masked"},
      {"\xc1\x01x", "illegal reserved bits"},
      {"\x83\x01x", "illegal opcode"},
      {server_frame(Opcode::continuation, "x"), "continuation frame was unexpected"},
      {server_frame(Opcode::text, "x", false) + server_frame(Opcode::text, "x"), "data frame was unexpected"},
      {server_frame(Opcode::ping, "x", false), "control frame was fragmented"},
      {long_ping, "control frame size was invalid"},
      {std::string("\x82\x7e\x00\x05hello", 9), "frame size was not canonical"},
      {server_frame(Opcode::text, "\xff"), "frame payload was not valid utf8"},
      {server_frame(Opcode::close, "x"), "close frame payload size was invalid"},
      {server_frame(Opcode::close, std::string("\x03\xed", 2)), "reason code was invalid"},
      {server_frame(Opcode::close, "\x03\xe8\xff"), "close frame payload was not valid utf8"}};
  for (const auto& [bytes, words] : cases) {
    const std::string said = said_of(bytes);
    EXPECT_TRUE(said.starts_with("the server broke the protocol (")) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said << ", expected " << words;
  }
}

TEST(WebSocketClient, RefusesAnAnswerToAnotherRequest) {
  const std::string sentence = "WebSocket: the server's answer does not belong to our request (";
  for (const char* header : {"Sec-WebSocket-Accept: ", "Upgrade: ", "Connection: "}) {
    const std::string name(header);
    const std::string wrong = refused_by([&](const std::string& r) { return replaced(r, name, name + "x"); });
    EXPECT_TRUE(wrong.starts_with(sentence)) << wrong;
    const std::string missing = refused_by([&](const std::string& r) { return replaced(r, name, "X: "); });
    EXPECT_TRUE(missing.starts_with(sentence)) << missing;
  }
}

TEST(WebSocketClient, RefusesAnotherSubprotocol) {
  const std::string sentence = "WebSocket: expected the server to choose one of our subprotocols, got '";
  EXPECT_EQ(refused_by([](const std::string& r) { return replaced(r, "foxglove.sdk.v1", "chat"); }),
            sentence + "chat'");
  EXPECT_EQ(refused_by([](const std::string& r) { return replaced(r, "Sec-WebSocket-Protocol", "X"); }),
            sentence + "'");
  EXPECT_EQ(refused_by([](const std::string& r) { return replaced(r, "foxglove.sdk.v1", "foxglove.websocket.v1"); }),
            "agreed");
}

TEST(WebSocketClient, RepeatsTheServersReasonForARefusal) {
  EXPECT_EQ(refused_by([](const std::string&) {
              return "HTTP/1.1 503 Service Unavailable\r\nContent-Length: 9\r\n\r\nno room\n\n";
            }),
            "WebSocket: expected the server to agree (101), got '503 Service Unavailable': no room");
  EXPECT_EQ(refused_by([](const std::string&) { return "HTTP/1.1 404 Not Found\r\n\r\n"; }),
            "WebSocket: expected the server to agree (101), got '404 Not Found'");
}

TEST(WebSocketClient, SaysWhenTheAnswerIsNotHttp) {
  EXPECT_EQ(refused_by([](const std::string&) { return ""; }), "expected an HTTP response, got none");
  EXPECT_EQ(refused_by([](const std::string& r) { return r.substr(0, 30); }), "expected an HTTP response, got none");
  EXPECT_EQ(refused_by([](const std::string&) { return "SSH-2.0-OpenSSH_9.2\r\n"; }),
            "expected an HTTP response, got another answer (bad version)");
  EXPECT_EQ(refused_by([](const std::string&) { return "HTTP/1.1 101 x\r\nA: " + std::string(100'000, 'x'); }),
            "expected an HTTP response, got another answer (header limit exceeded)");
}

TEST(WebSocketClient, DoesNotWaitForeverForAnAnswer) {
  ScriptedServer silent([](ScriptedPeer& peer) { peer.wait_closed(); });
  WebSocketClient client;
  EXPECT_EQ(client.connect(silent.url(), 20 * kMillisecond).error(), silent.url() + ": no answer in time");
  EXPECT_EQ(next(client), "there is no connection");
  EXPECT_FALSE(client.send(Opcode::text, "x"));
}

TEST(WebSocketClient, GoesOnReadingAfterADeadline) {
  std::promise<void> late;
  ScriptedServer server([&](ScriptedPeer& peer) {
    peer.send(peer.read_request() + begun_frame(Opcode::text, 8, "half"));
    late.get_future().wait();
    peer.send("half");
    EXPECT_EQ(peer.next_frame(), "1:between");
    peer.wait_closed();
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client, 20 * kMillisecond), "no answer in time");
  EXPECT_EQ(next(client, 0), "no answer in time");
  late.set_value();
  EXPECT_TRUE(client.send(Opcode::text, "between"));
  EXPECT_EQ(next(client), "1:halfhalf");
}

TEST(WebSocketClient, KeepsItsDeadlineAtAServerThatOnlyPings) {
  ScriptedServer server([](ScriptedPeer& peer) {
    peer.send(peer.read_request());
    while (peer.send(server_frame(Opcode::ping, "again"))) {
    }
  });
  WebSocketClient client;
  ASSERT_TRUE(client.connect(server.url(), kConnectPatience));
  EXPECT_EQ(next(client, 50 * kMillisecond), "no answer in time");
}

TEST(WebSocketClient, CancelEndsAWaitingCallAndAllLaterOnes) {
  const auto cancelled_while = [](WebSocketClient& client, auto&& call) {
    std::thread cancelling([&] { client.cancel(); });
    call();
    cancelling.join();
    EXPECT_EQ(next(client), "nothing");
    EXPECT_FALSE(client.send(Opcode::text, "x"));
  };
  ScriptedServer silent([](ScriptedPeer& peer) { peer.wait_closed(); });
  WebSocketClient connecting;
  cancelled_while(connecting, [&] {
    EXPECT_EQ(connecting.connect(silent.url(), kConnectPatience).error(), silent.url() + ": cancelled");
  });
  ScriptedServer quiet([](ScriptedPeer& peer) {
    peer.send(peer.read_request());
    peer.wait_closed();
  });
  WebSocketClient receiving;
  ASSERT_TRUE(receiving.connect(quiet.url(), kConnectPatience));
  cancelled_while(receiving, [&] { EXPECT_EQ(next(receiving), "nothing"); });

  std::promise<void> done;
  ScriptedServer deaf([&](ScriptedPeer& peer) {
    peer.send(peer.read_request());
    done.get_future().wait();
  });
  WebSocketClient sending;
  ASSERT_TRUE(sending.connect(deaf.url(), kConnectPatience));
  cancelled_while(sending, [&] {
    EXPECT_EQ(sending.send(Opcode::binary, std::string(64 << 20, 'x')).error(), deaf.url() + ": cancelled");
  });
  done.set_value();
}

TEST(WebSocketClient, TheSearchForANameEndsInTimeAndByCancel) {
  ScriptedServer server([](ScriptedPeer& peer) {
    peer.send(peer.read_request() + server_frame(Opcode::text, "hello"));
    peer.wait_closed();
  });
  const std::string by_name = replaced(server.url(), "127.0.0.1", "localhost");
  WebSocketClient client, late, cancelled, nobody;
  ASSERT_TRUE(client.connect(by_name, kConnectPatience));
  EXPECT_EQ(next(client), "1:hello");
  const auto refused = late.connect(by_name, 0);
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().ends_with(" in time")) << refused.error();
  cancelled.cancel();
  EXPECT_EQ(cancelled.connect(by_name, kConnectPatience).error(), by_name + ": cancelled");
  EXPECT_FALSE(nobody.connect("ws://nobody.invalid:1/", kConnectPatience));
}

// every truncation and every flipped byte of a conversation: messages, nothing or a sentence, and an end
TEST(WebSocketClient, SurvivesEveryDamage) {
  const std::string frames = server_frame(Opcode::text, "Hel", false) + server_frame(Opcode::ping, "p") +
                             server_frame(Opcode::continuation, "lo") + server_frame(Opcode::binary, "12345") +
                             server_frame(Opcode::close, close_payload(kNormalClosure, "bye"));
  const auto talk = [&](std::size_t at, int mask) {
    std::size_t size = 0;
    {
      ScriptedServer server([&](ScriptedPeer& peer) {
        std::string bytes = peer.read_request() + frames;
        size = bytes.size();
        if (mask == 0)
          bytes.resize(std::min(at, bytes.size()));
        else if (at < bytes.size())
          bytes[at] = static_cast<char>(bytes[at] ^ mask);
        peer.send(bytes);
      });
      WebSocketClient client;
      const auto connected = client.connect(server.url(), kConnectPatience);
      if (!connected) {
        EXPECT_GT(connected.error().size(), server.url().size() + 2);
        return std::size_t{1000};
      }
      int messages = 0;
      for (std::string said = next(client); said.starts_with("1:") || said.starts_with("2:"); said = next(client)) {
        EXPECT_LT(++messages, 10);
      }
    }
    return size;
  };
  const std::size_t size = talk(SIZE_MAX, 1);
  ASSERT_LT(size, 1000u);
  for (std::size_t at = 0; at < size; ++at)
    for (const int mask : {0x00, 0x01, 0x80}) talk(at, mask);
}

}  // namespace
}  // namespace robot::net
