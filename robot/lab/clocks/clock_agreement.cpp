#include "robot/lab/clocks/clock_agreement.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "proto/foresight/runtime.pb.h"
#include "robot/core/text.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::lab {
namespace {

constexpr const char* kLab = "lab/1";

/// Returns "10.0.14.7" for "10.0.14.7:51234", because every connection has another port.
std::string host_of(const std::string& peer) {
  const std::size_t colon = peer.rfind(':');
  return peer.substr(0, colon);
}

bool is_loopback(const std::string& host) {
  return host.starts_with("127.") || host == "::1" || host == "[::1]" || host.starts_with("::ffff:127.");
}

std::uint64_t magnitude(std::int64_t ns) { return static_cast<std::uint64_t>(std::abs(ns)); }

/// Returns the sample of the shortest round trip. Its error grows by the greatest contradiction of the other samples.
ClockOffset best_of(const std::vector<ClockOffset>& samples) {
  ClockOffset best = *std::ranges::min_element(samples, {}, &ClockOffset::error_ns);
  std::uint64_t contradiction_ns = 0;
  for (const ClockOffset& sample : samples) {
    const std::uint64_t apart_ns = magnitude(sample.offset_ns - best.offset_ns);
    const std::uint64_t allowed_ns = sample.error_ns + best.error_ns;
    if (apart_ns > allowed_ns) contradiction_ns = std::max(contradiction_ns, apart_ns - allowed_ns);
  }
  best.error_ns += contradiction_ns;
  return best;
}

std::map<std::string, std::vector<ClockOffset>> samples_of(const logging::Session& session,
                                                           const logging::StreamFile& file) {
  std::map<std::string, std::vector<ClockOffset>> samples;
  const auto stream = logging::provider_of(session, file);
  const auto info = stream->open();
  if (!info || info->schema.name != foresight::ClockSample::descriptor()->full_name()) return samples;
  while (true) {
    const auto record = stream->read();
    if (!record) continue;  // skip damaged records and use the rest
    if (!*record) return samples;
    foresight::ClockSample sample;
    if (!sample.ParseFromString((*record)->bytes) || sample.source() != foresight::ClockSample::SOURCE_PEER ||
        !sample.has_round_trip_ns())
      continue;
    const std::string host = host_of(sample.peer());
    if (!host.empty() && !is_loopback(host))
      samples[host].push_back({.offset_ns = sample.offset_ns(), .error_ns = (sample.round_trip_ns() + 1) / 2});
  }
}

/// Joins the parts of a sentence.
std::string sentence_of(std::initializer_list<std::string_view> parts) {
  std::string sentence;
  for (const std::string_view part : parts) sentence += part;
  return sentence;
}

ClockOffset turned(const ClockOffset& offset) { return {.offset_ns = -offset.offset_ns, .error_ns = offset.error_ns}; }

}  // namespace

RecordedClock read_clock(const logging::Session& session) {
  RecordedClock clock{.who = session.info.robot, .peers = {}};
  const auto stream_of = [&](const std::string& who) {
    return std::ranges::find(session.streams, "/" + who + "/clock", &logging::StreamFile::topic);
  };
  // a relayed recording is in the time of the machine that relayed it
  auto stream = stream_of(kLab);
  if (stream != session.streams.end() && stream->messages > 0)
    clock.who = kLab;
  else
    stream = stream_of(clock.who);
  if (stream == session.streams.end()) return clock;
  for (const auto& [peer, samples] : samples_of(session, *stream)) clock.peers[peer] = best_of(samples);
  return clock;
}

std::optional<ClockComparison> compare(const RecordedClock& reference, const RecordedClock& other) {
  std::optional<ClockComparison> best;
  const auto consider = [&](const ClockOffset& offset, const std::string& by) {
    if (!best || offset.error_ns < best->offset.error_ns) best = ClockComparison{offset, by};
  };
  if (const auto found = reference.peers.find(other.who); found != reference.peers.end()) consider(found->second, "");
  if (const auto found = other.peers.find(reference.who); found != other.peers.end())
    consider(turned(found->second), "");
  for (const auto& [peer, theirs] : other.peers)
    if (const auto ours = reference.peers.find(peer); ours != reference.peers.end())
      consider(
          {.offset_ns = ours->second.offset_ns - theirs.offset_ns, .error_ns = ours->second.error_ns + theirs.error_ns},
          peer);
  return best;
}

Agreement no_agreement(const ClockOwners& owners, const std::string& reason) {
  return {.sentence = sentence_of({"the clocks of ", owners.other, " and ", owners.reference,
                                   " cannot be compared: ", reason, "; their times stay unchanged"}),
          .known = false};
}

Result<Agreement> agreement_by(const ClockOwners& owners, const ClockOffset& offset, const std::string& by,
                               std::uint64_t most_ns, const ClockDrift& drift) {
  const auto& [reference, other] = owners;
  const std::string told = to_text(offset), source = by.empty() ? "" : ", by " + by;
  const auto shift_ns = correction(offset, most_ns, other + "'s");
  if (!shift_ns) return shift_ns.failure();
  if (drift.growth != 0)
    return Agreement{
        .shift_ns = -offset.offset_ns,
        .drift = drift,
        .sentence = sentence_of({other, "'s clock is ", told, " of ", reference, "'s and gains ",
                                 formatted("%.1f ppm", drift.growth * 1e6), source, ": its times are shifted"})};
  if (*shift_ns == 0)
    return Agreement{.sentence = sentence_of(
                         {"the clocks of ", other, " and ", reference, " agree: ", other, "'s is ", told, source})};
  return Agreement{.shift_ns = *shift_ns,
                   .sentence = sentence_of(
                       {other, "'s clock is ", told, " of ", reference, "'s", source, ": its times are shifted"})};
}

namespace {

Result<Agreement> agree_with(const RecordedClock& reference, const RecordedClock& clock, std::uint64_t most_ns) {
  const ClockOwners owners{.reference = reference.who, .other = clock.who};
  const auto found = compare(reference, clock);
  if (!found) return no_agreement(owners, "no clock samples of one machine are in both");
  if (found->offset.error_ns <= kUselessNs) return agreement_by(owners, found->offset, found->by, most_ns);
  return no_agreement(owners, sentence_of({"by their samples the offset is ", to_text(found->offset),
                                           found->by.empty() ? "" : ", by ", found->by}));
}

}  // namespace

Result<std::vector<Agreement>> agree(const std::vector<RecordedClock>& clocks, std::uint64_t most_ns) {
  std::vector<Agreement> agreements;
  for (const RecordedClock& clock : clocks) {
    if (agreements.empty()) {
      agreements.emplace_back();
      continue;
    }
    auto one = agree_with(clocks.front(), clock, most_ns);
    if (!one) return one.failure();
    agreements.push_back(std::move(*one));
  }
  return agreements;
}

}  // namespace robot::lab
