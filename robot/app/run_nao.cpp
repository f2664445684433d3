#include "robot/app/run_nao.h"

#include <iterator>
#include <memory>
#include <string>

#include "robot/app/run_attached.h"
#include "robot/app/services/walk_parameters.h"
#include "robot/body/nao/config.h"
#include "robot/body/nao/nao_body.h"
#include "robot/body/nao/nao_cameras.h"
#include "robot/core/json_library.h"
#include "robot/core/report.h"
#include "robot/nao/guardian/runtime_link.h"

namespace robot::app {
namespace {

/// Objects that the body writes. A team's processes may read them through the door, but not write them.
const char* const kOwnObjects[] = {
    "joints", "inertial", "fsr", "sonar", "touch", "battery", "body", "motion_status", "live_parameters/walk"};

/// Returns a sentence that names the owner of LoLA or of a camera, or an empty string if both are free.
std::string whose_it_is(const body::NaoOptions& nao, const body::NaoConfig& config) {
  const std::string taken = body::NaoBody::taken_by_others(nao);
  return taken.empty() ? body::NaoCameras::taken_by_others(config) : taken;
}

/// Adds the service sit_and_soft. Every client may call it, because a person beside the robot must always be able to.
void add_sit_and_soft(const std::filesystem::path& link, net::Services& services) {
  services.add("sit_and_soft", net::Services::For::everybody,
               [link](const nlohmann::json&, const net::ClientContext&) -> nlohmann::json {
                 const Result<void> asked = body::sit_and_soft(link);
                 return asked ? nlohmann::json{{"ok", true}} : net::failure("sit_and_soft: " + asked.error());
               });
}

struct BodyAndCameras {
  body::NaoBody body;
  body::NaoCameras cameras;

  BodyAndCameras(const body::NaoOptions& nao, const body::NaoConfig& config, memory::Memory& memory,
                 const SessionClock& clock)
      : body(nao, memory, clock), cameras(config, body, memory, clock) {}
};

}  // namespace

Result<void> run_nao(const RobotOptions& options) {
  Result<body::NaoConfig> config =
      options.nao_config.empty() ? body::NaoConfig() : body::read_nao_config(options.nao_config);
  if (!config) return config.failure();
  const body::NaoOptions nao{.link = options.guardian.empty() ? nao::default_link() : options.guardian,
                             .calibration = config->calibration,
                             .walk = config->walk};
  if (const std::string taken = options.plan ? "" : whose_it_is(nao, *config); !taken.empty()) {
    report(Level::warning, "nao", taken + "; going on as body attached");
    RobotOptions beside = options;
    beside.body = "attached";
    return run_attached(beside);
  }

  const std::string robot = robot_named_by(options).text();
  const auto begin = [&](memory::Memory& memory, const SessionClock& clock,
                         Runtime& runtime) -> Result<std::shared_ptr<void>> {
    const auto made = std::make_shared<BodyAndCameras>(nao, *config, memory, clock);
    if (Result<void> started = made->body.start(); !started) return started.failure();
    if (Result<void> started = made->cameras.start(); !started) return started.failure();
    const auto change = [weak = std::weak_ptr(made)](const nao::walk::Parameters& walk) {
      if (const auto alive = weak.lock()) alive->body.change_walk(walk);
    };
    const Result<void> added =
        add_walk_parameters(runtime.parameters(), config->walk, robot, runtime.channels(), clock, change);
    if (!added) return added.failure();
    return std::shared_ptr<void>(made);
  };
  return run_attached(options, {.objects = {std::begin(kOwnObjects), std::end(kOwnObjects)},
                                .add_services = [&](net::Services& services) { add_sit_and_soft(nao.link, services); },
                                .begin = begin});
}

}  // namespace robot::app
