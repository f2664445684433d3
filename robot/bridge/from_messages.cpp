#include "robot/bridge/from_messages.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "robot/bridge/player_map.h"
#include "sim/agent/roles.h"
#include "sim/math/vec2.h"
#include "sim/referee/referee.h"

namespace robot::bridge {
namespace {

using sim::Tick;
using sim::Vec2;
using Phase = sim::agent::Game::Phase;
using SetPlay = sim::agent::Game::SetPlay;
using Doing = sim::Body::Doing;

constexpr float kVelocityDeviation = 0.3f;  // [m/s] assumed when the filter reports none
constexpr float kSameOpponent = 1;          // [m] a robot seen nearer to a known one is the same robot

/// Counts in game time. A simulation may run faster or slower than real time.
class Time {
 public:
  explicit Time(const Recollection& from) : now_ns_(from.now_ns), speed_(from.speed), now_(from.now) {}

  /// Returns the time from `then_ns` to `later_ns` [ticks], at most an hour.
  Tick between(std::uint64_t then_ns, std::uint64_t later_ns) const {
    const double seconds = later_ns > then_ns ? static_cast<double>(later_ns - then_ns) / 1e9 : 0;
    return static_cast<Tick>(std::min(30 * speed_ * seconds + kRounding, 30 * 3600.));
  }
  /// Returns the tick of `then_ns`, where the present is `from.now`.
  Tick tick_of(std::uint64_t then_ns) const { return now_ - between(then_ns, now_ns_); }

 private:
  static constexpr double kRounding = 1e-3;  // [ticks] capture times are whole nanoseconds

