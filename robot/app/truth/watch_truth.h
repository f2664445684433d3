// foresight-lab truth: sensors beside the field report where everybody is, to any number of viewers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/app/recording_settings.h"
#include "robot/app/server_settings.h"
#include "robot/core/result.h"
#include "robot/truth/feeds/ssl_packet.h"

namespace robot::app {

/// The options of foresight-lab truth.
struct TruthOptions {
  /// Addresses of robot/truth/sensor/open_source.h, or "synthetic", "synthetic:2", "camera:/dev/video0",
  /// "pictures:FOLDER". Or one of another system alone:
  /// "ssl-vision", "ssl-vision:GROUP:PORT", or "door" for a process of a lab's own.
  std::vector<std::string> sources;
  std::filesystem::path tags;         // the plan of the printed tags, for "camera:…" and "pictures:…"
  std::filesystem::path calibration;  // the file with the places of the sensors; empty: none, and none is saved
  std::string rules = "spl2012";      // the field
  double ball_radius = 0;             // [m] 0: that of the rules, or of the models
  bool orange_ball = true;

  // of the simulated game that synthetic sensors see
  std::string home = "baseline", away = "baseline", models = "match";
  std::uint64_t seed = 1;

  truth::SslTeams teams;       // of the colours of SSL-Vision
  std::string interface;       // on which SSL-Vision's packets come, such as "eth0"; empty: all
  std::filesystem::path door;  // socket of the door; empty: body::default_door()

  /// Live robots, as foresight-lab relay names them. Their poses say which robot is which; their clocks are compared with
  /// ours, and the comparison is recorded.
  std::vector<std::string> robots;
  std::filesystem::path robots_file;  // empty: lab::default_robots_file()
  double max_clock_offset = 60;       // [s] greatest accepted offset of a robot's clock from ours

  RecordingSettings recording;
  bool record_images = false;  // depth images and colours too: 18 MB a second and sensor, or more
  ServerSettings server;
};

/// Watches until SIGINT or SIGTERM. A sensor that is unplugged is a state that is shown, and it comes back by itself. The
/// clock is this machine's, or that of the recordings if the sources are recordings. Returns an Error if it cannot begin.
Result<void> watch_truth(const TruthOptions& options);

}  // namespace robot::app
