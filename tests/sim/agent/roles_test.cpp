#include "sim/agent/roles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

/// A team whose robots see the same ball and know exactly where the others are.
struct Team {
  int players = 4;
  Vec2 ball{0.5f, 0.3f};
  std::vector<Scene> robots;

  explicit Team(std::mt19937& random, int count) : players(count), robots(static_cast<std::size_t>(count)) {
    std::uniform_real_distribution<float> x(-3, 3), y(-2, 2), heading(-3, 3);
    for (int i = 0; i < players; ++i) {
      Scene& robot = at(i + 1);
      robot.game.players = static_cast<std::uint8_t>(players);
      robot.game.player = static_cast<std::uint8_t>(i + 1);
      robot.beliefs.pose.pose = {{x(random), y(random)}, heading(random)};
    }
  }
  Scene& at(int player) { return robots[static_cast<std::size_t>(player - 1)]; }

  void look() {
    for (Scene& robot : robots) robot.see_ball(robot.view().to_robot(ball));
  }
  /// Sends all messages to all.
  void talk() {
    for (Scene& receiver : robots)
      for (Scene& sender : robots)
        if (sender.game.player != receiver.game.player)
          receiver.hear(sender.game.player, sender.beliefs.pose.pose.position, time_to_ball(sender.view()),
                        sender.mind.role);
  }
  void settle() {
    std::vector<Mind> minds;
    for (Scene& robot : robots) {
      assign_role(robot.view(), minds.emplace_back(robot.mind));
    }
    for (int i = 1; i <= players; ++i) at(i).mind = minds[static_cast<std::size_t>(i - 1)];
  }
  int count(Role role) {
    return static_cast<int>(std::count_if(robots.begin(), robots.end(), [&](auto& r) { return r.mind.role == role; }));
  }
};

TEST(Roles, AMessageFromBeforeTheSetPlayTellsOfAnotherBall) {
  Scene scene;
  scene.game.set_play = Game::SetPlay::corner_kick;
  scene.game.own_kick = true;
  scene.game.since_phase = 2;
  scene.see_ball({1, 0});
  // the mate was next to the ball when it went out, and is far from it now
  for (const float ago : {3.f, 1.f}) {
    scene.mind.role = Role::supporter;
    scene.hear(3, {-2.5f, -1.5f}, 0.5f, Role::chaser, ago);
    assign_role(scene.view(), scene.mind);
    EXPECT_EQ(scene.mind.role == Role::chaser, ago > 2) << ago;
  }
}

TEST(Roles, TheRobotInTheCircleTakesTheKickOffThoughAMateWasTheChaserBefore) {
  Scene scene;
  scene.game.set_play = Game::SetPlay::kick_off;
  scene.game.own_kick = true;
  scene.game.since_phase = 0.1f;
  scene.beliefs.pose.pose.position = {-0.4f, 0};
  scene.see_ball({0.4f, 0});
  scene.hear(3, {-2.5f, -1.5f}, 0.5f, Role::chaser, 2);
  assign_role(scene.view(), scene.mind);
  EXPECT_EQ(scene.mind.role, Role::chaser);
}

TEST(Roles, OfTwoThatSayThatTheyChaseTheLowerNumberKeepsTheBallUnlessTheOtherIsFarQuicker) {
  for (const float lead : {2.f, 4.5f})
    for (const int own : {2, 4}) {
      Scene scene;
      scene.game.player = static_cast<std::uint8_t>(own);
      scene.mind.role = Role::chaser;
      scene.see_ball({3, 0});
      scene.hear(3, {}, time_to_ball(scene.view()) - lead, Role::chaser);
      assign_role(scene.view(), scene.mind);
      EXPECT_EQ(scene.mind.role == Role::chaser, own < 3 && lead < 4) << lead << " " << own;
    }
}

TEST(Roles, AChaserComesNearerWhileItIsSilentButLessThanItsTimePasses) {
  // a mate said 8 s ago that it needs 10 s: 6 s are left, not 2 s
  for (const float own_way : {0.6f, 1.4f}) {
    Scene scene;
    scene.see_ball({own_way, 0});
    const float own = time_to_ball(scene.view());
    ASSERT_TRUE(own < 6 - 1 || own > 6) << "the hysteresis of the chaser decides between";
    scene.hear(3, {}, 10, Role::chaser, 8);
    assign_role(scene.view(), scene.mind);
    EXPECT_EQ(scene.mind.role == Role::chaser, own < 5) << own;
  }
}

TEST(Roles, ThereIsExactlyOneChaserWhenBeliefsAgree) {
  std::mt19937 random(1);
  for (int n = 0; n < 500; ++n) {
    Team team(random, 2 + n % 6);
    for (int round = 0; round < 3; ++round) {
      team.look();
      team.talk();
      team.settle();
      EXPECT_EQ(team.count(Role::keeper), 1);
      EXPECT_EQ(team.count(Role::chaser), 1);
      EXPECT_EQ(team.at(1).mind.role, Role::keeper);
      // half of the others defend, rounded up
      const int others = team.players - 2;
      EXPECT_EQ(team.count(Role::defender), (others + 1) / 2);
      EXPECT_EQ(team.count(Role::supporter), others / 2);
    }
  }
}

