#include "robot/app/services/game_service.h"

#include <utility>

#include "robot/app/build_id.h"
#include "robot/app/services/recording_service.h"
#include "robot/core/report.h"

namespace robot::app {
namespace {

using foresight::GameState;

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
  parameters_.declare("match_mode", !options_.practice);
  if (options_.practice)
    report(Level::warning, "game", "practice: wireless networks stay open during games, which no match allows");
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
    case game::Match::Change::none: return;
    case game::Match::Change::began: return begin_session(game->value());
    case game::Match::Change::ended: return end_session();
    case game::Match::Change::another: end_session(); return begin_session(game->value());
  }
}

void GameService::begin_session(const GameState& game) {
  GameState named = game;  // the team's own code may leave out our numbers
  named.set_own_team(options_.link.team);
  named.set_own_player(options_.link.player);
  std::string name = game::session_name(named, options_.field, std::string(kBuildId));
  if (const Result<void> usable = logging::check_session_name(name); !usable) {
    report(Level::warning, "game", usable.error() + "; the match is recorded without a name");
    name.clear();
  }
  const Result<std::uint64_t> request =
      recorder_.want(name, parameters_.text("recording_profile"), recorded_objects(parameters_));
  if (!request) return report(Level::warning, "game", "the match is not recorded: " + request.error());
  request_ = *request;
  parameters_.update("recording", true);
}

void GameService::end_session() {
  const std::optional<std::uint64_t> request = std::exchange(request_, std::nullopt);
  const logging::RecordingStatus status = recorder_.status();
  // a client may have ended it and begun another one
  if (!request || status.state == logging::RecordingStatus::State::off || status.request != request) return;
  if (const Result<std::string> stopped = recorder_.stop(); !stopped)
    return report(Level::warning, "game", stopped.error());
  parameters_.update("recording", false);
}

GameStatus GameService::status() const {
  const auto game = memory_.game.read();
  return {.state = game ? name_of(game->value().state()) : "",
          .in_progress = match_.in_progress(),
          .match_mode = match_.in_progress() && parameters_.flag("match_mode"),
          .practice = !parameters_.flag("match_mode"),
          .warning = listener_ ? listener_->warning() : "",
          .stopped = link_ ? link_->stopped() : ""};
}

}  // namespace robot::app
