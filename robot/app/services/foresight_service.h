// Foresight on a robot: its threads, its parameters and its callable services.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "robot/app/robot_options.h"
#include "robot/app/runtime.h"
#include "robot/foresight/advisor.h"
#include "robot/foresight/foreseer.h"

namespace robot::app {

/// The parameters `foresight` (the captain asks by itself), `foresight_period`, `foresight_budget_ms` and
/// `foresight_horizon`, and the services /foresight/what_if and /foresight/strategies. Created before the runtime
/// starts. The destructor stops the server, because the services cannot answer any more.
class ForesightService {
 public:
  /// `on`: the first value of `foresight`. `now_ns`: returns the time of the contents of memory [ns since the epoch].
  /// Returns an Error if a strategy or the rules cannot be loaded.
  static Result<std::unique_ptr<ForesightService>> open(foreseeing::ForeseerOptions options, bool on, Runtime& runtime,
                                                        memory::Memory& memory, const std::string& robot,
                                                        std::function<std::uint64_t()> now_ns);

  ~ForesightService();
  ForesightService(const ForesightService&) = delete;
  ForesightService& operator=(const ForesightService&) = delete;

 private:
  ForesightService(std::unique_ptr<foreseeing::Foreseer> foreseer, bool on, Runtime& runtime, memory::Memory& memory,
                   const std::string& robot, const std::function<std::uint64_t()>& now_ns);

  Runtime& runtime_;
  std::unique_ptr<foreseeing::Advisor> advisor_;
};

/// Returns the strategies that foresight compares by default.
std::vector<std::string> default_strategies();

/// Converts the options of foresight-robot to those of foresight. The own side's strategy of a simulation comes first.
foreseeing::ForeseerOptions foreseer_options(const RobotOptions& options);

/// Asks `foreseer` for any robot whose memory is in `channels`, and waits. `whose`: whether that robot is of the own
/// team of `foreseer` or an opponent. Returns an Error if there is no such robot.
Result<foresight::Forecast> ask_for(foreseeing::Foreseer& foreseer, const memory::Channels& channels,
                                    const std::string& robot, const foresight::WhatIf& question, std::uint64_t now_ns,
                                    foreseeing::Whose whose = foreseeing::Whose::own);

}  // namespace robot::app
