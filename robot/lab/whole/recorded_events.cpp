#include "robot/lab/whole/recorded_events.h"

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <string_view>
#include <utility>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/sim.pb.h"
#include "robot/core/text.h"
#include "robot/memory/channel.h"

namespace robot::lab {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kSameNs = 5'000'000'000;       // equal reports of several robots within this time are one event
constexpr std::uint64_t kSameGoalNs = 20'000'000'000;  // as before: the GameController reports goals up to 15 s late
constexpr int kMostPlayers = 20;

/// Movements that are no kicks, by our motions and by the simulator's.
constexpr std::array<std::string_view, 6> kNoKicks = {"", "squat", "stand_up", "sit", "tuck", "get_up"};

/// A function that gets kind and words of an event.
using Tell = std::function<void(const char* kind, std::string text)>;

/// Returns the name of an enum value in lower case without its prefix: STATE_SET is "set".
std::string word(const std::string& name, std::string_view prefix) {
  std::string text = name.substr(std::min(prefix.size(), name.size()));
  for (char& c : text) c = c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

void compare(const pb::TeamState& was, const pb::TeamState& is, const Tell& tell) {
  if (was.number() != is.number()) return;
  const std::string team = std::to_string(is.number());
  if (is.score() > was.score()) tell("goal", "goal of team " + team);
  for (int i = 0; i < std::min({was.players_size(), is.players_size(), kMostPlayers}); ++i)
    if (is.players(i).penalised() && !was.players(i).penalised())
      tell("penalty", team + "/" + std::to_string(i + 1) + " penalised");
}

void compare(const pb::GameState& was, const pb::GameState& is, const Tell& tell) {
  if (is.state() != was.state()) tell("state", word(pb::GameState::State_Name(is.state()), "STATE_"));
  if (is.set_play() != was.set_play() && is.set_play() != pb::GameState::SET_PLAY_UNSPECIFIED)
    tell("state", word(pb::GameState::SetPlay_Name(is.set_play()), "SET_PLAY_"));
  if (is.phase() != was.phase() && is.phase() > pb::GameState::PHASE_NORMAL)
    tell("state", word(pb::GameState::Phase_Name(is.phase()), "PHASE_"));
  if (is.half() != was.half() && was.half() != 0 && is.half() != 0) tell("state", "half " + std::to_string(is.half()));
  if (was.has_own() && is.has_own()) compare(was.own(), is.own(), tell);
  if (was.has_opponent() && is.has_opponent()) compare(was.opponent(), is.opponent(), tell);
}

bool is_down(pb::MotionStatus::Fall fall) {
  return fall == pb::MotionStatus::FALL_FALLING || fall == pb::MotionStatus::FALL_FALLEN;
}

void compare(const pb::MotionStatus& was, const pb::MotionStatus& is, const Tell& tell) {
  if (is_down(is.fall()) && !is_down(was.fall())) {
    const bool known = is.fall_side() != pb::MotionStatus::FALL_SIDE_UNSPECIFIED;
    tell("fall",
         known ? "falls " + word(pb::MotionStatus::FallSide_Name(is.fall_side()), "FALL_SIDE_") : std::string("falls"));
  }
  if (is.running() != was.running() && std::ranges::find(kNoKicks, is.running()) == kNoKicks.end())
    tell("kick", "kick " + word(is.running(), ""));
}

void compare(const pb::Simulation& was, const pb::Simulation& is, const Tell& tell) {
  if (is.seed() != was.seed() || is.tick() < was.tick())
    return tell("state", "new game, seed " + std::to_string(is.seed()));
  if (is.home().score() > was.home().score()) tell("goal", "goal of team " + std::to_string(is.home().number()));
  if (is.away().score() > was.away().score()) tell("goal", "goal of team " + std::to_string(is.away().number()));
}

/// The observer of the messages of one topic.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Passes the events that a message reports to `tell`.
  virtual void take(const std::string& bytes, const Tell& tell) = 0;
};

/// Compares each message with the one before it.
template <class Message>
class Differences final : public Observer {
 public:
  void take(const std::string& bytes, const Tell& tell) override {
    if (!now_.ParseFromString(bytes)) return;
    if (known_) compare(before_, now_, tell);
    known_ = true;
    std::swap(before_, now_);
  }

