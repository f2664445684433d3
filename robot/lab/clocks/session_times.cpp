#include "robot/lab/clocks/session_times.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace robot::lab {
namespace {

double seconds_of(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

bool has_truth(const logging::Session& session) {
  return std::ranges::any_of(session.streams, [](const logging::StreamFile& stream) {
    return stream.topic == memory::kTruthTopic && stream.messages > 0;
  });
}

/// Returns the offset of a robot's clock to that of the truth: by samples if these are good, else from the data.
Result<TruthOffset> offset_to_truth(const RecordedClock& of_truth, const RecordedClock& of_robot,
                                    const TruthRecord& truth, const RobotRecord& robot, std::uint64_t most_ns) {
  const auto sampled = compare(of_truth, of_robot);
  if (!sampled)
    return offset_from_data(truth, robot, {.middle = 0, .reach = seconds_of(static_cast<std::int64_t>(most_ns))});
  const double offset = seconds_of(sampled->offset.offset_ns);
  const double error = seconds_of(static_cast<std::int64_t>(sampled->offset.error_ns));
  if (sampled->offset.error_ns > kUselessNs) return offset_from_data(truth, robot, {.middle = offset, .reach = error});
  return TruthOffset{.clock = {.offset = offset, .deviation = error / kTwoSided, .middle = 0}, .by = "clock samples"};
}

double applied_drift(const DataOffset& clock) { return clock.drifts() ? clock.drift : 0; }

/// The sessions with their truth.
struct Compared {
  const std::vector<RecordedClock>& clocks;  // of all sessions
  std::size_t truth;                         // index of the session that has it
  const std::vector<JudgedRobot>& robots;
  std::uint64_t epoch_ns;  // of their times

  std::string name_of(std::size_t session) const { return session == truth ? "the ground truth" : clocks[session].who; }

  /// Returns the offset of a session's clock to that of the truth.
  Result<TruthOffset> offset_of(std::size_t session) const {
    if (session == truth) return TruthOffset{};
    const auto robot = std::ranges::find(robots, session, &JudgedRobot::session);
    if (robot == robots.end()) return Error{clocks[session].who + " recorded neither the ball nor its pose"};
    return robot->offset;
  }

  /// Compares a session with the first one.
  Result<Agreement> agreement(std::size_t session, std::uint64_t most_ns) const {
    const ClockOwners owners{.reference = name_of(0), .other = name_of(session)};
    const Result<TruthOffset> ours = offset_of(0), theirs = offset_of(session);
    for (const Result<TruthOffset>* offset : {&ours, &theirs})
      if (!*offset)
        return no_agreement(owners, "no good clock samples of one machine are in both, and " + offset->error());
    const std::string by = ours->by.empty() || theirs->by.empty() ? ours->by + theirs->by : "the ground truth of both";
    // both lines are exact at their middle; one time serves for both
    const double at = session == truth ? ours->clock.middle : theirs->clock.middle;
    const DataOffset between{.offset = theirs->clock.at(at) - ours->clock.at(at),
                             .deviation = std::hypot(ours->clock.deviation_at(at), theirs->clock.deviation_at(at))};
    const ClockDrift drift{.growth = applied_drift(theirs->clock) - applied_drift(ours->clock),
                           .around_ns = epoch_ns + static_cast<std::uint64_t>(std::llround(at * 1e9))};
    return agreement_by(owners, to_clock_offset(between), by, most_ns, drift);
  }
};

/// Reads the robots' records and compares each with the truth.
std::vector<JudgedRobot> judged_robots(const std::vector<logging::Session>& sessions, std::size_t truth,
                                       const std::vector<RecordedClock>& clocks, const TruthRecord& record,
                                       std::uint64_t most_ns) {
  std::vector<JudgedRobot> robots;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (i == truth) continue;
    RobotRecord robot = read_robot(sessions[i], record.epoch_ns);
    if (robot.empty()) continue;
    auto offset = offset_to_truth(clocks[truth], clocks[i], record, robot, most_ns);
    robots.push_back({.session = i, .record = std::move(robot), .offset = std::move(offset)});
  }
  return robots;
}

}  // namespace

Result<OwnPath> own_path(const TruthRecord& truth, const JudgedRobot& robot) {
  constexpr double kReach = 0.5;  // [s] a drift of an hour
  if (!robot.offset) return robot.offset.failure();
  return own_path(truth, robot.record, {.middle = robot.offset->clock.offset, .reach = kReach});
}

Result<SessionTimes> session_times(const std::vector<logging::Session>& sessions, std::uint64_t most_ns) {
  std::vector<RecordedClock> clocks;
  for (const logging::Session& session : sessions) clocks.push_back(read_clock(session));
  auto agreements = agree(clocks, most_ns);
  if (!agreements) return agreements.failure();
  SessionTimes times{.agreements = std::move(*agreements), .truth = {}, .robots = {}};
  const auto with_truth = std::ranges::find_if(sessions, has_truth);
  if (sessions.size() < 2 || with_truth == sessions.end()) return times;
  const auto truth = static_cast<std::size_t>(with_truth - sessions.begin());
  times.truth = read_truth(*with_truth);
  times.robots = judged_robots(sessions, truth, clocks, times.truth, most_ns);
  const Compared compared{.clocks = clocks, .truth = truth, .robots = times.robots, .epoch_ns = times.truth.epoch_ns};
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    if (times.agreements[i].known) continue;
    auto agreement = compared.agreement(i, most_ns);
    if (!agreement) return agreement.failure();
    times.agreements[i] = std::move(*agreement);
  }
  return times;
}

}  // namespace robot::lab
