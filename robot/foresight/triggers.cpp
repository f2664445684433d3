#include "robot/foresight/triggers.h"

#include <algorithm>

#include "sim/math/vec2.h"

namespace robot::foreseeing {
namespace {

using sim::Vec2;

constexpr std::uint64_t kBallLostNs = 4'000'000'000;
constexpr std::uint64_t kFreshNs = 3'000'000'000;  // an opponent that was seen since is still about there
constexpr float kKickWay = 1.5f;                   // [m] before the ball that a kick needs free
constexpr float kBeside = 0.35f;                   // [m] from the middle of the way: a robot and the ball's width

bool is_on_way(Vec2 ball, Vec2 opponent) {
  // straight on, towards the others' goal
  const Vec2 off = opponent - ball;
  return off.x > 0 && off.x < kKickWay && off.y > -kBeside && off.y < kBeside;
}

}  // namespace

int captain_of(const pb::GameState& game) {
  const pb::TeamState& own = game.own();
  const int keeper = own.goalkeeper() != 0 ? static_cast<int>(own.goalkeeper()) : 1;
  for (int i = 0; i < own.players_size(); ++i)
    if (i + 1 != keeper && !own.players(i).penalised()) return i + 1;
  return 0;
}

bool way_is_blocked(const Recollection& now) {
  if (!now.pose || !now.ball || !now.opponents) return false;
  const pb::Pose& pose = now.pose->value;
  const Vec2 ball = Vec2{pose.x(), pose.y()} + sim::turned({now.ball->value.x(), now.ball->value.y()},
                                                           sim::direction(sim::normalized(pose.heading())));
  return std::ranges::any_of(now.opponents->value.opponents(), [&](const pb::Opponents::Opponent& opponent) {
    return opponent.seen_ns() + kFreshNs > now.now_ns && is_on_way(ball, {opponent.x(), opponent.y()});
  });
}

const char* Triggers::look(const Recollection& now, std::uint64_t period_ns) {
  if (!now.game) return nullptr;
  const pb::GameState& game = now.game->value;
  const Seen before = last_;
  last_ = {.state = game.state(),
           .set_play = game.set_play(),
           .own_score = game.own().score(),
           .opponent_score = game.opponent().score(),
           .ball_lost = !now.ball || now.ball->value.seen_ns() + kBallLostNs < now.now_ns,
           .blocked = way_is_blocked(now)};
  const bool in_game = game.state() == pb::GameState::STATE_READY || game.state() == pb::GameState::STATE_SET ||
                       game.state() == pb::GameState::STATE_PLAYING;
  if (!in_game || captain_of(game) != static_cast<int>(game.own_player())) return nullptr;
  const std::uint64_t since_ns = now.now_ns > asked_ns_ ? now.now_ns - asked_ns_ : 0;
  if (asked_ns_ != 0 && since_ns < kLeastApartNs) return nullptr;

  const char* why = nullptr;
  if (last_.own_score != before.own_score || last_.opponent_score != before.opponent_score)
    why = "the score changed";
  else if (last_.state != before.state || last_.set_play != before.set_play)
    why = "the game was stopped or goes on";
  else if (last_.ball_lost != before.ball_lost)
    why = last_.ball_lost ? "the ball is lost" : "the ball is found";
  else if (last_.blocked && !before.blocked)
    why = "the way is blocked";
  else if (asked_ns_ == 0 || since_ns >= period_ns)
    why = "it is time";
  if (why) asked_ns_ = now.now_ns;
  return why;
}

}  // namespace robot::foreseeing
