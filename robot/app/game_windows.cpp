#include "robot/app/game_windows.h"

#include <algorithm>
#include <utility>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/bridge/teams_seen.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::app {
namespace {

namespace statistics = sim::statistics;
using Truths = std::vector<logging::Recorded<foresight::GroundTruth>>;
using Games = std::vector<logging::Recorded<foresight::GameState>>;

constexpr std::size_t kFewestFrames = 60 * statistics::kFramesPerSecond;
constexpr std::uint64_t kLongestNs = 6ull * 3600 * kSecond;
constexpr std::uint32_t kMostPlayers = 20;

/// Returns the game states of the first robot that has them, in their order.
Games games_of(const logging::Session& session) {
  const auto file = std::ranges::find_if(session.streams, [](const logging::StreamFile& stream) {
    return stream.topic.ends_with("/game") && stream.schema == foresight::GameState::descriptor()->full_name();
  });
  return file == session.streams.end() ? Games{} : logging::read_in_order<foresight::GameState>(session, file->topic);
}

/// Cuts a recording into windows.
class Cutter {
 public:
  explicit Cutter(const bridge::TeamNumbers& teams) : teams_(teams) {}

  void add_empty_frame() {
    if (in_play_ == 0) return;
    now_.ball.emplace_back();
    for (statistics::Robot& robot : now_.robots) robot.frames.emplace_back();
  }

  void add(const foresight::GroundTruth& truth) {
    ++in_play_;
    add_empty_frame();
    if (truth.has_ball()) now_.ball.back() = sim::Vec2{truth.ball().x(), truth.ball().y()};
    for (const auto& robot : truth.robots())
      if (statistics::Robot* known = robot_of(robot))
        known->frames.back() = statistics::Sighting{.position = {robot.x(), robot.y()}, .down = robot.fallen()};
    if (in_play_ == statistics::kWindowFrames) end_window();
  }

  std::vector<statistics::Window> windows() && {
    if (in_play_ >= kFewestFrames) end_window();
    return std::move(windows_);
  }

 private:
  void end_window() {
    windows_.push_back(std::exchange(now_, {}));
    in_play_ = 0;
  }

  /// Returns the robot in the window, new if needed, or nullptr if it is of no side.
  statistics::Robot* robot_of(const foresight::GroundTruth::TrueRobot& robot) {
    if (!robot.has_team() || robot.player() < 1 || robot.player() > kMostPlayers) return nullptr;
    if (robot.team() != teams_.home && robot.team() != teams_.away) return nullptr;
    const int side = robot.team() == teams_.home ? 0 : 1, player = static_cast<int>(robot.player());
    for (statistics::Robot& known : now_.robots)
      if (known.side == side && known.player == player) return &known;
    now_.robots.push_back({.side = side, .player = player, .frames = {}});
    now_.robots.back().frames.resize(now_.size());
    return &now_.robots.back();
  }

  const bridge::TeamNumbers teams_;
  std::vector<statistics::Window> windows_;
  statistics::Window now_;
  std::size_t in_play_ = 0;  // frames of `now_`
};

/// Reports whether the game is in play at a time. Called with ascending times.
class Referee {
 public:
  explicit Referee(const Games& games) : games_(games) {}

  bool in_play(std::uint64_t capture_ns) {
    while (next_ < games_.size() && games_[next_].capture_ns <= capture_ns) ++next_;
    if (games_.empty()) return true;
    return next_ > 0 && games_[next_ - 1].value.state() == foresight::GameState::STATE_PLAYING;
  }

 private:
  const Games& games_;
  std::size_t next_ = 0;
};

}  // namespace

Result<std::vector<statistics::Window>> windows_of(const logging::Session& session) {
  const Truths truths = logging::read_in_order<foresight::GroundTruth>(session, memory::kTruthTopic);
  if (truths.empty()) return Error{session.id() + " has no " + memory::kTruthTopic};
  const std::uint64_t start_ns = truths.front().capture_ns;
  if (truths.back().capture_ns - start_ns > kLongestNs)
    return Error{session.id() + ": " + memory::kTruthTopic + " is longer than 6 hours"};
  const auto teams = bridge::teams_seen(truths);
  if (!teams) return teams.failure(session.id());

  const Games games = games_of(session);
  Referee referee(games);
  Cutter cutter(*teams);
  std::uint64_t tick = 0;  // of the next frame
  for (const auto& truth : truths) {
    const std::uint64_t at = ((truth.capture_ns - start_ns) * statistics::kFramesPerSecond + kSecond / 2) / kSecond;
    if (at < tick) continue;  // several messages of one frame
    for (; tick < at; ++tick) cutter.add_empty_frame();
    ++tick;
    if (referee.in_play(truth.capture_ns))
      cutter.add(truth.value);
    else
      cutter.add_empty_frame();
  }
  auto windows = std::move(cutter).windows();
  if (windows.empty()) return Error{session.id() + ": " + memory::kTruthTopic + " has less than a minute in play"};
  return windows;
}

}  // namespace robot::app
