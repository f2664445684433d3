#include "robot/app/truth/sensor_watch.h"

#include <gtest/gtest.h>

#include <deque>

#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/support/eventually.h"

namespace robot::app {
namespace {

/// A sensor whose answers a test gives. At their end a recording is over, and a live sensor is unplugged.
class GivenSource final : public truth::DepthSource {
 public:
  using Answer = Result<std::optional<truth::DepthFrame>>;
  GivenSource(std::deque<Answer> answers, bool live) : answers_(std::move(answers)), live_(live) {}

  Answer next() override {
    if (answers_.empty()) {
      if (live_) return Error{"given:0 is unplugged"};
      return std::optional<truth::DepthFrame>();
    }
    Answer answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
  }
  const std::string& address() const override { return address_; }
  bool live() const override { return live_; }

 private:
  std::deque<Answer> answers_;
  const bool live_;
  const std::string address_ = "given:0";
};

GivenSource::Answer image_at(std::uint64_t capture_ns) {
  truth::DepthFrame frame;
  frame.intrinsics = {.width = 4, .height = 2};
  frame.depth.assign(8, 1000);
  frame.capture_ns = capture_ns;
  return std::optional(frame);
}

/// A finder that finds one robot in each image.
class OneRobot final : public PlacedFinder {
 public:
  Result<truth::Detections> find(const truth::DepthFrame& frame) override {
    truth::Detections seen{.capture_ns = frame.capture_ns};
    seen.robots.push_back({.place = {.position = {1, 2}}, .height = 0.57});
    return seen;
  }
};

class Watching : public testing::Test {
 protected:
  Watching() { world.announce("/truth/world", memory::Delivery::latest, clock); }

  /// Starts a watch of a source.
  void watch(std::deque<GivenSource::Answer> answers, bool live) {
    const Finder finder{.at = [](const PlacedSensor&) -> Result<std::unique_ptr<PlacedFinder>> {
      return std::unique_ptr<PlacedFinder>(std::make_unique<OneRobot>());
    }};
    watched = std::make_unique<SensorWatch>(SensorWatchOptions{.finder = finder, .paced = !live},
                                            std::make_unique<GivenSource>(std::move(answers), live), clock,
                                            calibrations, writer);
    ASSERT_TRUE(watched->list(channels));
    watched->place({.pose = truth::looking({0, -4, 2}, {0, 0, 0})});
    ASSERT_TRUE(watched->start());
  }

  foresight::TruthSensor told() const {
    foresight::TruthSensor message;
    if (const auto version = channels.find("/truth/1/sensor")->newest())
      message.ParseFromArray(version->bytes().data(), static_cast<int>(version->bytes().size()));
    return message;
  }
  std::uint64_t images() const {
    const auto version = channels.find("/truth/1/depth")->newest();
    return version ? version->sequence() : 0;
  }

  SessionClock clock;
  memory::MemoryObject<foresight::GroundTruth> world;
  Calibrations calibrations = *Calibrations::open({}, "spl2012");
  TruthWriter writer{1, clock, world};
  memory::Channels channels;
  std::unique_ptr<SensorWatch> watched;
};

TEST_F(Watching, ARecordingIsShownToItsEnd) {
  const std::uint64_t now_ns = clock.now_ns();
  watch({image_at(now_ns), image_at(now_ns + 30 * kMillisecond), image_at(now_ns + 60 * kMillisecond)}, false);
  ASSERT_TRUE(tests::eventually([&] { return told().state() == foresight::TruthSensor::STATE_ENDED; }));
  EXPECT_EQ(images(), 3u);
  EXPECT_EQ(world.read()->capture_ns(), now_ns + 60 * kMillisecond);
  EXPECT_FALSE(told().has_refused_tags()) << "it reads no tags";
}

TEST_F(Watching, ADamagedImageIsToldAndTheNextOneIsUsed) {
  const std::uint64_t now_ns = clock.now_ns();
  watch({Error{"image 1 is torn"}, image_at(now_ns + 30 * kMillisecond)}, false);
  ASSERT_TRUE(tests::eventually([&] { return told().state() == foresight::TruthSensor::STATE_ENDED; }));
  EXPECT_EQ(images(), 1u);
}

TEST_F(Watching, AnUnpluggedSensorIsAStateThatIsShown) {
  watch({image_at(clock.now_ns())}, true);
  ASSERT_TRUE(tests::eventually([&] { return told().problem() == "given:0 is unplugged"; }));
  EXPECT_EQ(told().state(), foresight::TruthSensor::STATE_WAITING);
  EXPECT_EQ(told().robots_size(), 0);
}

TEST_F(Watching, AnImageOfALiveSensorThatIsTooOldIsLeftOut) {
  watch({image_at(clock.now_ns() - kSecond), image_at(clock.now_ns() + 30 * kMillisecond)}, true);
  ASSERT_TRUE(tests::eventually([&] { return told().problem() == "given:0 is unplugged"; }));
  EXPECT_EQ(images(), 1u);
  EXPECT_EQ(told().left_out(), 1u);
}

}  // namespace
}  // namespace robot::app
