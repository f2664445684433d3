#include "robot/app/truth/watch_truth.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "robot/app/foxglove_download.h"
#include "robot/app/lab_objects.h"
#include "robot/app/runtime.h"
#include "robot/app/signals.h"
#include "robot/app/truth/calibration_service.h"
#include "robot/app/truth/opened_sources.h"
#include "robot/core/files.h"

namespace robot::app {
namespace {

/// The objects of the whole field.
struct FieldObjects {
  explicit FieldObjects(const Clock& clock) {
    world.announce("/truth/world", memory::Delivery::latest, clock);
    simulated.announce("/truth/simulated", memory::Delivery::latest, clock);
  }

  memory::MemoryObject<foresight::GroundTruth> world, simulated;
};

RuntimeOptions runtime_options(const TruthOptions& options) {
  return {.program = "foresight-lab",
          .body = "truth",
          .robot = "truth",
          .rules = options.rules,
          .server = options.server,
          .log_folder = absolute_path(options.log_folder),
          .log_bytes = options.log_mb * 1'000'000,
          .recent = logging::kRecentPastOfTeams,
          .foxglove_file = foxglove_file};
}

/// Returns the names of the recorded objects: without images, unless they are wanted.
std::string recorded_objects(const memory::Channels& channels, bool images) {
  if (images) return "";
  std::string names;
  for (const auto& channel : channels.all()) {
    const memory::ChannelInfo& info = channel->info();
    if (info.schema.name == ::foxglove::RawImage::descriptor()->full_name()) continue;
    if (!names.empty()) names += ',';
    names += memory::object_name(info.topic).object;
  }
  return names;
}

}  // namespace

Result<void> watch_truth(const TruthOptions& options) {
  auto sources = OpenedSources::open(options);
  if (!sources) return sources.failure();
  if (const Result<void> usable = logging::check_session_name(options.name); !usable) return usable.failure("--name");
  auto calibrations =
      Calibrations::open(options.calibration, options.rules.substr(0, options.rules.find_first_of(":,")));
  if (!calibrations) return calibrations.failure("--calibration");
  block_end_signals();

  const SessionClock& clock = sources->clock();
  const auto own = std::make_shared<LabObjects>(clock);
  const auto field = std::make_shared<FieldObjects>(clock);
  TruthWriter writer(sources->count(), clock, field->world);
  sources->show_game_in(field->simulated);
  Runtime runtime(runtime_options(options), clock,
                  {.runtime = own->runtime, .clock = own->clock_sample, .log = own->log});
  if (Result<void> listed = list(own, runtime.channels()); !listed) return listed;
  for (memory::Channel* object : std::initializer_list<memory::Channel*>{&field->world, &field->simulated})
    if (Result<void> listed = runtime.channels().add({field, object}); !listed) return listed;

  const std::vector<std::unique_ptr<DepthWatch>> watches = sources->watches(*calibrations, writer);
  for (const auto& watch : watches)
    if (Result<void> listed = watch->list(runtime.channels()); !listed) return listed;
  add_calibration_services(runtime.services(), {.field = sources->field(), .ball_radius = sources->ball_radius()},
                           watches, *calibrations);
  if (Result<void> started = runtime.start(); !started) return started;
  const std::string objects = recorded_objects(runtime.channels(), options.record_images);
  if (Result<void> chosen = runtime.record_only(objects); !chosen) return chosen;
  if (options.record)
    if (Result<void> recording = runtime.record(options.name, "full"); !recording) return recording;
  for (const auto& watch : watches)
    if (Result<void> started = watch->start(); !started) return started;
  runtime.run([] { return true; });
  for (const auto& watch : watches) watch->stop();
  return {};
}

}  // namespace robot::app
