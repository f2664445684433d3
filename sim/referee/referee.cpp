#include "sim/referee/referee.h"

#include "sim/referee/ball_free.h"
#include "sim/referee/corner_kick.h"
#include "sim/referee/counts.h"
#include "sim/referee/global_stuck.h"
#include "sim/referee/goal.h"
#include "sim/referee/goal_kick.h"
#include "sim/referee/half_time.h"
#include "sim/referee/illegal_defender.h"
#include "sim/referee/illegal_kick.h"
#include "sim/referee/illegal_position.h"
#include "sim/referee/kick_in.h"
#include "sim/referee/leaving_field.h"
#include "sim/referee/local_stuck.h"
#include "sim/referee/mercy.h"
#include "sim/referee/placed_back.h"
#include "sim/referee/pushing.h"
#include "sim/referee/ready.h"
#include "sim/referee/returning.h"
#include "sim/referee/set.h"

namespace sim::referee {
namespace {

void judge_ball(Court& court) {
  if (illegal_kick::due(court)) illegal_kick::apply(court);
  if (ball_free::due(court)) ball_free::apply(court);
  if (ball_is_out(court)) {
    const Crossing crossing = crossing_of(court);
    if (goal::due(court, crossing)) {
      goal::apply(court, crossing);
      if (mercy::due(court)) mercy::apply(court);
    } else if (placed_back::due(court, crossing)) {
      placed_back::apply(court, crossing);
    } else if (kick_in::due(court, crossing)) {
      kick_in::apply(court, crossing);
    } else if (goal_kick::due(court, crossing)) {
      goal_kick::apply(court, crossing);
    } else if (corner_kick::due(court, crossing)) {
      corner_kick::apply(court, crossing);
    }
  }
}

void judge_robots(Court& court) {
  local_stuck::watch(court);
  if (local_stuck::due(court)) local_stuck::apply(court);
  for_each_robot(court.world.players, [&](int robot) {
    if (!on_field(court, robot)) return;
    if (pushing::due(court, robot)) {
      pushing::apply(court, robot);
    } else if (illegal_defender::due(court, robot)) {
      illegal_defender::apply(court, robot);
    } else if (illegal_position::due(court, robot)) {
      illegal_position::apply(court, robot);
    }
  });
}

void judge_places(Court& court) {
  for_each_robot(court.world.players, [&](int robot) {
    if (on_field(court, robot) && leaving_field::due(court, robot)) leaving_field::apply(court, robot);
  });
}

void judge_returns(Court& court) {
  for_each_robot(court.world.players, [&](int robot) {
    if (returning::due(court, robot)) returning::apply(court, robot);
  });
}

}  // namespace

void open(const RefereeParams& params, World& world, Book& book, Events& events) {
  GameCounts counts;
  book = Book{};
  Court court{params.rules, params.rules.field, params.ball, params.contact, world, book, counts, events};
  world.players = params.rules.players;
  world.home_attacks = 1;
  world.ball = Ball{};

  // odd players at the left touch line, from the view of their side, even players at the right one
  for_each_robot(world.players, [&](int robot) {
    const float left = attack_sign(world, side_of(robot));
    put_at_touch_line(court, robot, player_of(robot) % 2 == 1 ? left : -left);
  });
  const float toss = uniform(draw(world.key, kNobody, Draw::kick_off, 0)[0]);
  book.first_kick_off = toss < 0.5f ? Side::home : Side::away;
  begin_kick_off(court, book.first_kick_off, world.tick);
}

void judge(const RefereeParams& params, World& world, Book& book, GameCounts& counts, Events& events) {
  if (book.phase == Phase::finished) return;
  Court court{params.rules, params.rules.field, params.ball, params.contact, world, book, counts, events};
  const bool look = world.tick % kLook == 0;

  // the clock
  half_time::run_clock(book);
  if (half_time::due(court)) half_time::apply(court);

  // the ball, and offences of robots
  if (in_play(book)) {
    keep_counts(court);
    judge_ball(court);
  }
  if (in_play(book)) {
    if (look) judge_robots(court);
    if (global_stuck::due(court)) global_stuck::apply(court);
  }

  // before the kick-off
  ready::watch(court);
  if (ready::due(court)) {
    ready::apply(court);
  } else if (set::due(court)) {
    set::apply(court);
  }

  // robots that leave the field and come back
  if (look && book.phase != Phase::finished) judge_places(court);
  if (returning::somebody_waits(court)) judge_returns(court);
  book.ball_before = world.ball.position;
}

}  // namespace sim::referee