TEST(Roles, TheChaserIsTheQuickestAndDefendersAreThoseFarthestBack) {
  std::mt19937 random(2);
  for (int n = 0; n < 500; ++n) {
    Team team(random, 7);
    for (Scene& robot : team.robots) robot.settings.roles.hysteresis = robot.settings.roles.order_keep = 0;
    team.look();
    team.talk();
    team.settle();
    float chaser = 0, quickest = 1e6f, defender = -10, supporter = 10;
    for (Scene& robot : team.robots) {
      const float time = time_to_ball(robot.view()), x = robot.view().position.x;
      if (robot.mind.role == Role::keeper) continue;
      quickest = std::min(quickest, time);
      if (robot.mind.role == Role::chaser) chaser = time;
      if (robot.mind.role == Role::defender) defender = std::max(defender, x);
      if (robot.mind.role == Role::supporter) supporter = std::min(supporter, x);
    }
    EXPECT_EQ(chaser, quickest);
    EXPECT_LE(defender, supporter);
  }
}

TEST(Roles, LanesOfARoleAreInOrderFromRightToLeftAndCentred) {
  std::mt19937 random(3);
  for (int n = 0; n < 300; ++n) {
    Team team(random, 7);
    team.look();
    team.talk();
    team.settle();
    for (const Role role : {Role::supporter, Role::defender}) {
      float sum = 0;
      for (Scene& robot : team.robots)
        for (Scene& other : team.robots) {
          if (robot.mind.role != role || other.mind.role != role) continue;
          if (&robot == &other) sum += lane_of(robot.mind);
          EXPECT_TRUE(!(robot.view().position.y < other.view().position.y) ||
                      lane_of(robot.mind) <= lane_of(other.mind) - 1);
        }
      EXPECT_EQ(sum, 0);
    }
  }
}

TEST(Roles, NoiseDoesNotMakeThemAlternate) {
  const auto changes_per_minute = [](float hysteresis) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> noise(-0.12f, 0.12f);
    Team team(random, 4);
    // players 2 and 3 are equally near
    team.at(2).beliefs.pose.pose = {{-0.5f, 0.8f}, 0};
    team.at(3).beliefs.pose.pose = {{-0.5f, -0.2f}, 0};
    int changes = 0;
    for (int second = 0; second < 120; ++second) {
      for (Scene& robot : team.robots) {
        robot.settings.roles.hysteresis = hysteresis;
        robot.now += 30;
        robot.see_ball(robot.view().to_robot(team.ball + Vec2{noise(random), noise(random)}));
      }
      if (second % 3 == 0) team.talk();
      const Role before = team.at(2).mind.role;
      team.settle();
      changes += second > 0 && team.at(2).mind.role != before;
    }
    return 0.5f * static_cast<float>(changes);
  };
  EXPECT_LT(changes_per_minute(1.5f), 2);
  EXPECT_GT(changes_per_minute(0), 5);
}

TEST(Roles, StaleOrRemovedRobotsAreIgnored) {
  Scene scene;
  scene.hear(3, {1, 0}, 0.5f, Role::supporter);
  assign_role(scene.view(), scene.mind);
  EXPECT_NE(scene.mind.role, Role::chaser);
  scene.beliefs.mates[1].active = false;
  assign_role(scene.view(), scene.mind);
  EXPECT_EQ(scene.mind.role, Role::chaser);
  scene.hear(3, {1, 0}, 0.5f, Role::supporter, 20);
  assign_role(scene.view(), scene.mind);
  EXPECT_EQ(scene.mind.role, Role::chaser);
}

TEST(Roles, TimeToBallGrowsWithTheWayAndWithFacingAway) {
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n) {
    Scene scene = random_scene(random);
    if (!scene.view().ball_known || scene.view().ball_distance < 0.1f) continue;
    // straight behind the ball and facing it is quickest
    Scene best = scene;
    const View view = scene.view();
    const Vec2 to_goal = unit(view.goal() - view.ball_in_team);
    best.beliefs.pose.pose = {view.ball_in_team - view.ball_distance * to_goal, angle_of(to_goal)};
    best.beliefs.ball.seen = best.now;
    best.beliefs.ball.position = best.view().to_robot(view.ball_in_team);
    EXPECT_LE(time_to_ball(best.view()), time_to_ball(view) + 1e-3f);
    EXPECT_NEAR(time_to_ball(best.view()), view.ball_distance / surroundings().motion->walk.forward, 1e-2);
  }
}

}  // namespace
}  // namespace sim::agent
