// Foresight over recordings: what would we have done from that moment on?
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
#include "robot/logging/streams/provider.h"
#include "robot/memory/channels.h"

namespace robot::app {

/// What questions go by.
struct LabForesightOptions {
  std::string rules;                    // empty: those of the recorded simulation, spl2025 where there is none
  std::vector<std::string> strategies;  // that can be asked about, by name or path; the first is what was played
};

/// The stream of a topic, not opened yet, to be read by whoever asks for it; null where a recording has none.
using StreamOf = std::function<std::unique_ptr<logging::InProvider>(const std::string& topic)>;

/// Answers questions about the robots of recordings. Any thread.
class LabForesight {
 public:
  explicit LabForesight(LabForesightOptions options) : options_(std::move(options)) {}

  /// The strategies that can be asked about: those of the options, then the usual ones, 8 at most.
  std::vector<std::string> strategies() const;

  /// From what `robot` knew at `now_ns` [ns since the epoch]: each object as it was recorded last by then. That is read
  /// from the recording itself, since what plays it gets to another moment bit by bit, one stream before the other.
  Result<foresight::Forecast> ask(const StreamOf& stream_of, const std::string& robot,
                                  const foresight::WhatIf& question, std::uint64_t now_ns);

  /// From now on every question is answered at once, by what is there. Before the end, so that nobody waits for long.
  void hurry();

 private:
  /// What a recorded simulation was played by, as far as it matters to foresight.
  struct Setting {
    std::string rules, models, opponent_models;
    bool operator==(const Setting&) const = default;
  };

  Setting setting_of(const memory::Channels& channels, const std::string& robot) const;
  Result<std::shared_ptr<foreseeing::Foreseer>> foreseer_for(const Setting& setting);

  const LabForesightOptions options_;
  Mutex lock_;        // not held while a question runs
  Setting prepared_;  // of `foreseer_`
  std::shared_ptr<foreseeing::Foreseer> foreseer_;
  bool hurries_ = false;
};

/// foresight-lab what-if.
struct WhatIfOptions {
  std::filesystem::path session;
  std::string robot;  // empty: the one that recorded
  double at = 0;      // [s] since the beginning of the session; < 0: before its end
  LabForesightOptions foresight;
  foresight::WhatIf question;
};

/// The answer from that moment of a recording.
Result<foresight::Forecast> what_if(const WhatIfOptions& options);

}  // namespace robot::app
