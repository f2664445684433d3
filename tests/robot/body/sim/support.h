// Games for the tests of the simulated body.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "robot/body/sim/sim_body.h"
#include "robot/core/clock.h"
#include "robot/memory/channel.h"
#include "sim/io/matchup.h"

namespace tests {

inline robot::body::GameSetup setup(const std::string& rules = "spl2012", const std::string& models = "match") {
  auto game = sim::io::prepare({.rules = rules, .models = {models, models}, .pace = sim::Pace::every_tick});
  EXPECT_TRUE(game) << (game ? "" : game.error());
  return {.game = std::move(*game), .names = {.rules = rules, .teams = {}}};
}

inline const std::string kShortRules = "spl2012,halves=1,half_duration=1,ready_duration=1,set_duration=1";

/// Keeps what was written to a channel, as bytes with their capture times.
class Recording final : public robot::memory::Listener {
 public:
  struct Message {
    std::uint64_t capture_ns;
    std::string bytes;
  };

  explicit Recording(robot::memory::Channel& channel) : channel_(channel) { channel_.attach(*this); }
  ~Recording() override { channel_.detach(*this); }

  void on_version(const robot::memory::VersionPtr& version) override {
    const std::lock_guard guard(lock_);
    messages_.push_back({version->capture_ns(), std::string(version->bytes())});
  }
  std::vector<Message> messages() const {
    const std::lock_guard guard(lock_);
    return messages_;
  }

 private:
  robot::memory::Channel& channel_;
  mutable std::mutex lock_;
  std::vector<Message> messages_;
};

}  // namespace tests