 private:
  Message before_, now_;
  bool known_ = false;
};

class Errors final : public Observer {
 public:
  void take(const std::string& bytes, const Tell& tell) override {
    if (text_.ParseFromString(bytes) && text_.level() >= pb::LogText::LEVEL_ERROR) tell("error", text_.text());
  }

 private:
  pb::LogText text_;
};

std::unique_ptr<Observer> observer_of(const memory::ChannelInfo& info) {
  const std::string_view object = memory::object_name(info.topic).object;
  const std::string& type = info.schema.name;
  if (object == "game" && type == pb::GameState::descriptor()->full_name())
    return std::make_unique<Differences<pb::GameState>>();
  if (object == "motion_status" && type == pb::MotionStatus::descriptor()->full_name())
    return std::make_unique<Differences<pb::MotionStatus>>();
  if (info.topic == memory::kSimulationTopic && type == pb::Simulation::descriptor()->full_name())
    return std::make_unique<Differences<pb::Simulation>>();
  if ((object == "log" || object.ends_with("/log")) && type == pb::LogText::descriptor()->full_name())
    return std::make_unique<Errors>();
  return nullptr;
}

/// Returns whether the later one is another report of the same event.
bool same(const RecordedEvent& one, const RecordedEvent& other) {
  if (other.at_ns - one.at_ns >= (one.kind == "goal" ? kSameGoalNs : kSameNs)) return false;
  const bool of_one_robot = one.kind == "fall" || one.kind == "kick";
  return one.kind == other.kind && one.text == other.text && (!of_one_robot || one.robot == other.robot);
}

/// Returns the events in order of time, equal reports once.
std::vector<RecordedEvent> merged(std::vector<RecordedEvent> events) {
  std::ranges::stable_sort(events, {}, &RecordedEvent::at_ns);
  std::vector<RecordedEvent> merged;
  for (RecordedEvent& event : events) {
    bool known = false;
    for (std::size_t i = merged.size(); i-- > 0 && event.at_ns - merged[i].at_ns < kSameGoalNs && !known;)
      known = same(merged[i], event);
    if (!known) merged.push_back(std::move(event));
  }
  return merged;
}

}  // namespace

std::optional<RecordedEvents> events_of(const body::Replay& replay, const std::function<bool()>& cancelled) {
  std::vector<std::string> topics;
  std::vector<std::unique_ptr<Observer>> observers;
  for (const std::string& topic : replay.topics()) {
    const std::string_view object = memory::object_name(topic).object;
    // a look at the schema costs the opening of a file
    if (object != "game" && object != "motion_status" && topic != memory::kSimulationTopic && object != "log" &&
        !object.ends_with("/log"))
      continue;
    const auto info = replay.stream_of(topic)->open();
    auto observer = info ? observer_of(*info) : nullptr;
    if (!observer) continue;
    topics.push_back(topic);
    observers.push_back(std::move(observer));
  }

  RecordedEvents found;
  int read = 0;
  bool ended = false;
  std::vector<std::string> robots;
  for (const std::string& topic : topics) robots.emplace_back(memory::object_name(topic).robot);
  found.damages = replay.read(topics, 0, replay.end_ns(), [&](const body::Replay::Message& message) {
    if (++read % kCheckedEvery == 0 && cancelled()) ended = true;
    observers[message.topic]->take(message.bytes, [&](const char* kind, std::string text) {
      if (message.capture_ns < replay.start_ns()) return;  // a retained value
      found.full = found.full || found.events.size() == 4 * RecordedEvents::kMost;
      if (!found.full) found.events.push_back({message.capture_ns, kind, std::move(text), robots[message.topic]});
    });
    return !ended;
  });
  if (ended) return std::nullopt;
  found.events = merged(std::move(found.events));
  found.full = found.full || found.events.size() > RecordedEvents::kMost;
  if (found.events.size() > RecordedEvents::kMost) found.events.resize(RecordedEvents::kMost);
  return found;
}

}  // namespace robot::lab