  const std::uint64_t now_ns_;
  const double speed_;
  const Tick now_;
};

float finite(float value, float otherwise = 0) { return std::isfinite(value) ? value : otherwise; }

sim::Pose2 pose_of(const pb::Pose& pose) {
  return {{finite(pose.x()), finite(pose.y())}, sim::normalized(finite(pose.heading()))};
}

sim::agent::Ball ball_of(const pb::Ball& told, const Time& time) {
  sim::agent::Ball ball;
  ball.position = {finite(told.x()), finite(told.y())};
  ball.velocity = {finite(told.velocity_x()), finite(told.velocity_y())};
  ball.variance = finite(told.deviation() * told.deviation(), 1);
  const float velocity = told.has_velocity_deviation() ? finite(told.velocity_deviation(), 1) : kVelocityDeviation;
  ball.velocity_variance = velocity * velocity;
  ball.heat = std::clamp(finite(told.heat()), 0.f, 1.f);
  if (told.seen_ns() != 0) ball.seen = time.tick_of(told.seen_ns());
  ball.visible = told.visible();
  ball.frames = static_cast<std::uint8_t>(
      std::min(told.visible() ? told.frames_visible() : told.frames_missing(), std::uint32_t{255}));
  return ball;
}

sim::agent::Role role_of(std::string_view name) {
  for (int i = 0; i < sim::agent::kRoleCount; ++i)
    if (const auto role = static_cast<sim::agent::Role>(i); name == sim::agent::name_of(role)) return role;
  return sim::agent::Role::supporter;
}

sim::agent::Mate mate_of(const pb::Teammate& told, const Time& time) {
  sim::agent::Mate mate;
  if (!told.has_pose()) return mate;
  const std::uint64_t sent_ns = told.sent_ns() != 0 ? told.sent_ns() : told.received_ns();
  mate.pose = pose_of(told.pose());
  mate.time_to_ball_cs =
      sim::agent::centiseconds(std::max(told.has_time_to_ball() ? finite(told.time_to_ball(), 1e6f) : 1e6f, 0.f));
  mate.sent = time.tick_of(sent_ns);
  mate.role = static_cast<std::uint8_t>(role_of(told.role()));
  mate.active = told.active();
  if (!told.has_ball() || told.ball().seen_ns() == 0) return mate;
  const Vec2 ball{finite(told.ball().x()), finite(told.ball().y())};
  mate.ball = mate.pose.position + sim::turned(ball, sim::direction(mate.pose.heading));
  mate.ball_age = static_cast<std::uint16_t>(std::min<Tick>(time.between(told.ball().seen_ns(), sent_ns), 0xfffe));
  return mate;
}

Phase phase_of(const pb::GameState& game) {
  switch (game.state()) {
    case pb::GameState::STATE_READY: return Phase::ready;
    case pb::GameState::STATE_SET: return Phase::set;
    // while play is stopped, robots stand still as in SET
    case pb::GameState::STATE_PLAYING: return game.stopped() ? Phase::set : Phase::playing;
    case pb::GameState::STATE_FINISHED: return Phase::finished;
    default: return Phase::initial;
  }
}

/// Returns the simulator's set play that is nearest to the real one: the others must not touch the ball.
SetPlay set_play_of(const pb::GameState& game) {
  switch (game.set_play()) {
    case pb::GameState::SET_PLAY_GOAL_KICK: return SetPlay::goal_kick;
    case pb::GameState::SET_PLAY_CORNER_KICK: return SetPlay::corner_kick;
    case pb::GameState::SET_PLAY_KICK_IN:
    case pb::GameState::SET_PLAY_THROW_IN:
    case pb::GameState::SET_PLAY_PUSHING_FREE_KICK:
    case pb::GameState::SET_PLAY_DIRECT_FREE_KICK:
    case pb::GameState::SET_PLAY_INDIRECT_FREE_KICK:
    case pb::GameState::SET_PLAY_PENALTY_KICK: return SetPlay::kick_in;
    default: break;
  }
  // the GameController does not call a kick-off a set play; its ball is free at the end of the countdown
  const bool coming = game.state() == pb::GameState::STATE_READY || game.state() == pb::GameState::STATE_SET;
  const bool on =
      game.state() == pb::GameState::STATE_PLAYING && game.secondary_seconds() > 0 && game.has_kicking_team();
  return coming || on ? SetPlay::kick_off : SetPlay::none;
}

/// Returns the time since the phase or set play began [s], by its countdown, or 0 without a countdown.
float since_phase(const pb::GameState& told, const sim::agent::Game& game, const sim::field::Rules& rules) {
  const float left = finite(told.secondary_seconds());
  if (left <= 0) return 0;
  return std::max(sim::referee::countdown_of(rules, game.phase, game.set_play) - left, 0.f);
}

std::uint8_t byte_of(std::uint32_t value) { return static_cast<std::uint8_t>(std::min<std::uint32_t>(value, 255)); }

sim::agent::Game game_of(const pb::GameState& told, int place, const sim::field::Rules& rules) {
  sim::agent::Game game;
  game.phase = phase_of(told);
  game.set_play = set_play_of(told);
  game.own_kick = told.has_kicking_team() && told.kicking_team() == told.own_team();
  game.player = static_cast<std::uint8_t>(place);
  game.players = byte_of(told.players_per_team());
  game.half = byte_of(std::max(told.half(), std::uint32_t{1}));
  game.own_score = byte_of(told.own().score());
  game.opponent_score = byte_of(told.opponent().score());
  game.remaining = std::clamp(finite(told.seconds_remaining()), 0.f, 36'000.f);
  game.since_phase = since_phase(told, game, rules);
  const int own = static_cast<int>(told.own_player()) - 1;
  game.penalised = own >= 0 && own < told.own().players_size() && told.own().players(own).penalised();
  return game;
}

void take_away(const pb::TeamState& team, const PlayerMap& lineup, int places, Tick (&away)[sim::kMaxPlayers]) {
  for (int place = 1; place <= places; ++place) {
    const auto number = static_cast<int>(lineup.player_at(place));
    if (number == 0) away[place - 1] = sim::kNever;
    if (number == 0 || number > team.players_size()) continue;
    const pb::PlayerState& player = team.players(number - 1);
    if (!player.penalised()) continue;
    const bool returns = player.penalty() != pb::PlayerState::PENALTY_SUBSTITUTE;
    const float seconds = std::clamp(finite(player.seconds_till_unpenalised()), 0.f, 3600.f);
    away[place - 1] = returns ? std::max<Tick>(sim::ticks(seconds), 1) : sim::kNever;
  }
}

/// Gives each seen opponent a place: by its number if known, else that of the nearest known opponent, else a free one.
class Opponents {
 public:
  Opponents(const PlayerMap& lineup, sim::agent::Opponent (&places)[sim::kMaxPlayers])
      : lineup_(lineup), places_(places) {}

  /// Returns the place, or -1 if there is none.
  int add(Vec2 position, Tick seen, std::uint32_t player = 0) {
    if (!std::isfinite(position.x) || !std::isfinite(position.y)) return -1;
    const int known_place = lineup_.place_of(player);
    const int place = known_place != 0 ? known_place - 1 : place_near(position);
    if (place < 0) return place;
    sim::agent::Opponent& known = places_[place];
    if (known.seen == sim::kNever || seen >= known.seen) known = {position, seen};
    return place;
  }

 private:
  int place_near(Vec2 position) const {
    int nearest = -1, free = -1;
    float best = kSameOpponent;
    // the first place is the keeper's: it is used last
    for (int i = sim::kMaxPlayers - 1; i >= 0; --i) {
      if (places_[i].seen == sim::kNever) {
        if (i > 0 || free < 0) free = i;
      } else if (const float apart = sim::distance(places_[i].position, position); apart < best) {
        best = apart;
        nearest = i;
      }
    }
    return nearest >= 0 ? nearest : free;
  }

  const PlayerMap& lineup_;
  sim::agent::Opponent (&places_)[sim::kMaxPlayers];
};

void see_opponents(const Recollection& from, const PlayerMap& lineup, sim::foresight::Knowledge& knowledge) {
  const Time time(from);
  const sim::Pose2& own = knowledge.beliefs.pose.pose;
  Opponents opponents(lineup, knowledge.beliefs.opponents);
  if (from.opponents)
    for (const pb::Opponents::Opponent& told : from.opponents->value.opponents())
      opponents.add({told.x(), told.y()}, time.tick_of(told.seen_ns()), told.player());
  if (!from.vision) return;
  for (const pb::VisualRobot& robot : from.vision->value.robots()) {
    if (robot.side() == pb::VisualRobot::SIDE_OWN) continue;
    const Vec2 at{robot.detection().x(), robot.detection().y()};
    const std::uint32_t player = robot.side() == pb::VisualRobot::SIDE_OPPONENT ? robot.player() : 0;
    const Tick seen = time.tick_of(from.vision->capture_ns);
    const int place = opponents.add(own.position + sim::turned(at, sim::direction(own.heading)), seen, player);
    if (place >= 0 && robot.fallen()) knowledge.down[1][place] = seen;
  }
}

sim::Lying lying_of(pb::MotionStatus::FallSide side) {
  switch (side) {
    case pb::MotionStatus::FALL_SIDE_FRONT: return sim::Lying::on_front;
    case pb::MotionStatus::FALL_SIDE_LEFT: return sim::Lying::on_left;
    case pb::MotionStatus::FALL_SIDE_RIGHT: return sim::Lying::on_right;
    default: return sim::Lying::on_back;
  }
}

/// Returns the body in its present action.
sim::Body body_of(const pb::MotionStatus& status, const sim::motion::Model& model, Tick now) {
  sim::Body body;
  body.since = now;
  const bool gets_up = status.fall() == pb::MotionStatus::FALL_GETTING_UP;
  if (gets_up || status.fall() == pb::MotionStatus::FALL_FALLEN || status.fall() == pb::MotionStatus::FALL_FALLING) {
    body.doing = gets_up ? Doing::getting_up : Doing::fallen;
    body.kind = static_cast<std::uint8_t>(lying_of(status.fall_side()));
    return body;
  }
  for (int kick = 0; kick < model.kick_count; ++kick) {
    if (status.running() != model.kicks[kick].name) continue;
    const float elapsed = std::clamp(model.kicks[kick].duration - finite(status.remaining()), 0.f, 10.f);
    body.doing = Doing::kicking;
    body.kind = static_cast<std::uint8_t>(kick);
    body.since = now - sim::ticks(elapsed);
    body.kick_done = elapsed >= model.kicks[kick].delay;
    return body;
  }
  if (!status.walking()) return body;
  body.doing = Doing::walking;
  const auto within = [](float value, float limit) { return std::clamp(finite(value), -limit, limit); };
  body.velocity = {within(status.velocity_x(), model.walk.forward), within(status.velocity_y(), model.walk.sideward)};
  body.turn_rate = within(status.turn_rate(), model.walk.turn_rate);
  body.step_velocity = body.velocity;
  body.step_turn_rate = body.turn_rate;
  return body;
}

}  // namespace

const char* why_no_soccer(const pb::GameState& game) {
  if (game.phase() == pb::GameState::PHASE_PENALTY_SHOOT_OUT) return "the game is in a penalty shoot-out";
  return game.phase() == pb::GameState::PHASE_TIMEOUT ? "the game is in a time-out" : nullptr;
}

Moment moment_of(const memory::Channels& channels, std::uint64_t now_ns) {
  const auto simulation = simulation_of(channels);
  return {now_ns, simulation && simulation->value.speed() > 0 ? double{simulation->value.speed()} : 1};
}

Recollection recollect(const memory::Channels& channels, const std::string& robot, std::uint64_t now_ns) {
  Recollection recollection{.now_ns = now_ns};
  Recollection::visit(recollection, [&](const char* name, auto& object) {
    using Message = decltype(object->value);
    object = newest<Message>(channels, "/" + robot + "/" + name);
    if (object && Moment{now_ns}.is_before(object->capture_ns)) object.reset();
  });
  recollection.speed = moment_of(channels, now_ns).speed;
  return recollection;
}

Result<sim::foresight::Knowledge> knowledge_of(const Recollection& from, const sim::Params& params) {
  if (!from.game) return Error{"the robot does not know of a game: there is no object game yet"};
  if (const char* const why = why_no_soccer(from.game->value)) return Error{why};
  if (!from.pose) return Error{"the robot does not know where it is: there is no object pose yet"};
  const std::uint64_t pose_ns = from.pose->capture_ns;
  const Time time(from);
  const Tick pose_age = time.between(pose_ns, from.now_ns);
  if (pose_age > sim::ticks(kStalePose))
    return Error{"the robot does not know where it is: its pose is " + std::to_string(pose_age / 30) + " s old"};
  const PlayerMaps lineups(from.game->value, params.rules.players);
  const int own = lineups.own.place_of(from.game->value.own_player());
  if (own == 0)
    return Error{"player " + std::to_string(from.game->value.own_player()) + " does not play: players are " +
                 lineups.own.text()};
  sim::foresight::Knowledge knowledge{.now = from.now, .game = game_of(from.game->value, own, params.rules)};
  sim::agent::Beliefs& beliefs = knowledge.beliefs;
  const pb::Pose& pose = from.pose->value;
  beliefs.pose = {pose_of(pose), std::max(pose.deviation_x(), pose.deviation_y()), finite(pose.deviation_heading(), 2)};
  if (from.ball) beliefs.ball = ball_of(from.ball->value, time);
  if (from.team)
    for (const pb::Teammate& told : from.team->value.teammates()) {
      const int place = lineups.own.place_of(told.player());
      if (place == 0 || place == own) continue;
      const sim::agent::Mate mate = beliefs.mates[sim::agent::index_of_mate(own, place)] = mate_of(told, time);
      if (told.fallen() && mate.sent != sim::kNever) knowledge.down[0][place - 1] = mate.sent;
    }
  see_opponents(from, lineups.opponents, knowledge);
  take_away(from.game->value.own(), lineups.own, params.rules.players, knowledge.away[0]);
  take_away(from.game->value.opponent(), lineups.opponents, params.rules.players, knowledge.away[1]);
  if (from.motion) knowledge.body = body_of(from.motion->value, params.teams[0].models_of(own).motion, from.now);
  if (from.decision) knowledge.mind.role = role_of(from.decision->value.role());
  knowledge.mind.role_since = knowledge.mind.leaf_since = from.now;
  return knowledge;
}

}  // namespace robot::bridge
