#include "robot/net/foxglove/client_queue.h"

#include <gtest/gtest.h>

#include "robot/net/foxglove/to_client.h"
#include "robot/net/websocket/frames.h"
#include "tests/robot/net/net_support.h"

namespace robot::net {
namespace {

using memory::Delivery;
using tests::TestChannel;

/// All frames of a queue, one word per frame: "3:hello" is a message of subscription 3, "time" a Time.
std::string drained(ClientQueue& queue, std::size_t batches = SIZE_MAX) {
  std::string log, bytes;
  Batch batch;
  while (batches-- > 0 && queue.fill(batch)) bytes.append(batch.bytes).append(batch.large);
  FrameParser parser(Sender::server, 64 << 20);
  const auto violation = parser.feed(bytes, [&](Opcode opcode, const std::string& payload) {
    if (!log.empty()) log += ' ';
    if (opcode == Opcode::close) return log += "close", true;
    const auto data = foxglove::parse_message_data(payload);
    if (opcode == Opcode::text || !data) return log += payload, true;
    if (!*data) return log += "time", true;
    const std::string_view content = (*data)->payload;
    log +=
        std::to_string((*data)->subscription) + ":" + std::string(content.size() > 20 ? content.substr(0, 1) : content);
    return true;
  });
  EXPECT_FALSE(violation);
  return log;
}

std::string text_frame(std::string_view text) {
  std::string frame;
  append_frame(frame, Opcode::text, text);
  return frame;
}

class ClientQueueTest : public testing::Test {
 protected:
  TestChannel state, sensor, events;
  ClientQueue queue{{.fifo_messages = 3, .reliable_bytes = 10, .lossless_bytes = 20, .control_bytes = 100}, false};

