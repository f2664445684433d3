#include "robot/logging/mcap/time_span.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <vector>

#include "robot/logging/mcap/piece.h"

namespace robot::logging {
namespace {

using Group = TimeGroup;

/// Returns for example "2026-11-25 14:02:11 UTC".
std::string utc(std::uint64_t time_ns) {
  const auto seconds = static_cast<std::time_t>(time_ns / 1'000'000'000);
  std::tm calendar{};
  gmtime_r(&seconds, &calendar);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &calendar);
  return text;
}

/// Sorts the groups and joins those that are near.
std::vector<Group> joined(std::vector<Group> groups) {
  std::ranges::sort(groups, {}, &Group::start_ns);
  std::vector<Group> all;
  for (const Group& group : groups) {
    const bool near =
        !all.empty() && (group.start_ns <= all.back().end_ns || group.start_ns - all.back().end_ns <= kStrayGapNs);
    if (!near) {
      all.push_back(group);
      continue;
    }
    all.back().end_ns = std::max(all.back().end_ns, group.end_ns);
    all.back().messages += group.messages;
  }
  return all;
}

/// Returns the groups within one chunk or run, or none if it is damaged.
std::vector<Group> groups_in(const ByteSource& source, const ChunkInfo& piece) {
  const auto narrow = [](std::uint64_t start_ns, std::uint64_t end_ns) {
    return end_ns >= start_ns && end_ns - start_ns <= kStrayGapNs;
  };
  if (narrow(piece.index.start_ns, piece.index.end_ns)) {
    const auto counts = count_messages(source, piece);
    std::uint64_t messages = 0;
    for (const auto& [channel, count] : counts ? *counts : mcap::Numbers<std::uint16_t>()) messages += count;
    if (messages == 0) return {};
    return {{piece.index.start_ns, piece.index.end_ns, messages}};
  }
  const auto records = read_records(source, piece);
  if (!records) return {};
  std::vector<Group> groups;
  for (const auto& [channel, index] : mcap::survey_records(*records, "").indexes)
    for (const auto& [time_ns, offset] : index.entries) groups.push_back({time_ns, time_ns, 1});
  return joined(std::move(groups));
}

/// Returns the least and the greatest time of all chunks and runs.
Group reach_of(const McapIndex& index) {
  Group reach{
      .start_ns = std::numeric_limits<std::uint64_t>::max(), .end_ns = 0, .messages = index.statistics.messages};
  for (const auto* pieces : {&index.chunks, &index.runs})
    for (const ChunkInfo& piece : *pieces) {
      reach.start_ns = std::min(reach.start_ns, piece.index.start_ns);
      reach.end_ns = std::max(reach.end_ns, piece.index.end_ns);
    }
  return reach;
}

std::string some(std::uint64_t messages) {
  return std::to_string(messages) + (messages == 1 ? " message " : " messages ");
}

}  // namespace

std::string TimeSpan::note() const {
  if (before == 0 && after == 0) return {};
  std::string text;
  if (before > 0) text += some(before) + "before " + utc(start_ns);
  if (after > 0) text += (before > 0 ? " and " : "") + some(after) + "after " + utc(end_ns);
  return text + " left out of the strip, because more than 30 days lie between";
}

std::vector<TimeGroup> time_groups(const ByteSource& source, const McapIndex& index) {
  if (index.statistics.messages == 0) return {};
  const Group reach = reach_of(index);
  if (reach.end_ns >= reach.start_ns && reach.end_ns - reach.start_ns <= kStrayGapNs) return {reach};

  std::vector<Group> groups;
  for (const auto* pieces : {&index.chunks, &index.runs})
    for (const ChunkInfo& piece : *pieces)
      for (const Group& group : groups_in(source, piece)) groups.push_back(group);
  return joined(std::move(groups));
}

TimeSpan time_span(std::vector<TimeGroup> groups) {
  groups = joined(std::move(groups));
  const auto main = std::ranges::max_element(groups, {}, &Group::messages);
  if (main == groups.end()) return {};
  TimeSpan span{.start_ns = main->start_ns, .end_ns = main->end_ns};
  for (const Group& group : groups) {
    if (group.start_ns < main->start_ns) span.before += group.messages;
    if (group.start_ns > main->start_ns) span.after += group.messages;
  }
  return span;
}

}  // namespace robot::logging
