#include "robot/app/truth/truth_writer.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/app/truth/sensor_messages.h"

namespace robot::app {
namespace {

/// Fills the fields that ball and robots have in common.
template <class Message>
void fill(const truth::FusedPlace& place, Message& message) {
  message.set_x(static_cast<float>(place.position.x()));
  message.set_y(static_cast<float>(place.position.y()));
  message.set_velocity_x(static_cast<float>(place.velocity.x()));
  message.set_velocity_y(static_cast<float>(place.velocity.y()));
  to_proto(place.covariance, *message.mutable_covariance());
  message.set_track(place.track);
  message.set_sensors(place.sensors);
}

}  // namespace

void to_proto(const truth::FusedTruth& truth, std::uint64_t sent_ns, foresight::GroundTruth& message) {
  message.Clear();
  message.set_detected_ns(truth.detected_ns);
  message.set_sent_ns(sent_ns);
  if (truth.ball) fill(truth.ball->place, *message.mutable_ball());
  for (const truth::FusedRobot& robot : truth.robots) {
    foresight::GroundTruth::TrueRobot& seen = *message.add_robots();
    fill(robot.place, seen);
    if (robot.team) seen.set_team(*robot.team);
    if (robot.player) seen.set_player(*robot.player);
    if (robot.heading) seen.set_heading(static_cast<float>(*robot.heading));
    if (robot.heading_deviation) seen.set_heading_deviation(static_cast<float>(*robot.heading_deviation));
    if (robot.fallen) seen.set_fallen(*robot.fallen);
  }
  for (const std::string& sentence : truth.disagreements) message.add_disagreements(sentence);
}

TruthWriter::TruthWriter(std::size_t sensors, const Clock& clock, memory::MemoryObject<foresight::GroundTruth>& world)
    : clock_(clock), world_(world), eyes_(sensors), tracker_(std::vector<truth::Sensor>(sensors)) {}

void TruthWriter::begin_tracks() {
  std::vector<truth::Sensor> sensors;
  for (const Eye& eye : eyes_) sensors.push_back(eye.sensor);
  tracker_ = truth::Tracker(std::move(sensors));
}

void TruthWriter::place(std::size_t sensor, const truth::Sensor& calibrated) {
  const std::lock_guard guard(lock_);
  eyes_[sensor].sensor = calibrated;
  eyes_[sensor].calibrated = true;
  begin_tracks();
}

void TruthWriter::add(std::size_t sensor, const truth::Detections& detections) {
  const std::lock_guard guard(lock_);
  if (!eyes_[sensor].calibrated) return;
  if (eyes_[sensor].turn == Turn::brought) write();  // the other sensors are slower
  const std::uint64_t refused = tracker_.refused().detections;
  if (const Result<void> added = tracker_.add({.sensor = sensor, .detections = detections}); !added)
    complaints_.report(Level::warning, "truth", added.error());
  if (const std::uint64_t more = tracker_.refused().detections - refused; more > 0)
    complaints_.report(
        Level::warning, "truth",
        "sensor " + std::to_string(sensor + 1) + ": " + std::to_string(more) +
            " places of an image are not used: a number of them is not finite, or their error is impossible");
  eyes_[sensor].turn = Turn::brought;
  if (std::none_of(eyes_.begin(), eyes_.end(), [](const Eye& eye) { return eye.turn == Turn::awaited; })) write();
}

void TruthWriter::lost(std::size_t sensor) {
  const std::lock_guard guard(lock_);
  eyes_[sensor].turn = Turn::absent;
}

void TruthWriter::identify(const truth::OwnPose& pose) {
  const std::lock_guard guard(lock_);
  if (const Result<void> taken = tracker_.identify(pose); !taken)
    complaints_.report(Level::warning, "truth", taken.error());
}

void TruthWriter::write() {
  for (Eye& eye : eyes_)
    if (eye.turn == Turn::brought) eye.turn = Turn::awaited;
  const truth::FusedTruth truth = tracker_.truth();
  auto message = world_.draft();
  to_proto(truth, clock_.now_ns(), *message);
  world_.write(std::move(message), truth.capture_ns);
}

}  // namespace robot::app
