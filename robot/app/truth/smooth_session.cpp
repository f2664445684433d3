#include "robot/app/truth/smooth_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/app/clock_option.h"
#include "robot/app/robot_name.h"
#include "robot/app/session_copy.h"
#include "robot/app/truth/robot_poses.h"
#include "robot/app/truth/sensor_messages.h"
#include "robot/app/truth/truth_writer.h"
#include "robot/core/text.h"
#include "robot/lab/clocks/session_times.h"
#include "robot/logging/sessions/read_all.h"
#include "robot/memory/schema.h"
#include "robot/truth/tracks/smoother.h"

namespace robot::app {
namespace {

/// Images of several sensors that are closer in time show one moment.
constexpr std::uint64_t kSameMomentNs = 10 * kMillisecond;

/// The detections of all sensors.
struct Watched {
  std::vector<truth::Sensor> sensors;
  std::vector<truth::SensorImage> images;
  std::size_t left_out = 0;
};

/// The images of one sensor with the place that they were seen from.
struct SensorRecord {
  std::string place;  // the bytes of the newest one
  foresight::TruthSensor newest;
  std::vector<truth::Detections> images;
};

/// Reads the images since the last calibration.
SensorRecord record_of(const logging::Session& session, const std::string& topic, std::size_t& left_out) {
  SensorRecord record;
  logging::read_each<foresight::TruthSensor>(
      session, topic, [&](const foresight::TruthSensor& sensor, std::uint64_t capture_ns) {
        const bool calibrated = sensor.has_place() && sensor.has_pinhole();
        if (!calibrated || sensor.state() != foresight::TruthSensor::STATE_WATCHING) return;
        if (std::string place = sensor.place().SerializeAsString(); place != record.place) {
          left_out += record.images.size();
          record = {.place = std::move(place), .newest = sensor, .images = {}};
        }
        record.images.push_back(detections_of(sensor, capture_ns));
      });
  return record;
}

bool is_sensor(const logging::StreamFile& stream) {
  return stream.schema == foresight::TruthSensor::descriptor()->full_name();
}

Result<Watched> read_watched(const logging::Session& session) {
  Watched watched;
  for (const logging::StreamFile& stream : session.streams) {
    if (!is_sensor(stream)) continue;
    SensorRecord record = record_of(session, stream.topic, watched.left_out);
    if (record.images.empty()) continue;
    auto pose = pose_of(record.newest);
    if (!pose) return pose.failure(session.id() + ": " + stream.topic);
    const bool reads_tags = record.newest.has_refused_tags();
    const std::size_t sensor = watched.sensors.size();
    watched.sensors.push_back(
        {.pose = std::move(*pose), .robots = reads_tags ? truth::Ranging::plane : truth::Ranging::depth});
    for (truth::Detections& image : record.images)
      watched.images.push_back({.sensor = sensor, .detections = std::move(image)});
  }
  if (watched.images.empty())
    return Error{session.id() + ": expected a recording of foresight-lab truth with a calibrated sensor, got none"};
  return watched;
}

/// Appends the robot's own poses at the truth's times to `poses`, or says in `named` why it cannot.
void add_poses(const lab::TruthRecord& truth, const lab::JudgedRobot& robot, NamedRobot& named,
               std::vector<truth::OwnPose>& poses) {
  if (!robot.offset) {
    named.refused = "its clock's offset is not known: " + robot.offset.error();
    return;
  }
  const lab::DataOffset& clock = robot.offset->clock;
  named.clock = to_text(to_clock_offset(clock)) + ", by " + robot.offset->by;
  const Result<RobotName> name = parse_robot_name(robot.record.name);
  if (!name) {
    named.refused = name.error();
    return;
  }
  const auto own = own_path(truth, robot);
  if (!own || own->poses.empty()) {
    named.refused = own ? "its poses fit no robot of the truth" : own.error();
    return;
  }
  for (const lab::PoseBelief& pose : own->poses.poses) {
    const double at = pose.at - clock.at(pose.at);
    if (at < 0) continue;
    poses.push_back({.capture_ns = truth.epoch_ns + static_cast<std::uint64_t>(std::llround(at * 1e9)),
                     .team = static_cast<std::uint32_t>(name->team),
                     .player = static_cast<std::uint32_t>(name->player),
                     .position = {pose.x, pose.y},
                     .deviation = std::max(kLeastPoseDeviation, own->poses.error)});
  }
}

/// The recordings of the robots, beside that of the truth.
struct Named {
  std::vector<NamedRobot> robots;
  std::vector<truth::OwnPose> poses;
};

Result<Named> read_robots(const logging::Session& session, const SmoothOptions& options, std::uint64_t most_ns) {
  Named named;
  if (options.robots.empty()) return named;
  std::vector<logging::Session> sessions{session};
  for (const std::filesystem::path& path : options.robots) {
    auto robot = logging::open_session(path);
    if (!robot) return robot.failure();
    sessions.push_back(std::move(*robot));
  }
  const auto times = lab::session_times(sessions, most_ns);
  if (!times) return times.failure();
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    NamedRobot& one = named.robots.emplace_back(NamedRobot{.robot = sessions[i].info.robot});
    const auto judged = std::ranges::find(times->robots, i, &lab::JudgedRobot::session);
    if (judged == times->robots.end())
      one.refused = times->truth.empty() ? session.id() + " has no /truth/world" : "it recorded neither ball nor pose";
    else
      add_poses(times->truth, *judged, one, named.poses);
  }
  return named;
}

std::string about_of(const Smoothed& smoothed) {
  std::vector<std::string> names;
  for (const NamedRobot& robot : smoothed.robots)
    if (robot.refused.empty()) names.push_back(robot.robot);
  return "with smoothed ground truth" +
         (names.empty() ? "" : ", in which " + joined(names, ", ") + " say who they are");
}

Result<void> write_truths(const std::vector<truth::FusedTruth>& truths, logging::SessionWriter& writer) {
  const memory::ChannelInfo info{.topic = memory::kTruthTopic,
                                 .schema = memory::schema_of(*foresight::GroundTruth::descriptor())};
  foresight::GroundTruth message;
  for (const truth::FusedTruth& truth : truths) {
    to_proto(truth, 0, message);
    if (Result<void> written = writer.write(info, truth.capture_ns, message.SerializeAsString()); !written)
      return written;
  }
  return {};
}

/// Leaves the last truth of each moment.
std::vector<truth::FusedTruth> moments_of(std::vector<truth::FusedTruth> truths) {
  std::vector<truth::FusedTruth> moments;
  for (std::size_t i = 0; i < truths.size(); ++i)
    if (i + 1 == truths.size() || truths[i + 1].capture_ns > truths[i].capture_ns + kSameMomentNs)
      moments.push_back(std::move(truths[i]));
  return moments;
}

void count(const std::vector<truth::FusedTruth>& truths, Smoothed& smoothed) {
  smoothed.moments = truths.size();
  for (const truth::FusedTruth& truth : truths)
    for (const truth::FusedRobot& robot : truth.robots) {
      if (!robot.team || !robot.player) {
        ++smoothed.unnamed_moments;
        continue;
      }
      const std::string name = std::to_string(*robot.team) + "/" + std::to_string(*robot.player);
      const auto known = std::ranges::find(smoothed.robots, name, &NamedRobot::robot);
      if (known != smoothed.robots.end()) ++known->moments;
    }
}

}  // namespace

