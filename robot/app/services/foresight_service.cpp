#include "robot/app/services/foresight_service.h"

#include <algorithm>
#include <utility>

#include "robot/app/services/what_if_service.h"

namespace robot::app {
namespace {

foreseeing::AskingOptions asking(const net::Parameters& parameters) {
  return {.on = parameters.flag("foresight"),
          .period = parameters.number("foresight_period"),
          .budget_ms = static_cast<std::uint32_t>(parameters.integer("foresight_budget_ms")),
          .horizon = parameters.number("foresight_horizon")};
}

void declare(net::Parameters& parameters, bool on) {
  parameters.declare("foresight", on);
  parameters.declare("foresight_period", 10., {.min = 2, .max = 600, .choices = {}});
  parameters.declare("foresight_budget_ms", std::int64_t{500}, {.min = 10, .max = 10'000, .choices = {}});
  parameters.declare("foresight_horizon", 30., {.min = 1, .max = 1200, .choices = {}});
}

}  // namespace

Result<std::unique_ptr<ForesightService>> ForesightService::open(foreseeing::ForeseerOptions options, bool on,
                                                                 Runtime& runtime, memory::Memory& memory,
                                                                 const std::string& robot,
                                                                 std::function<std::uint64_t()> now_ns) {
  auto foreseer = foreseeing::Foreseer::open(std::move(options));
  if (!foreseer) return foreseer.failure();
  std::unique_ptr<ForesightService> made(
      new ForesightService(std::move(*foreseer), on, runtime, memory, robot, now_ns));
  if (Result<void> started = made->advisor_->start(); !started) return started.failure("foresight");
  return made;
}

ForesightService::ForesightService(std::unique_ptr<foreseeing::Foreseer> foreseer, bool on, Runtime& runtime,
                                   memory::Memory& memory, const std::string& robot,
                                   const std::function<std::uint64_t()>& now_ns)
    : runtime_(runtime) {
  declare(runtime.parameters(), on);
  advisor_ = std::make_unique<foreseeing::Advisor>(std::move(foreseer), memory, runtime.channels(), robot, now_ns,
                                                   [&parameters = runtime.parameters()] { return asking(parameters); });
  add_what_if_service(runtime.services(), robot, advisor_->foreseer().strategies(),
                      [this, own = robot, now_ns, &channels = runtime.channels()](
                          const std::string& asked, const foresight::WhatIf& question, std::optional<std::uint64_t>) {
                        if (asked == own) return advisor_->ask(question);
                        return ask_for(advisor_->foreseer(), channels, asked, question, now_ns(),
                                       foreseeing::whose(asked, own));
                      });
}

ForesightService::~ForesightService() {
  advisor_->foreseer().hurry();
  runtime_.stop();
}

std::vector<std::string> default_strategies() { return {"baseline", "passing", "kick_now", "high_line"}; }

foreseeing::ForeseerOptions foreseer_options(const RobotOptions& options) {
  const sim::Side own = own_side_of(options);
  std::vector<std::string> strategies = options.strategies;
  if (strategies.empty()) {
    strategies = default_strategies();
    const auto played = std::find(strategies.begin(), strategies.end(), own_strategy_of(options));
    if (options.body == "sim" && played != strategies.end()) std::rotate(strategies.begin(), played, played + 1);
  }
  return {.strategies = std::move(strategies),
          .rules = rules_of(options),
          .models = models_of(options, own),
          .opponent_models = models_of(options, sim::other(own))};
}

Result<foresight::Forecast> ask_for(foreseeing::Foreseer& foreseer, const memory::Channels& channels,
                                    const std::string& robot, const foresight::WhatIf& question, std::uint64_t now_ns,
                                    foreseeing::Whose whose) {
  if (!channels.find("/" + robot + "/pose")) return Error{"there is no robot '" + robot.substr(0, 40) + "'"};
  return foreseer.ask_and_wait(question, bridge::recollect(channels, robot, now_ns), whose);
}

}  // namespace robot::app
