#include "robot/fit/radio/team_record.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "proto/foresight/team.pb.h"
#include "robot/lab/clocks/series.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kLongestDelay = 10;   // [s] a packet with a longer one has a wrong time
constexpr double kLongestPause = 1.6;  // [s] without a message; `team` is written once a second at least
constexpr double kFarthest = 30;       // [m] no robot is farther from the centre

/// Converts a capture time to seconds by the clock of a record.
using SecondsOf = std::function<double(std::uint64_t ns)>;

/// The packet of one mate that the last message showed.
struct Shown {
  std::uint64_t sent_ns = 0, received_ns = 0;
  bool operator==(const Shown&) const = default;
};

class TeamReader {
 public:
  TeamReader(SecondsOf seconds, TeamRecord& record) : seconds_(std::move(seconds)), record_(record) {}

  void take(const foresight::Team& team, std::uint64_t capture_ns) {
    const double at = seconds_(capture_ns);
    if (!record_.written.empty() && at < record_.written.back()) return;  // a clock that was set back
    paused_ = record_.written.empty() || at - record_.written.back() > kLongestPause;
    record_.written.push_back(at);
    note_sent(team);
    for (const foresight::Teammate& mate : team.teammates()) note(mate, at);
  }

  void finish() {
    record_.simulated = !record_.heard.empty() && all_instant_;
    std::vector<double> late;
    for (HeardPacket& packet : record_.heard) {
      // a packet that came within a pause of the recording was shown late
      if (record_.simulated) packet.arrived = after_pause_[packet.shown] ? NAN : packet.shown - kTick;
      if (!std::isnan(packet.arrived)) late.push_back(packet.shown - packet.arrived);
      if (!std::isnan(packet.sent) && std::abs(packet.arrived - packet.sent) > kLongestDelay) {
        packet.sent = NAN;
        ++record_.damaged;
      }
    }
    record_.late = record_.simulated ? 0 : lab::median_of(std::move(late));
    std::ranges::stable_sort(record_.sent, {}, &SentPacket::at);
  }

 private:
  void note_sent(const foresight::Team& team) {
    if (team.sent_ns() == 0 || team.messages_sent() == 0) return;
    if (!record_.sent.empty() && record_.sent.back().number == team.messages_sent()) return;
    record_.sent.push_back({.at = seconds_(team.sent_ns()), .number = team.messages_sent()});
  }

  void note(const foresight::Teammate& mate, double at) {
    const Shown now{.sent_ns = mate.sent_ns(), .received_ns = mate.received_ns()};
    if (now == Shown{}) return;
    if (std::exchange(shown_[mate.player()], now) == now) return;
    all_instant_ = all_instant_ && now.sent_ns == now.received_ns;
    HeardPacket packet{.mate = mate.player(), .shown = at};
    if (now.sent_ns != 0) packet.sent = seconds_(now.sent_ns);
    if (now.received_ns != 0) packet.arrived = seconds_(now.received_ns);
    after_pause_[at] = paused_;
    if (std::abs(at - packet.arrived) > kLongestDelay) {
      ++record_.damaged;
      return;
    }
    read_contents(mate, packet);
    record_.heard.push_back(packet);
  }

  void read_contents(const foresight::Teammate& mate, HeardPacket& packet) const {
    const foresight::Pose& pose = mate.pose();
    if (mate.has_pose() && std::abs(pose.x()) < kFarthest && std::abs(pose.y()) < kFarthest)
      packet.x = pose.x(), packet.y = pose.y();
    if (!mate.has_ball() || mate.ball().seen_ns() == 0) return;
    const std::uint64_t sent_ns = mate.sent_ns() != 0 ? mate.sent_ns() : mate.received_ns();
    const double age = seconds_(sent_ns) - seconds_(mate.ball().seen_ns());
    if (age > -1) packet.ball_age = std::max(0., age);
  }

  const SecondsOf seconds_;
  TeamRecord& record_;
  std::map<unsigned, Shown> shown_;
  std::map<double, bool> after_pause_;  // by the time of a message [s]
  bool paused_ = true, all_instant_ = true;
};

void read_messages(const logging::Session& session, const SecondsOf& seconds, TeamRecord& record) {
  TeamReader reader(seconds, record);
  logging::read_each<foresight::Team>(
      session, "/" + record.robot + "/team",
      [&](const foresight::Team& team, std::uint64_t capture_ns) { reader.take(team, capture_ns); });
  reader.finish();
}

}  // namespace

TeamRecord read_team(const WatchedRobot& robot) {
  TeamRecord record{.name = robot.name,
                    .robot = robot.session.info.robot,
                    .game = robot.game,
                    .clock_deviation = robot.clock.deviation};
  read_messages(
      robot.session, [&robot](std::uint64_t ns) { return robot.true_seconds(ns); }, record);
  return record;
}

TeamRecord read_team(const UntrackedRobot& robot) {
  TeamRecord record{.name = robot.name, .robot = robot.session.info.robot};
  const std::uint64_t start_ns = robot.session.start_ns;
  const auto seconds = [start_ns](std::uint64_t ns) {
    return static_cast<double>(static_cast<std::int64_t>(ns - start_ns)) * 1e-9;
  };
  read_messages(robot.session, seconds, record);
  return record;
}

std::vector<TeamRecord> read_teams(const Evidence& evidence) {
  std::vector<TeamRecord> records;
  const auto add = [&records](TeamRecord record) {
    if (!record.heard.empty() || !record.sent.empty()) records.push_back(std::move(record));
  };
  for (const WatchedRobot& robot : evidence.robots) add(read_team(robot));
  for (const UntrackedRobot& robot : evidence.untracked) add(read_team(robot));
  return records;
}

}  // namespace robot::fit
