// Foresight over recordings: the best strategy from a moment of a recording on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/foresight/foreseer.h"
#include "robot/foresight/game_setting.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/channels.h"

namespace robot::app {

/// The rules and strategies of all questions.
struct LabForesightOptions {
  std::string rules;  // empty: those of the recorded simulation, spl2025 if there is none
  std::vector<std::string>
      strategies;  // that questions may name, by name or path; the first is the one that was played
};

/// Answers to questions about the robots of recordings. Used by any thread.
class LabForesight {
 public:
  explicit LabForesight(LabForesightOptions options) : options_(std::move(options)) {}

  /// Returns the strategies that questions may name: those of the options, then the default ones, 8 at most.
  std::vector<std::string> strategies() const;

  /// Answers from the knowledge of `robot` at `now_ns` [ns since the epoch]: the newest recorded value of each object.
  /// It reads the recording itself and not the memory of the player. After a seek the player's streams reach the new
  /// time one after the other.
  Result<foresight::Forecast> ask(const logging::StreamOf& stream_of, const std::string& robot,
                                  const foresight::WhatIf& question, std::uint64_t now_ns);

  /// Makes every question, running or later, end at once with the rollouts done so far. Called before the end of the
  /// process, so that no caller waits for long.
  void hurry();

 private:
  Result<std::shared_ptr<foreseeing::Foreseer>> foreseer_for(const foreseeing::GameSetting& setting);

  const LabForesightOptions options_;
  Mutex lock_;                        // not held while a question runs
  foreseeing::GameSetting prepared_;  // of `foreseer_`
  std::shared_ptr<foreseeing::Foreseer> foreseer_;
  bool hurries_ = false;
};

/// The options of foresight-lab what-if.
struct WhatIfOptions {
  std::filesystem::path session;
  std::string robot;  // empty: the robot that recorded the session
  double at = 0;      // [s] since the beginning of the session; < 0: before its end
  LabForesightOptions foresight;
  foresight::WhatIf question;
};

/// Returns the forecast from that moment of a recording.
Result<foresight::Forecast> what_if(const WhatIfOptions& options);

}  // namespace robot::app
