#include "robot/foresight/triggers.h"

#include <algorithm>

#include "robot/bridge/player_map.h"
#include "sim/math/vec2.h"

namespace robot::foreseeing {
namespace {

using sim::Vec2;

// times are game time
constexpr std::uint64_t kBallLostNs = 4'000'000'000;
constexpr std::uint64_t kFreshNs = 3'000'000'000;  // [ns] an opponent seen within this time is still near that place
constexpr float kKickWay = 1.5f;                   // [m] free way in front of the ball for a kick
constexpr float kBeside = 0.35f;                   // [m] from the middle of the way: a robot's and the ball's width

bool is_on_way(Vec2 ball, Vec2 opponent, Vec2 goal) {
  const Vec2 to_goal = goal - ball;
  const float far = sim::length(to_goal);
  if (far == 0) return false;
  const Vec2 off = sim::turned_back(opponent - ball, (1 / far) * to_goal);
  return off.x > 0 && off.x < std::min(kKickWay, far) && off.y > -kBeside && off.y < kBeside;
}

bool in_game(const pb::GameState& game) {
  return !bridge::why_no_soccer(game) &&
         (game.state() == pb::GameState::STATE_READY || game.state() == pb::GameState::STATE_SET ||
          game.state() == pb::GameState::STATE_PLAYING);
}

}  // namespace

int captain_of(const pb::GameState& game) {
  const pb::TeamState& own = game.own();
  const auto keeper = static_cast<int>(bridge::keeper_of(own));
  for (int i = 0; i < own.players_size(); ++i)
    if (i + 1 != keeper && !own.players(i).penalised()) return i + 1;
  return 0;
}

bool way_is_blocked(const bridge::Recollection& now, float goal_x) {
  if (!now.pose || !now.ball || !now.opponents) return false;
  const pb::Pose& pose = now.pose->value;
  const Vec2 ball = Vec2{pose.x(), pose.y()} + sim::turned({now.ball->value.x(), now.ball->value.y()},
                                                           sim::direction(sim::normalized(pose.heading())));
  return std::ranges::any_of(now.opponents->value.opponents(), [&](const pb::Opponents::Opponent& opponent) {
    return bridge::Moment{now.now_ns, now.speed}.since(opponent.seen_ns()) < kFreshNs &&
           is_on_way(ball, {opponent.x(), opponent.y()}, {goal_x, 0});
  });
}

const char* Triggers::look(const bridge::Recollection& now, std::uint64_t period_ns) {
  if (!now.game) return nullptr;
  const pb::GameState& game = now.game->value;
  const bridge::Moment moment{now.now_ns, now.speed};
  if (moment.is_before(seen_ns_)) seen_ = answered_ = {}, asked_ns_ = 0;
  seen_ns_ = now.now_ns;
  seen_ = {.state = game.state(),
           .set_play = game.set_play(),
           .own_score = game.own().score(),
           .opponent_score = game.opponent().score(),
           .ball_lost = !now.ball || moment.since(now.ball->value.seen_ns()) > kBallLostNs,
           .blocked = way_is_blocked(now, goal_x_)};
  if (!in_game(game) || captain_of(game) != static_cast<int>(game.own_player())) {
    answered_ = seen_;
    return nullptr;
  }
  if (!seen_.blocked) answered_.blocked = false;
  const std::uint64_t since_ns = moment.since(asked_ns_);
  if (asked_ns_ != 0 && since_ns < kLeastApartNs) return nullptr;
  if (seen_.own_score != answered_.own_score || seen_.opponent_score != answered_.opponent_score)
    return "the score changed";
  if (seen_.state != answered_.state || seen_.set_play != answered_.set_play) return "the game was stopped or goes on";
  if (seen_.ball_lost != answered_.ball_lost) return seen_.ball_lost ? "the ball is lost" : "the ball is found";
  if (seen_.blocked && !answered_.blocked) return "the way is blocked";
  return asked_ns_ == 0 || since_ns >= period_ns ? "it is time" : nullptr;
}

void Triggers::asked() {
  answered_ = seen_;
  asked_ns_ = seen_ns_;
}

}  // namespace robot::foreseeing
