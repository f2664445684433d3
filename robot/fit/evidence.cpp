#include "robot/fit/evidence.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "proto/foresight/sim.pb.h"
#include "robot/core/text.h"
#include "robot/lab/clocks/session_times.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::fit {
namespace {

/// A recording of ground truth with its session, for the comparison of clocks.
struct TruthSession {
  logging::Session session;
  std::shared_ptr<const TrueGame> game;
};

/// Returns the name of a session: that of its folder or of its file.
std::string name_of(const logging::Session& session, const std::filesystem::path& path) {
  return path.extension() == ".mcap" ? path.stem().string() : session.id();
}

std::shared_ptr<const TrueGame> game_of(const logging::Session& session, const std::string& name) {
  lab::TruthRecord record = lab::read_truth(session);
  if (record.empty()) return nullptr;
  return std::make_shared<const TrueGame>(TrueGame{.name = name, .record = std::move(record)});
}

bool overlap(const logging::Session& one, const logging::Session& other, std::uint64_t most_ns) {
  return one.start_ns < other.end_ns + most_ns && other.start_ns < one.end_ns + most_ns;
}

/// Returns the robot beside a truth, or the reason why it cannot be placed there.
Result<WatchedRobot> placed(const std::string& name, const logging::Session& session,
                            const std::shared_ptr<const TrueGame>& game, const lab::JudgedRobot& robot) {
  if (!robot.offset) return Error{"its clock's offset to " + game->name + " is not known: " + robot.offset.error()};
  auto own = lab::own_path(game->record, robot);
  if (!own) return Error{"it is not found in " + game->name + ": " + own.error()};
  return WatchedRobot{.name = name,
                      .session = session,
                      .game = game,
                      .path = std::move(own->path),
                      .clock = robot.offset->clock,
                      .clock_by = robot.offset->by};
}

/// Returns the robots whose percepts, beliefs or motion a recording holds: "14/2".
std::vector<std::string> robots_in(const logging::Session& session) {
  std::set<std::string> names;
  for (const logging::StreamFile& stream : session.streams) {
    const std::vector<std::string_view> parts = split(stream.topic, "/");
    if (parts.size() != 4 || !parts[0].empty()) continue;
    if (parts[3] == "pose" || parts[3] == "ball" || parts[3] == "motion_status" || parts[3] == "vision")
      names.insert(std::string(parts[1]) + "/" + std::string(parts[2]));
  }
  return {names.begin(), names.end()};
}

/// Adds a robot. Without a place in a truth it is added as such, with the reason.
void take(const std::string& name, const logging::Session& session, Result<WatchedRobot> robot, Evidence& evidence) {
  if (robot) return evidence.robots.push_back(std::move(*robot));
  evidence.left_out.push_back(name + ": " + robot.error());
  evidence.untracked.push_back({.name = name, .session = session});
}

/// Reports whether a recording is a simulated game whose robots moved in longer pieces (Simulation::thinned).
bool is_thinned(const logging::Session& session) {
  const auto file = std::ranges::find(session.streams, memory::kSimulationTopic, &logging::StreamFile::topic);
  if (file == session.streams.end()) return false;
  const auto stream = logging::provider_of(session, *file);
  if (!stream->open()) return false;
  const auto record = stream->read();
  foresight::Simulation simulation;
  return record && *record && simulation.ParseFromString((*record)->bytes) && simulation.thinned();
}

/// Places each robot of a recording in the truth of this recording.
void place_in_own_truth(const logging::Session& session, const std::shared_ptr<const TrueGame>& game,
                        Evidence& evidence) {
  if (is_thinned(session)) {
    evidence.left_out.push_back(game->name +
                                ": expected a game recorded with foresight-sim match --every-tick, got one whose "
                                "robots move in longer pieces; its truth counts alone");
    return;
  }
  const std::vector<std::string> robots = robots_in(session);
  for (const std::string& one : robots) {
    logging::Session of_one = session;
    of_one.info.robot = one;
    const std::string name = game->name + (robots.size() > 1 ? " " + one : "");
    lab::RobotRecord record = lab::read_robot(of_one, game->record.epoch_ns);
    take(name, of_one,
         placed(name, of_one, game, {.session = 0, .record = std::move(record), .offset = lab::TruthOffset{}}),
         evidence);
  }
}

Result<WatchedRobot> in_truth_of(const std::string& name, const logging::Session& session, const TruthSession& truth,
                                 std::uint64_t most_ns) {
  const auto times = lab::session_times({truth.session, session}, most_ns);
  if (!times) return times.failure();
  if (times->robots.empty()) return Error{"it recorded neither the ball nor its pose"};
  return placed(name, session, truth.game, times->robots.front());
}

Result<WatchedRobot> in_any_truth(const std::string& name, const logging::Session& session,
                                  const std::vector<TruthSession>& truths, std::uint64_t most_ns) {
  std::string reason = "no ground truth is of its time";
  for (const TruthSession& truth : truths) {
    if (!overlap(session, truth.session, most_ns)) continue;
    auto robot = in_truth_of(name, session, truth, most_ns);
    if (robot) return robot;
    reason = robot.error();
  }
  return Error{reason};
}

}  // namespace

double WatchedRobot::own_seconds(std::uint64_t capture_ns) const {
  return static_cast<double>(static_cast<std::int64_t>(capture_ns - game->record.epoch_ns)) * 1e-9;
}

double WatchedRobot::true_seconds(std::uint64_t capture_ns) const {
  const double own = own_seconds(capture_ns);
  return own - clock.at(own);
}

Result<Evidence> gather(const std::vector<std::filesystem::path>& robots,
                        const std::vector<std::filesystem::path>& truths, std::uint64_t most_ns) {
  Evidence evidence;
  std::vector<TruthSession> known;
  for (const std::filesystem::path& path : truths) {
    auto session = logging::open_session(path);
    if (!session) return session.failure();
    auto game = game_of(*session, name_of(*session, path));
    if (!game)
      return Error{name_of(*session, path) + ": expected a recording with /truth/world that shows the ball, got none"};
    evidence.games.push_back(game);
    known.push_back({.session = std::move(*session), .game = std::move(game)});
  }
  for (const std::filesystem::path& path : robots) {
    const auto session = logging::open_session(path);
    if (!session) return session.failure();
    const std::string name = name_of(*session, path);
    if (const auto own = game_of(*session, name)) {
      evidence.games.push_back(own);
      place_in_own_truth(*session, own, evidence);
      continue;
    }
    take(name, *session, in_any_truth(name, *session, known, most_ns), evidence);
  }
  return evidence;
}

}  // namespace robot::fit
