#include "robot/memory/memory_object.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>
#include <vector>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/camera.pb.h"

namespace robot::memory {
namespace {

namespace pb = foresight;

struct BallObject : ::testing::Test {
  BallObject() { ball.announce("/14/2/ball", Delivery::latest, clock); }

  static pb::Ball ball_at(float x, float y) {
    pb::Ball value;
    value.set_x(x);
    value.set_y(y);
    return value;
  }

  ManualClock clock{100};
  MemoryObject<pb::Ball> ball;
};

/// A listener that keeps every version.
struct Hearing : Listener {
  void on_version(const VersionPtr& version) override { versions.push_back(version); }
  std::vector<VersionPtr> versions;
};

TEST_F(BallObject, HasNoValueBeforeTheFirstWrite) { EXPECT_EQ(ball.read(), nullptr); }

TEST_F(BallObject, GivesTheNewestValueWithItsTimesAndNumber) {
  ball.write(ball_at(1, 2), 40);
  clock.set(200);
  ball.write(ball_at(3, 4), 150);
  const auto newest = ball.read();
  EXPECT_EQ(newest->value().x(), 3);
  EXPECT_EQ(newest->capture_ns(), 150u);
  EXPECT_EQ(newest->publish_ns(), 200u);
  EXPECT_EQ(newest->sequence(), 2u);
}

TEST_F(BallObject, NeverChangesAValueThatWasRead) {
  ball.write(ball_at(1, 2), 1);
  const auto kept = ball.read();
  for (int i = 0; i < 100; ++i) ball.write(ball_at(static_cast<float>(i), 0), 2);
  EXPECT_EQ(kept->value().x(), 1);
  EXPECT_EQ(kept->value().y(), 2);
}

TEST_F(BallObject, SerialisesToTheMessage) {
  ball.write(ball_at(1.5, -2), 1);
  const auto version = ball.read();
  pb::Ball parsed;
  ASSERT_TRUE(parsed.ParseFromString(std::string(version->bytes())));
  EXPECT_EQ(parsed.x(), 1.5);
  EXPECT_EQ(version->size_bytes(), version->bytes().size());
}

TEST_F(BallObject, SerialisesOncePerVersion) {
  ball.write(ball_at(1, 2), 1);
  const auto version = ball.read();
  EXPECT_EQ(version->bytes().data(), version->bytes().data());
}

TEST_F(BallObject, SerialisesAgainWhenItsMemoryIsReused) {
  for (int i = 0; i < 50; ++i) {
    ball.write(ball_at(static_cast<float>(i), 0), 1);
    pb::Ball parsed;
    ASSERT_TRUE(parsed.ParseFromString(std::string(ball.read()->bytes())));
    ASSERT_EQ(parsed.x(), static_cast<float>(i));
  }
}

TEST_F(BallObject, AcceptsBytesOfItsMessageAndRefusesOthers) {
  ASSERT_TRUE(ball.write_bytes(ball_at(5, 6).SerializeAsString(), 7));
  EXPECT_EQ(ball.read()->value().x(), 5);
  const Result<void> refused = ball.write_bytes("\xff\xff", 8);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), "/14/2/ball: expected a message of type foresight.Ball, got 2 bytes of something else");
  EXPECT_EQ(ball.read()->sequence(), 1u);
}

TEST_F(BallObject, PassesEveryVersionToListenersBeginningWithTheNewest) {
  Hearing hearing;
  ball.write(ball_at(1, 0), 1);
  ball.write(ball_at(2, 0), 2);
  ball.attach(hearing);
  ball.write(ball_at(3, 0), 3);
  ball.detach(hearing);
  ball.write(ball_at(4, 0), 4);
  ASSERT_EQ(hearing.versions.size(), 2u);
  EXPECT_EQ(hearing.versions[0]->sequence(), 2u);
  EXPECT_EQ(hearing.versions[1]->sequence(), 3u);
}

TEST_F(BallObject, NumbersVersionsOfManyWritersWithoutGapsAndInOrder) {
  constexpr int kWriters = 4, kWrites = 2000;
  Hearing hearing;
  ball.attach(hearing);
  std::vector<std::thread> writers;
  for (int w = 0; w < kWriters; ++w)
    writers.emplace_back([this] {
      for (int i = 0; i < kWrites; ++i) ball.write(ball_at(1, 1), 1);
    });
  for (std::thread& writer : writers) writer.join();
  ball.detach(hearing);
  ASSERT_EQ(hearing.versions.size(), static_cast<std::size_t>(kWriters * kWrites));
  for (std::size_t i = 0; i < hearing.versions.size(); ++i) ASSERT_EQ(hearing.versions[i]->sequence(), i + 1);
}