Result<Smoothed> smooth_session(const SmoothOptions& options) {
  const auto most_ns = clock_offset_ns(options.max_clock_offset);
  if (!most_ns) return most_ns.failure();
  const auto session = logging::open_session(options.truth);
  if (!session) return session.failure();
  auto watched = read_watched(*session);
  if (!watched) return watched.failure();
  auto named = read_robots(*session, options, *most_ns);
  if (!named) return named.failure();
  Smoothed smoothed{.session = options.session,
                    .sensors = watched->sensors.size(),
                    .images = watched->images.size(),
                    .left_out = watched->left_out,
                    .robots = std::move(named->robots)};
  if (smoothed.session.empty())
    smoothed.session = session->folder.parent_path() / (session->folder.stem().string() + "_smoothed");
  auto all = truth::smooth(watched->sensors, std::move(watched->images), std::move(named->poses));
  if (!all) return all.failure(session->id());
  const std::vector<truth::FusedTruth> truths = moments_of(std::move(*all));
  count(truths, smoothed);
  const Result<void> written =
      write_copy(*session,
                 {.about = about_of(smoothed),
                  .without = memory::kTruthTopic,
                  .add = [&](logging::SessionWriter& writer) { return write_truths(truths, writer); }},
                 smoothed.session);
  if (!written) return written.failure();
  return smoothed;
}

std::string to_text(const Smoothed& smoothed) {
  std::string text = formatted("smoothed  %zu images of %zu sensors\n", smoothed.images, smoothed.sensors);
  if (smoothed.left_out > 0)
    text += formatted("left out  %zu images from before the last calibration of their sensor\n", smoothed.left_out);
  for (const NamedRobot& robot : smoothed.robots) {
    text += formatted("%-8s  ", robot.robot.c_str());
    text += robot.refused.empty()
                ? formatted("in %zu of %zu moments; clock %s\n", robot.moments, smoothed.moments, robot.clock.c_str())
                : "not used: " + robot.refused + "\n";
  }
  text += formatted(
      "unnamed   %.1f robots a moment\n",
      smoothed.moments > 0 ? static_cast<double>(smoothed.unnamed_moments) / static_cast<double>(smoothed.moments) : 0);
  return text + smoothed.session.string() + "\n";
}

}  // namespace robot::app
