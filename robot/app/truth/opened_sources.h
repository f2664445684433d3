// The sources of foresight-lab truth, opened: sensors, recordings, or synthetic sensors that look at a simulated game.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/app/truth/sensor_watch.h"
#include "robot/app/truth/watch_truth.h"
#include "robot/app/truth/watched_game.h"
#include "sim/field/rules.h"

namespace robot::app {

/// Returns one line for each kind of source that opens here, for --help.
std::string describe_all_sources();

/// The opened sources. Sensors and synthetic sensors live now; recordings live at the time of their first image.
class OpenedSources {
 public:
  /// Opens the sensors with these addresses. Returns an Error for an address that cannot be opened, for recordings beside
  /// live sensors, for more sources than the tracks can use, and for wrong rules, strategies or models.
  static Result<OpenedSources> open(const TruthOptions& options, const std::vector<std::string>& sensors);

  const SessionClock& clock() const { return *clock_; }
  const sim::field::Field& field() const { return rules_.field; }
  double ball_radius() const { return ball_radius_; }  // [m]
  std::size_t count() const { return sources_.size(); }

  /// Reports whether the clock is this machine's: no source is a recording.
  bool live() const { return live_; }

  /// Writes the true world of the simulated game, tick by tick, to `simulated`, which outlives the watches.
  void show_game_in(memory::MemoryObject<foresight::GroundTruth>& simulated);

  /// Hands each source to a watch of its own. Called once. All arguments and this outlive the watches. `tags` is there if a
  /// source is an ordinary camera.
  std::vector<std::unique_ptr<SensorWatch>> watches(const Calibrations& calibrations, TruthWriter& writer,
                                                    const std::optional<truth::tags::TagPlan>& tags);

  /// Waits for the first image of the first source, `longest_ns` or a little longer. Returns an Error without one.
  Result<truth::DepthFrame> first_image(std::uint64_t longest_ns);

 private:
  struct Opened {
    std::unique_ptr<truth::DepthSource> source;
    std::optional<PlacedSensor> placed;  // of a synthetic sensor, which knows its place
  };

  OpenedSources(const TruthOptions& options, const std::vector<std::string>& sensors, const sim::field::Rules& rules);

  Result<void> open_recordings_and_sensors();
  Result<void> open_synthetic();

  TruthOptions options_;
  std::vector<std::string> addresses_;
  sim::field::Rules rules_;
  double ball_radius_;
  std::unique_ptr<SessionClock> clock_;
  bool live_ = true;
  std::unique_ptr<WatchedGame> game_;  // null without a synthetic sensor
  std::vector<Opened> sources_;
};

}  // namespace robot::app
