#include "robot/app/truth/watch_truth.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "robot/app/clock_option.h"
#include "robot/app/foxglove_download.h"
#include "robot/app/given_back.h"
#include "robot/app/lab_objects.h"
#include "robot/app/relayed_robots.h"
#include "robot/app/runtime.h"
#include "robot/app/signals.h"
#include "robot/app/truth/calibration_service.h"
#include "robot/app/truth/feed_watch.h"
#include "robot/app/truth/opened_sources.h"
#include "robot/app/truth/robot_poses.h"
#include "robot/body/attached/truth_door.h"
#include "robot/core/files.h"
#include "robot/truth/sensor/open_source.h"

namespace robot::app {
namespace {

/// The objects of the whole field.
struct FieldObjects {
  explicit FieldObjects(const Clock& clock) {
    world.announce(memory::kTruthTopic, memory::Delivery::latest, clock);
    simulated.announce("/truth/simulated", memory::Delivery::latest, clock);
  }

  memory::MemoryObject<foresight::GroundTruth> world, simulated;
};

constexpr std::string_view kSslVision = "ssl-vision", kDoor = "door";

/// The sources by their kind.
struct Kinds {
  std::vector<std::string> sensors;
  std::optional<truth::MulticastAddress> ssl_vision;
  bool door = false;
};

/// Parses "ssl-vision" or "ssl-vision:GROUP:PORT".
Result<truth::MulticastAddress> multicast_of(const std::string& address, const std::string& interface) {
  truth::MulticastAddress multicast{.interface = interface};
  if (address == kSslVision) return multicast;
  const std::size_t group = kSslVision.size() + 1, colon = address.find(':', group);
  const std::string_view port = colon == std::string::npos ? "" : std::string_view(address).substr(colon + 1);
  const auto [end, problem] = std::from_chars(port.data(), port.data() + port.size(), multicast.port);
  if (problem != std::errc() || end != port.data() + port.size())
    return Error{"--source: expected ssl-vision or ssl-vision:GROUP:PORT, got '" + address + "'"};
  multicast.group = address.substr(group, colon - group);
  return multicast;
}

Result<Kinds> kinds_of(const TruthOptions& options) {
  Kinds kinds;
  for (const std::string& address : options.sources) {
    const std::string kind = address.substr(0, address.find(':'));
    if (kind != kSslVision && kind != kDoor) {
      kinds.sensors.push_back(address);
      continue;
    }
    if (options.sources.size() > 1)
      return Error{"--source: " + address + " must be the only source, got " + std::to_string(options.sources.size())};
    if (address == kDoor) {
      kinds.door = true;
    } else if (kind == kDoor) {
      return Error{"--source: expected door, got '" + address + "'; --door PATH names the socket"};
    } else {
      auto multicast = multicast_of(address, options.interface);
      if (!multicast) return multicast.failure();
      kinds.ssl_vision = std::move(*multicast);
    }
  }
  return kinds;
}

/// Returns the plan of the printed tags if a sensor is an ordinary camera, or an Error if something for it is missing.
Result<std::optional<truth::tags::TagPlan>> tag_plan(const TruthOptions& options,
                                                     const std::vector<std::string>& sensors) {
  const auto camera = std::ranges::find_if(sensors, truth::is_ordinary_camera);
  if (camera == sensors.end()) return std::optional<truth::tags::TagPlan>();
  if (options.tags.empty())
    return Error{"--source: " + *camera + ": expected --tags FILE, the plan of the printed tags"};
  if (options.calibration.empty())
    return Error{"--source: " + *camera + ": expected --calibration FILE, where the camera stands"};
  auto plan = truth::tags::read_tag_plan(options.tags);
  if (!plan) return plan.failure("--tags");
  return std::optional(std::move(*plan));
}

RuntimeOptions runtime_options(const TruthOptions& options, const RelayedRobots& robots) {
  return {.program = "foresight-lab",
          .body = "truth",
          .robot = "truth",
          .rules = options.rules,
          .server = options.server,
          .log_folder = absolute_path(options.recording.log_folder),
          .log_bytes = options.recording.log_bytes(),
          .recent = logging::kRecentPastOfTeams,
          .foxglove_file = foxglove_file,
          .add_statistics = [&robots](auto& statistics) { robots.describe(statistics); }};
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
  give_images_back();
  const auto kinds = kinds_of(options);
  if (!kinds) return kinds.failure();
  const auto tags = tag_plan(options, kinds->sensors);
  if (!tags) return tags.failure();
  auto sources = OpenedSources::open(options, kinds->sensors);
  if (!sources) return sources.failure();
  if (const Result<void> usable = logging::check_session_name(options.recording.name); !usable)
    return usable.failure("--name");
  auto calibrations = Calibrations::open(options.calibration, options.rules);
  if (!calibrations) return calibrations.failure("--calibration");
  const auto most_offset_ns = clock_offset_ns(options.max_clock_offset);
  if (!most_offset_ns) return most_offset_ns.failure();
  if (!options.robots.empty() && !sources->live())
    return Error{
        "--robot: expected live sensors beside live robots, got a recording; foresight-lab smooth joins "
        "recordings"};
  const auto robots = RelayedRobots::find(options.robots, options.robots_file);
  if (!robots) return robots.failure("--robot");
  block_end_signals();

  const SessionClock& clock = sources->clock();
  const auto own = std::make_shared<LabObjects>(clock);
  const auto field = std::make_shared<FieldObjects>(clock);
  TruthWriter writer(sources->count(), clock, field->world);
  sources->show_game_in(field->simulated);
  // before the runtime, whose server answers calibrations until its end
  const std::vector<std::unique_ptr<SensorWatch>> watches = sources->watches(*calibrations, writer, *tags);
  memory::Channels robots_objects;
  RobotPoses poses(robots_objects, writer);
  Runtime runtime(runtime_options(options, **robots), clock,
                  {.runtime = own->runtime, .clock = own->clock_sample, .log = own->log});
  if (Result<void> listed = list(own, runtime.channels()); !listed) return listed;
  for (memory::Channel* object : std::initializer_list<memory::Channel*>{&field->world, &field->simulated})
    if (Result<void> listed = runtime.channels().add({field, object}); !listed) return listed;

  for (const auto& watch : watches)
    if (Result<void> listed = watch->list(runtime.channels()); !listed) return listed;
  add_calibration_services(runtime.services(), {.field = sources->field(), .ball_radius = sources->ball_radius()},
                           watches, *calibrations);
  std::unique_ptr<FeedWatch> feed;
  if (kinds->ssl_vision) {
    auto opened = truth::SslVisionFeed::open(*kinds->ssl_vision, options.teams, clock);
    if (!opened) return opened.failure("--source");
    feed = std::make_unique<FeedWatch>(std::move(*opened), clock, field->world);
  }
  std::unique_ptr<body::Door> door;
  if (kinds->door) {
    auto opened = body::open_truth_door(options.door.empty() ? body::default_door() : options.door, {}, clock,
                                        runtime.channels(), runtime.board());
    if (!opened) return opened.failure("--source");
    door = std::move(*opened);
  }
  if (Result<void> started = runtime.start(); !started) return started;
  const std::string objects = recorded_objects(runtime.channels(), options.record_images);
  if (Result<void> chosen = runtime.record_only(objects); !chosen) return chosen;
  if (options.recording.record)
    if (Result<void> recording = runtime.record(options.recording.name, "full"); !recording) return recording;
  for (const auto& watch : watches)
    if (Result<void> started = watch->start(); !started) return started;
  if (feed)
    if (Result<void> started = feed->start(); !started) return started;
  const Result<void> connected = (*robots)->connect({.robot = {},
                                                     .pictures = lab::Pictures::none,
                                                     .objects = {kPoseObject, kGameObject},
                                                     .most_offset_ns = *most_offset_ns},
                                                    robots_objects, clock, own->clock_sample);
  if (!connected) return connected.failure();
  runtime.run([&poses] {
    poses.pass_on();
    return true;
  });
  (*robots)->stop();
  for (const auto& watch : watches) watch->stop();
  return {};
}

}  // namespace robot::app
