// A watched sensor whose images a test gives.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <deque>
#include <memory>
#include <utility>

#include "robot/app/truth/sensor_watch.h"
#include "robot/truth/synthetic/sensor_poses.h"

namespace robot::app {

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

inline GivenSource::Answer image_at(std::uint64_t capture_ns) {
  truth::DepthFrame frame;
  frame.intrinsics = {.width = 4, .height = 2};
  frame.depth.assign(8, 1000);
  frame.capture_ns = capture_ns;
  return std::optional(frame);
}

/// Returns images that come every 5 ms.
inline std::deque<GivenSource::Answer> images_from(std::uint64_t begin_ns, std::size_t count) {
  std::deque<GivenSource::Answer> images;
  for (std::size_t i = 0; i < count; ++i) images.push_back(image_at(begin_ns + i * 5 * kMillisecond));
  return images;
}

/// A finder that finds one robot in each image, and counts the images.
class OneRobot final : public PlacedFinder {
 public:
  explicit OneRobot(std::atomic<int>& searched) : searched_(searched) {}

  Result<truth::Detections> find(const truth::DepthFrame& frame) override {
    ++searched_;
    truth::Detections seen{.capture_ns = frame.capture_ns};
    seen.robots.push_back({.place = {.position = {1, 2}}, .height = 0.57});
    return seen;
  }
  Result<void> learn_background(const truth::DepthFrame&) override {
    ++learned_;
    return {};
  }
  std::size_t background_images() const override { return learned_; }

 private:
  std::atomic<int>& searched_;
  std::size_t learned_ = 0;
};

class Watching : public testing::Test {
 protected:
  Watching() { world.announce("/truth/world", memory::Delivery::latest, clock); }

  /// Starts a watch of a source.
  void watch(std::deque<GivenSource::Answer> answers, bool live = false) {
    const Finder finder{.at = [this](const PlacedSensor&) -> Result<std::unique_ptr<PlacedFinder>> {
      return std::unique_ptr<PlacedFinder>(std::make_unique<OneRobot>(searched));
    }};
    watches.push_back(std::make_unique<SensorWatch>(SensorWatchOptions{.finder = finder, .paced = !live},
                                                    std::make_unique<GivenSource>(std::move(answers), live), clock,
                                                    calibrations, writer));
    ASSERT_TRUE(watched().list(channels));
    if (calibrated) watched().place(placed);
    ASSERT_TRUE(watched().start());
  }
  SensorWatch& watched() { return *watches.front(); }

  foresight::TruthSensor told() const {
    foresight::TruthSensor message;
    if (const auto version = channels.find("/truth/1/sensor")->newest())
      message.ParseFromArray(version->bytes().data(), static_cast<int>(version->bytes().size()));
    return message;
  }
  bool is_watching() const { return told().state() == foresight::TruthSensor::STATE_WATCHING; }
  bool has_ended() const { return told().state() == foresight::TruthSensor::STATE_ENDED; }
  std::uint64_t images() const {
    const auto version = channels.find("/truth/1/depth")->newest();
    return version ? version->sequence() : 0;
  }

  const PlacedSensor placed{.pose = truth::looking({0, -4, 2}, {0, 0, 0})};
  bool calibrated = true;
  std::atomic<int> searched = 0;  // images
  SessionClock clock;
  memory::MemoryObject<foresight::GroundTruth> world;
  Calibrations calibrations = *Calibrations::open({}, "spl2012");
  TruthWriter writer{1, clock, world};
  memory::Channels channels;
  std::vector<std::unique_ptr<SensorWatch>> watches;
};

}  // namespace robot::app
