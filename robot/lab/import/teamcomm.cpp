#include "robot/lab/import/teamcomm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "proto/foresight/team.pb.h"
#include "robot/core/clock.h"
#include "robot/core/text.h"
#include "robot/lab/import/teamcomm_packets.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using teamcomm::Packet;

constexpr std::string_view kJavaStream("\xac\xed\x00\x05", 4);
constexpr std::string_view kPacketClass = "SPLStandardMessagePackage";
constexpr std::size_t kFirstBytes = 200;
constexpr double kAgeOfImage = 30'000, kImagesPerSecond = 30;
constexpr std::uint64_t kLongestLogMs = 1'000'000'000;  // a greater time is damaged

/// The units in which the teams of a log sent.
struct Units {
  bool degrees = false;  // headings; else radians
  bool images = false;   // ages of the ball; else seconds
};

Units units_of(const std::vector<Packet>& packets) {
  const auto is_multiple = [](const Packet& packet) { return std::fmod(packet.ball_age, kAgeOfImage) == 0; };
  const auto is_long = [](const Packet& packet) { return packet.ball_age >= kAgeOfImage; };
  return {.degrees = std::ranges::any_of(
              packets, [](const Packet& packet) { return std::abs(packet.heading) > 1.01 * std::numbers::pi; }),
          .images = std::ranges::any_of(packets, is_long) && std::ranges::all_of(packets, [&](const Packet& packet) {
                      return packet.ball_age < 0 || is_multiple(packet);
                    })};
}

pb::Teammate teammate_of(const Packet& packet, const Units& units, std::uint64_t received_ns) {
  pb::Teammate mate;
  mate.set_player(packet.player);
  mate.set_received_ns(received_ns);
  mate.set_active(true);
  mate.set_fallen(packet.fallen);
  const double heading = units.degrees ? packet.heading * std::numbers::pi / 180 : packet.heading;
  mate.mutable_pose()->set_x(packet.x / 1000);
  mate.mutable_pose()->set_y(packet.y / 1000);
  mate.mutable_pose()->set_heading(static_cast<float>(std::remainder(heading, 2 * std::numbers::pi)));
  const double age = units.images ? packet.ball_age / kAgeOfImage / kImagesPerSecond : packet.ball_age;
  const auto age_ns = static_cast<std::uint64_t>(std::clamp(age, 0., 1e6) * 1e9);
  if (packet.ball_age < 0 || age_ns >= received_ns) return mate;
  mate.mutable_ball()->set_seen_ns(received_ns - age_ns);
  mate.mutable_ball()->set_x(packet.ball_x / 1000);
  mate.mutable_ball()->set_y(packet.ball_y / 1000);
  return mate;
}

void warn_of_packets(std::uint64_t count, const char* what, ImportReport& report) {
  if (count > 0) report.warnings.push_back(std::to_string(count) + what);
}

}  // namespace

bool is_teamcomm_log(std::string_view file_bytes) {
  return file_bytes.starts_with(kJavaStream) &&
         file_bytes.substr(0, kFirstBytes).find(kPacketClass) != std::string_view::npos;
}

Result<ImportReport> import_teamcomm(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink) {
  if (!is_teamcomm_log(file_bytes))
    return Error{
        "log of the TeamCommunicationMonitor: expected a Java stream of SPLStandardMessagePackage, got another file"};
  const teamcomm::Log log = teamcomm::read_log(file_bytes);
  const Units units = units_of(log.packets);
  ImportReport report;
  report.damage = log.damage;
  CountingSink counted(sink, report);
  std::map<unsigned, pb::Teammate> mates;  // by player
  std::uint64_t others = 0;
  for (const Packet& packet : log.packets) {
    if (packet.team != log.packets.front().team || packet.time_ms > kLongestLogMs) {
      ++others;
      continue;
    }
    const std::uint64_t received_ns = epoch_ns + packet.time_ms * kMillisecond;
    mates[packet.player] = teammate_of(packet, units, received_ns);
    pb::Team team;
    for (const auto& [player, mate] : mates) *team.add_teammates() = mate;
    if (const Result<void> taken = counted.message("team", received_ns, team); !taken) return taken.failure();
  }
  if (!log.packets.empty())
    report.about = formatted("packets of team %u; headings in %s, ages of the ball in %s", log.packets.front().team,
                             units.degrees ? "degrees" : "radians", units.images ? "images" : "seconds");
  warn_of_packets(log.repeated, " packets are there twice; left out", report);
  warn_of_packets(log.unreadable, " packets are not of version 6, or have no numbers; left out", report);
  warn_of_packets(others, " packets are of another team or have a wrong time; left out", report);
  return report;
}

}  // namespace robot::lab
