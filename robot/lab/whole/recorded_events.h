// The events of a whole recording: goals, kicks, falls, penalties, states of the game, errors.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/body/replay/replay.h"

namespace robot::lab {

inline constexpr int kCheckedEvery = 256;  // [messages] between two questions whether a reading is cancelled

/// One event, in the words of the viewer's time strip.
struct RecordedEvent {
  std::uint64_t at_ns = 0;  // capture time of the message that reports it
  std::string kind;         // "goal", "kick", "fall", "penalty", "state", "error"
  std::string text;         // "goal of team 14"
  std::string robot;        // the robot that reported it: "14/2"; empty: none

  bool operator==(const RecordedEvent&) const = default;
};

/// All events in order of time.
struct RecordedEvents {
  static constexpr std::size_t kMost = 20'000;  // later ones are left out

  std::vector<RecordedEvent> events;
  bool full = false;          // events were left out
  std::uint64_t damages = 0;  // damaged places of the files that were passed over
};

/// Reads the objects `game`, `motion_status`, `log` and /sim/state of all robots, if they have our types. The rules are
/// those of the viewer (src/memory/game_events.ts): an event is a difference between two messages of one object. Equal
/// reports of several robots within 5 s, of goals within 20 s, are one event; falls and kicks belong to one robot each. Returns nothing when
/// it was cancelled, which it asks for every few messages.
std::optional<RecordedEvents> events_of(const body::Replay& replay, const std::function<bool()>& cancelled);

}  // namespace robot::lab