TEST_F(BallObject, IsNeverSeenHalfUpdated) {
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (int i = 0; i < 20'000; ++i) ball.write(ball_at(static_cast<float>(i), static_cast<float>(-i)), 1);
    done = true;
  });
  std::vector<std::thread> readers;
  for (int r = 0; r < 3; ++r)
    readers.emplace_back([&] {
      std::uint64_t last = 0;
      while (!done) {
        const auto version = ball.read();
        if (!version) continue;
        ASSERT_EQ(version->value().x(), -version->value().y());
        ASSERT_GE(version->sequence(), last);
        last = version->sequence();
        pb::Ball parsed;
        ASSERT_TRUE(parsed.ParseFromString(std::string(version->bytes())));
        ASSERT_EQ(parsed.x(), version->value().x());
      }
    });
  writer.join();
  for (std::thread& reader : readers) reader.join();
}

TEST(ImageObject, ReusesItsMemory) {
  ManualClock clock;
  MemoryObject<pb::Image> image;
  image.announce("/14/2/camera_top", Delivery::latest, clock);
  const std::string pixels(614'400, 'y');
  std::set<const void*> buffers;
  for (int i = 0; i < 100; ++i) {
    auto draft = image.draft();
    draft->set_data(pixels);
    image.write(std::move(draft), 1);
    buffers.insert(image.read()->value().data().data());
  }
  // one is the newest, one is being filled
  EXPECT_LE(buffers.size(), 2u);
}

TEST(ImageObject, VersionsOutliveTheObject) {
  ManualClock clock;
  VersionPtr kept;
  {
    MemoryObject<pb::Image> image;
    image.announce("/14/2/camera_top", Delivery::latest, clock);
    auto draft = image.draft();
    draft->set_data("pixels");
    image.write(std::move(draft), 1);
    kept = image.newest();
  }
  EXPECT_NE(kept->bytes().find("pixels"), std::string_view::npos);
}

TEST(Pool, FreesNothingInAWriterAndKeepsFewSpareObjectsElsewhere) {
  static int alive = 0;
  struct Counted {
    Counted() { ++alive; }
    ~Counted() { --alive; }
  };
  Pool<Counted> pool;
  std::vector<std::shared_ptr<Counted>> lent;
  for (int i = 0; i < 20; ++i) lent.push_back(pool.take());
  {
    const Pool<Counted>::KeepAll writer;
    for (int i = 0; i < 10; ++i) lent.pop_back();
  }
  EXPECT_EQ(alive, 20);
  lent.clear();
  EXPECT_EQ(alive, 10) << "ten are spare already, so each further one is freed";
}

TEST(Pool, KeepsMoreSpareObjectsIfTheyAreSmall) {
  static int alive = 0;
  struct Sized {
    Sized() { ++alive; }
    ~Sized() { --alive; }
    std::size_t size_bytes() const { return 100; }
  };
  Pool<Sized> pool;
  std::vector<std::shared_ptr<Sized>> lent;
  for (int i = 0; i < 100; ++i) lent.push_back(pool.take());
  lent.clear();
  EXPECT_EQ(alive, static_cast<int>(Pool<Sized>::kSpareOfSmall));
}

TEST(WithBytes, KeepsTheTimesOfTheOriginal) {
  ManualClock clock(9);
  RawChannel channel({.topic = "/1/1/x"}, clock);
  ASSERT_TRUE(channel.write_bytes("long original", 5));
  const VersionPtr other = with_bytes(*channel.newest(), 77, "short");
  EXPECT_EQ(other->bytes(), "short");
  EXPECT_EQ(other->size_bytes(), 5u);
  EXPECT_EQ(other->sequence(), 77u);
  EXPECT_EQ(other->capture_ns(), 5u);
  EXPECT_EQ(other->publish_ns(), 9u);
}

TEST(RawChannel, KeepsTheNumberAndTimeOfAnotherProcess) {
  ManualClock clock(9);
  RawChannel channel({.topic = "/1/1/x"}, clock);
  channel.relay("seventh", 5, {.sequence = 7, .publish_ns = 6});
  EXPECT_EQ(channel.newest()->sequence(), 7u);
  EXPECT_EQ(channel.newest()->capture_ns(), 5u);
  EXPECT_EQ(channel.newest()->publish_ns(), 6u);
  channel.relay("late", 8, {.sequence = 3, .publish_ns = 9});
  EXPECT_EQ(channel.newest()->sequence(), 8u) << "numbers only grow";
  ASSERT_TRUE(channel.write_bytes("own", 10));
  EXPECT_EQ(channel.newest()->sequence(), 9u);
  EXPECT_EQ(channel.newest()->publish_ns(), 9u);
}

}  // namespace
}  // namespace robot::memory
