#include "tests/support/control_packets.h"

#include <bit>
#include <fstream>
#include <iterator>

namespace tests {
namespace {

class Writer {
 public:
  void put(int value, int bytes = 1) {
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(static_cast<unsigned>(value) >> (8 * i) & 255);
  }
  void skip(int bytes) { text.append(static_cast<std::size_t>(bytes), '\x5a'); }

  std::string text = "RGme";
};

int players_of(int version) { return version <= 10 ? 11 : version <= 13 ? 6 : version == 14 ? 7 : 20; }

void put_head(Writer& out, const ControlPacketText& packet, int version) {
  out.put(version, version == 7 ? 4 : version >= 9 && version <= 11 ? 2 : 1);
  if (version >= 8) out.put(packet.packet_number);
  out.put(packet.players_per_team);
  if (version <= 10) {
    if (version >= 9) out.skip(1);  // gameType
    out.put(packet.state);
    out.put(packet.first_half);
    out.put(packet.kicking);
    out.put(packet.phase);  // secondaryState
    out.skip(1);            // dropInTeam
    out.skip(2);            // dropInTime
    out.put(packet.seconds_remaining, version == 7 ? 4 : 2);
    if (version >= 8) out.put(packet.secondary_seconds, 2);
    return;
  }
  out.skip(1);  // competitionPhase; since 19 competitionType
  if (version <= 18) {
    out.skip(1);  // competitionType
  } else {
    out.put(packet.stopped);
  }
  out.put(packet.phase);
  out.put(packet.state);
  out.put(packet.set_play);
  out.put(packet.first_half);
  out.put(packet.kicking);
  if (version == 11) out.skip(3);  // dropInTeam, dropInTime
  out.put(packet.seconds_remaining, 2);
  out.put(packet.secondary_seconds, 2);
}

void put_team(Writer& out, const ControlTeam& team, int version) {
  out.put(team.number);
  out.put(team.field_colour);
  if (version == 7) out.skip(1);  // goalColour
  if (version >= 15) {
    out.put(team.goalkeeper_colour);
    out.put(team.goalkeeper);
  }
  out.put(team.score);
  if (version >= 8) {
    out.put(team.penalty_shot);
    out.put(team.single_shots, 2);
  }
  if (version == 8) out.skip(40);      // coachMessage
  if (version == 9) out.skip(1 + 81);  // coachSequence, coachMessage
  if (version == 10) out.skip(1 + 253);
  if (version >= 8 && version <= 10) out.skip(2);  // coach
  if (version >= 14) out.put(team.message_budget, 2);
  for (int player = 1; player <= players_of(version); ++player) {
    const bool penalised = player == team.penalised_player;
    out.put(penalised ? team.penalty : 0, version == 7 ? 2 : 1);
    out.put(penalised ? team.seconds_till_unpenalised : 0, version == 7 ? 2 : 1);
    if (version == 19) out.put(penalised ? team.warnings : 0);
    if (version >= 19) out.put(penalised ? team.cautions : 0);
  }
}

}  // namespace

std::string ControlPacketText::bytes(int version) const {
  Writer out;
  put_head(out, *this, version);
  put_team(out, first, version);
  put_team(out, second, version);
  return out.text;
}

std::vector<CapturedPacket> read_capture(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<CapturedPacket> packets;
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
  };
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (bytes.size() - at < 10) return {};
    const auto size = static_cast<std::size_t>(number(at + 8, 2));
    if (bytes.size() - at - 10 < size) return {};
    packets.push_back({std::bit_cast<double>(number(at, 8)), bytes.substr(at + 10, size)});
    at += 10 + size;
  }
  return packets;
}

}  // namespace tests
