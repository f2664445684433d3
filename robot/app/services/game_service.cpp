#include "robot/app/services/game_service.h"

#include <utility>

#include "robot/app/build_id.h"
#include "robot/core/report.h"

namespace robot::app {
namespace {

using foresight::GameState;

constexpr std::uint64_t kTryAgainNs = kSecond;  // between attempts to begin a session

std::string name_of(GameState::State state) {
  switch (state) {
    case GameState::STATE_INITIAL: return "initial";
    case GameState::STATE_STANDBY: return "standby";
    case GameState::STATE_READY: return "ready";
    case GameState::STATE_SET: return "set";
    case GameState::STATE_PLAYING: return "playing";
    case GameState::STATE_FINISHED: return "finished";
    default: return "";
  }
}

}  // namespace

GameService::GameService(GameOptions options, memory::Memory& memory, const Clock& clock, logging::Recorder& recorder,
                         net::Parameters& parameters)
    : options_(std::move(options)), memory_(memory), clock_(clock), recorder_(recorder), parameters_(parameters) {
  parameters_.update("recording_profile", options_.profile);
  parameters_.declare("match_mode", true);
}

Result<void> GameService::start() {
  if (!options_.listener) return {};
  auto listener = game::ControlListener::open(*options_.listener, memory_.game, clock_);
  if (!listener) return listener.failure();
  listener_ = std::move(*listener);
  report(Level::info, "game", "listening to the GameController on port " + std::to_string(listener_->port()));
  if (!options_.link.return_packets && !options_.link.team_messages) return {};

  auto link = game::TeamLink::open(options_.link, memory_, clock_, [this] { return listener_->game_controller(); });
  if (!link) return link.failure();
  link_ = std::move(*link);
  return {};
}

void GameService::follow() {
  const auto game = memory_.game.read();
  if (!game) return;
  switch (match_.update(game->value(), clock_.now_ns())) {
    case game::Match::Change::none: return try_again();
    case game::Match::Change::began: return begin_session(game->value());
    case game::Match::Change::ended: return end_session();
    case game::Match::Change::another: end_session(); return begin_session(game->value());
  }
}

void GameService::begin_session(const GameState& game) {
  GameState named = game;  // the team's own code may leave out our numbers
  named.set_own_team(options_.link.team);
  named.set_own_player(options_.link.player);
  missing_.reset();
  const bool taken = recorder_.status().state != logging::RecordingStatus::State::off;
  const Result<std::string> session = recorder_.start(game::session_name(named, options_.field, std::string(kBuildId)),
                                                      parameters_.text("recording_profile"));
  if (session) {
    session_ = *session;
    problem_.clear();
    return parameters_.update("recording", true);
  }
  if (std::exchange(problem_, session.error()) != session.error())
    report(Level::warning, "game", "the match is not recorded: " + problem_);
  // a client's session contains the match already; any other reason, such as a full disk, may pass
  if (!taken) missing_ = {game, clock_.now_ns() + kTryAgainNs};
}

/// Begins the session of a running match that could not begin before.
void GameService::try_again() {
  if (!missing_ || clock_.now_ns() < missing_->due_ns) return;
  if (match_.in_progress()) return begin_session(Missing(*missing_).game);
  missing_.reset();
}

void GameService::end_session() {
  missing_.reset();
  const std::optional<std::string> session = std::exchange(session_, std::nullopt);
  const logging::RecordingStatus status = recorder_.status();
  // a client may have ended it and begun another one
  if (!session || status.state == logging::RecordingStatus::State::off || status.session != session) return;
  if (const Result<std::string> stopped = recorder_.stop(); !stopped)
    return report(Level::warning, "game", stopped.error());
  parameters_.update("recording", false);
}

GameStatus GameService::status() const {
  const auto game = memory_.game.read();
  return {.state = game ? name_of(game->value().state()) : "",
          .in_progress = match_.in_progress(),
          .match_mode = match_.in_progress() && parameters_.flag("match_mode"),
          .warning = listener_ ? listener_->warning() : "",
          .stopped = link_ ? link_->stopped() : ""};
}

}  // namespace robot::app
