// Foresight as a robot runs it: its threads, its parameters, and who may ask it.
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

/// Declares the parameters `foresight` (the captain asks of its own accord), `foresight_period`, `foresight_budget_ms` and
/// `foresight_horizon`, and the services /foresight/what_if and /foresight/strategies. Made before the runtime starts; its
/// end stops the server, since nobody can be answered any more.
class ForesightService {
 public:
  /// `on`: the first value of `foresight`. `now_ns`: the time of what memory holds [ns since the epoch]. An Error if a
  /// strategy or the rules cannot be had.
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

/// What foresight chooses from where nobody says otherwise.
std::vector<std::string> default_strategies();

foreseeing::ForeseerOptions foreseer_options(const RobotOptions& options);

/// Asks for any robot whose memory is in `channels`; `whose` it is to the one whose models `foreseer` has as its own.
Result<foresight::Forecast> ask_for(foreseeing::Foreseer& foreseer, const memory::Channels& channels,
                                    const std::string& robot, const foresight::WhatIf& question, std::uint64_t now_ns,
                                    foreseeing::Whose whose = foreseeing::Whose::own);

}  // namespace robot::app
