// Foresight over recordings: what would we have done from that moment on?
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "proto/foresight/forecast.pb.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/foresight/foreseer.h"
#include "robot/memory/channels.h"

namespace robot::app {

/// What questions go by.
struct LabForesightOptions {
  std::string rules;                    // empty: those of the recorded simulation, spl2025 where there is none
  std::vector<std::string> strategies;  // that can be asked about, by name or path; the first is what was played
};

/// Answers questions about whatever robots are played. Any thread.
class LabForesight {
 public:
  explicit LabForesight(LabForesightOptions options) : options_(std::move(options)) {}

  /// From what `robot` of `channels` knew at `now_ns` [ns since the epoch].
  Result<foresight::Forecast> ask(const memory::Channels& channels, const std::string& robot,
                                  const foresight::WhatIf& question, std::uint64_t now_ns);

 private:
  /// What a recorded simulation was played by, as far as it matters to foresight.
  struct Setting {
    std::string rules, models, opponent_models;
    bool operator==(const Setting&) const = default;
  };

  Setting setting_of(const memory::Channels& channels, const std::string& robot) const;
  Result<foreseeing::Foreseer*> foreseer_for(const Setting& setting);

  const LabForesightOptions options_;
  Mutex lock_;
  Setting prepared_;  // of `foreseer_`
  std::unique_ptr<foreseeing::Foreseer> foreseer_;
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