  void SetUp() override {
    queue.subscribe(1, 11, Delivery::latest);
    queue.subscribe(2, 12, Delivery::fifo);
    queue.subscribe(3, 13, Delivery::reliable);
  }
};

TEST_F(ClientQueueTest, LatestKeepsTheNewestAndCountsTheOthers) {
  for (const char* text : {"a", "b", "c"}) EXPECT_EQ(queue.push(1, state.write(text)), ClientQueue::Pushed::queued);
  EXPECT_EQ(drained(queue), "11:c");
  const auto counts = queue.counts().at(0);
  EXPECT_EQ(counts.sent, 1u);
  EXPECT_EQ(counts.dropped, 2u);
  EXPECT_TRUE(queue.empty());
}

TEST_F(ClientQueueTest, AVersionIsSentWithItsCaptureTimeOrWithAnother) {
  for (const std::optional<std::uint64_t> time_ns : {std::optional<std::uint64_t>(), {7}}) {
    const memory::VersionPtr version = state.write("a");
    queue.push(1, version, time_ns);
    Batch batch;
    ASSERT_TRUE(queue.fill(batch));
    const auto data = foxglove::parse_message_data(std::string_view(batch.bytes).substr(2));
    ASSERT_TRUE(data && *data);
    EXPECT_EQ((*data)->log_time_ns, time_ns.value_or(version->capture_ns()));
  }
}

TEST_F(ClientQueueTest, FifoKeepsTheLastFewInOrder) {
  for (const char* text : {"a", "b", "c", "d", "e"}) queue.push(2, sensor.write(text));
  EXPECT_EQ(drained(queue), "12:c 12:d 12:e");
  EXPECT_EQ(queue.dropped(), 2u);
}

TEST_F(ClientQueueTest, ReliableOverflowsInsteadOfDropping) {
  EXPECT_EQ(queue.push(3, events.write("12345678901234567890")),
            ClientQueue::Pushed::queued);  // alone it may be larger
  EXPECT_EQ(queue.push(3, events.write("x")), ClientQueue::Pushed::overflow);
  EXPECT_EQ(drained(queue), "13:12345678901234567890");
  EXPECT_EQ(queue.push(3, events.write("123")), ClientQueue::Pushed::queued);
  EXPECT_EQ(queue.push(3, events.write("1234567")), ClientQueue::Pushed::queued);
  EXPECT_EQ(queue.push(3, events.write("1")), ClientQueue::Pushed::overflow);
  EXPECT_EQ(queue.dropped(), 0u);
}

TEST_F(ClientQueueTest, EventsGoBeforeSmallMessagesAndThoseBeforeLargeOnes) {
  queue.push(1, state.write(std::string(100'000, 'i')));
  queue.push(2, sensor.write("s"));
  queue.push(3, events.write("e"));
  queue.push_time(5);
  queue.push_control(text_frame("control"));
  EXPECT_EQ(drained(queue), "control time 13:e 12:s 11:i");
}

TEST_F(ClientQueueTest, ChannelsOfAClassTakeTurns) {
  TestChannel other;
  queue.subscribe(4, 14, Delivery::fifo);
  for (const char* text : {"a", "b", "c"}) queue.push(2, sensor.write(text));
  for (const char* text : {"x", "y", "z"}) queue.push(4, other.write(text));
  EXPECT_EQ(drained(queue), "12:a 14:x 12:b 14:y 12:c 14:z");
}

TEST_F(ClientQueueTest, ABatchIsBoundedAndALargeMessageIsNotCopied) {
  TestChannel image;
  ClientQueue many({.fifo_messages = 1000}, false);
  many.subscribe(1, 1, Delivery::fifo);
  many.subscribe(2, 2, Delivery::latest);
  for (int i = 0; i < 100; ++i) many.push(1, sensor.write(std::string(1000, 's')));
  const auto large = image.write(std::string(1 << 20, 'i'));
  many.push(2, large);
  Batch batch;
  std::size_t copied = 0;
  bool referenced = false;
  while (many.fill(batch)) {
    EXPECT_LE(batch.bytes.size(), ClientQueue::kBatchBytes);
    copied += batch.bytes.size();
    if (!batch.large.empty()) {
      EXPECT_EQ(batch.large.data(), large->bytes().data());
      EXPECT_EQ(batch.keeper, large);
      referenced = true;
    }
  }
  EXPECT_TRUE(referenced);
  EXPECT_LT(copied, 110'000u);
}

TEST_F(ClientQueueTest, OnlyTheNewestTimeIsSent) {
  queue.push_time(1);
  queue.push_time(2);
  Batch batch;
  ASSERT_TRUE(queue.fill(batch));
  std::string expected;
  append_frame(expected, Opcode::binary, foxglove::time(2));
  EXPECT_EQ(batch.bytes, expected);
  EXPECT_FALSE(queue.fill(batch));
}

TEST_F(ClientQueueTest, AVersionIsTakenOnce) {
  const auto first = state.write("a"), second = state.write("b");
  EXPECT_EQ(queue.push(1, second), ClientQueue::Pushed::queued);
  EXPECT_EQ(queue.push(1, second), ClientQueue::Pushed::known);
  EXPECT_EQ(queue.push(1, first), ClientQueue::Pushed::known);
  EXPECT_EQ(drained(queue), "11:b");
  // a new subscription begins anew
  queue.unsubscribe(1);
  EXPECT_EQ(queue.push(1, state.write("c")), ClientQueue::Pushed::known);
  queue.subscribe(1, 21, Delivery::latest);
  EXPECT_EQ(queue.push(1, second), ClientQueue::Pushed::queued);
  EXPECT_EQ(drained(queue), "21:b");
}

TEST_F(ClientQueueTest, MessagesOfAnEndedSubscriptionAreNotSent) {
  queue.push(2, sensor.write("a"));
  queue.unsubscribe(2);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(drained(queue), "");
  queue.subscribe(2, 22, Delivery::fifo);
  queue.push(2, sensor.write("b"));
  EXPECT_EQ(drained(queue), "22:b");
}

TEST_F(ClientQueueTest, LosslessGetsEverythingOrOverflows) {
  ClientQueue all({.fifo_messages = 1, .lossless_bytes = 20}, true);
  all.subscribe(1, 1, Delivery::latest);
  all.subscribe(2, 2, Delivery::fifo);
  for (const char* text : {"aaaaa", "bbbbb"}) EXPECT_EQ(all.push(1, state.write(text)), ClientQueue::Pushed::queued);
  for (const char* text : {"ccccc", "ddddd"}) EXPECT_EQ(all.push(2, sensor.write(text)), ClientQueue::Pushed::queued);
  EXPECT_EQ(all.push(2, sensor.write("e")), ClientQueue::Pushed::overflow);
  EXPECT_EQ(drained(all), "1:aaaaa 2:ccccc 1:bbbbb 2:ddddd");
  EXPECT_EQ(all.dropped(), 0u);
}

TEST_F(ClientQueueTest, ControlIsBounded) {
  EXPECT_TRUE(queue.push_control(std::string(60, 'x')));
  EXPECT_FALSE(queue.push_control(std::string(60, 'x')));
}

TEST_F(ClientQueueTest, ACloseFrameFollowsEarlierTextsAndIsTheLast) {
  queue.push(2, sensor.write("a"));
  queue.push_control(text_frame("why"));
  queue.finish(close_frame(kPolicyViolation, ""));
  queue.push_control(text_frame("late"));
  queue.push(2, sensor.write("b"));
  EXPECT_EQ(drained(queue), "why close");
  EXPECT_TRUE(queue.empty());
}

TEST_F(ClientQueueTest, ForgettingKeepsReliableMessages) {
  queue.push(1, state.write("state"));
  queue.push(3, events.write("event"));
  queue.push_time(1);
  queue.forget();
  EXPECT_EQ(drained(queue), "13:event");
}

TEST_F(ClientQueueTest, EmptyMessagesAreMessages) {
  queue.push(2, sensor.write(""));
  EXPECT_FALSE(queue.empty());
  EXPECT_EQ(drained(queue), "12:");
  EXPECT_TRUE(queue.empty());
}

TEST(ClientQueue, ANumberedClientReceivesNumbersAndPublishTimes) {
  TestChannel sensor("/14/2/sensor", Delivery::fifo);
  ClientQueue queue({.fifo_messages = 1}, false, /*numbered=*/true);
  queue.subscribe(1, 7, Delivery::fifo);
  queue.push(1, sensor.write("lost"));
  queue.push(1, sensor.write(std::string(ClientQueue::kLargeBytes, 'x')));
  Batch batch;
  ASSERT_TRUE(queue.fill(batch));
  FrameParser parser(Sender::server, 64 << 20);
  std::string payload;
  EXPECT_FALSE(parser.feed(batch.bytes + std::string(batch.large),
                           [&](Opcode, const std::string& message) { return payload = message, true; }));
  const auto data = foxglove::parse_message_data(payload);
  ASSERT_TRUE(data && *data && (*data)->published);
  EXPECT_EQ((*data)->subscription, 7u);
  EXPECT_EQ((*data)->published->sequence, 2u);
  EXPECT_EQ((*data)->published->publish_ns, 1000u);
  EXPECT_EQ((*data)->payload.size(), ClientQueue::kLargeBytes);
}

}  // namespace
}  // namespace robot::net
