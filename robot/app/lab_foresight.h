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

/// Answers questions about whatever robots are played. Any thread.
class LabForesight {
 public:
  /// `rules`: empty: those that the recorded simulation names, spl2025 where there is none.
  explicit LabForesight(std::string rules, std::vector<std::string> strategies)
      : rules_(std::move(rules)), strategies_(std::move(strategies)) {}

  /// From what `robot` of `channels` knew at `now_ns` [ns since the epoch].
  Result<foresight::Forecast> ask(const memory::Channels& channels, const std::string& robot,
                                  const foresight::WhatIf& question, std::uint64_t now_ns);

 private:
  Result<foreseeing::Foreseer*> foreseer_for(const memory::Channels& channels);

  const std::string rules_;
  const std::vector<std::string> strategies_;
  Mutex lock_;
  std::string prepared_;  // the rules of `foreseer_`
  std::unique_ptr<foreseeing::Foreseer> foreseer_;
};

/// foresight-lab what-if.
struct WhatIfOptions {
  std::filesystem::path session;
  std::string robot;  // empty: the one that recorded
  double at = 0;      // [s] since the beginning of the session; < 0: before its end
  std::string rules;
  foresight::WhatIf question;
};

/// The answer from that moment of a recording.
Result<foresight::Forecast> what_if(const WhatIfOptions& options);

}  // namespace robot::app
