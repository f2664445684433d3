#include "robot/bridge/game_past.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "sim/io/matchup.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"

namespace robot::bridge {
namespace {

class PastGame {
 public:
  PastGame() : prepared_(*sim::io::prepare({.rules = "spl2012", .pace = sim::Pace::every_tick})) {
    sim::referee::Events events;
    game_.emplace(prepared_.params, GameNames{}, sim::begin(prepared_.params, {3}, events));
    past_.begin(*game_);
    hashes_[now()] = hash_now();
  }

  void play(int ticks) {
    sim::referee::Events events;
    for (int tick = 0; tick < ticks; ++tick) {
      past_.note(*game_);
      game_->tick(events);
      hashes_[now()] = hash_now();
    }
  }
  void go_to(sim::Tick tick) { past_.go_to(tick, *game_); }
  /// Puts the ball elsewhere. Returns whether the edit was kept.
  bool edit(sim::Vec2 ball) {
    game_->change([&](sim::State& state) { state.world.ball.position = ball; });
    hashes_[now()] = hash_now();
    return past_.note_edit(game_->moment());
  }

  sim::Tick now() const { return game_->state().world.tick; }
  std::uint64_t hash_now() const { return sim::hash_of(game_->state()); }
  /// The hash of the newest visit to a tick by play().
  std::uint64_t hash_at(sim::Tick tick) const { return hashes_.at(tick); }
  const SimulatedGame& game() const { return *game_; }

 private:
  sim::io::PreparedGame prepared_;
  std::optional<SimulatedGame> game_;
  GamePast past_;
  std::map<sim::Tick, std::uint64_t> hashes_;
};

TEST(GamePast, EachTickOfALongGameComesAgainToTheBit) {
  PastGame game;
  constexpr int kLong = 9000;  // the frames are thinned out twice
  game.play(kLong);
  const sim::Pose2 odometry = game.game().odometry(2);
  for (sim::Tick tick = kLong; tick-- > 0;) {
    if (tick % 7 != 0 && tick > 40) continue;
    game.go_to(tick);
    ASSERT_EQ(game.now(), tick);
    ASSERT_EQ(game.hash_now(), game.hash_at(tick)) << tick;
  }
  game.play(kLong);
  EXPECT_EQ(game.now(), sim::Tick{kLong});
  EXPECT_EQ(game.game().odometry(2).position.x, odometry.position.x);
  EXPECT_EQ(game.game().odometry(2).heading, odometry.heading);
}

TEST(GamePast, TheDecisionsOfTheTickAreKnown) {
  PastGame game;
  game.play(1500);
  int known = 0;
  for (const sim::Tick tick : {1500, 1496, 1200, 999}) {
    game.go_to(tick);
    for (int robot = 0; robot < 3; ++robot) known += game.game().decision(robot) != nullptr;
  }
  EXPECT_GE(known, 6);  // a penalised robot makes none
}

TEST(GamePast, AnotherFutureReplacesTheOldOne) {
  PastGame game;
  game.play(1000);
  game.go_to(500);
  game.play(20);
  game.go_to(510);
  EXPECT_EQ(game.hash_now(), game.hash_at(510));
  game.play(700);
  game.go_to(900);
  EXPECT_EQ(game.hash_now(), game.hash_at(900));
}

TEST(GamePast, AnEditComesAgain) {
  PastGame game;
  game.play(1000);
  // with and without a key frame at that tick, and at the beginning
  for (const sim::Tick tick : {800, 803, 0}) {
    game.go_to(tick);
    ASSERT_TRUE(game.edit({1, 0.5f}));
    game.play(2000);
    for (const sim::Tick later : {tick, tick + 1, tick + 5, tick + 900}) {
      game.go_to(later);
      EXPECT_EQ(game.hash_now(), game.hash_at(later)) << tick << ", " << later;
    }
    game.go_to(tick + 2000);
  }
}

TEST(GamePast, SeveralEditsComeAgainAlsoWhenFramesAreThinnedOut) {
  PastGame game;
  for (int i = 0; i < 6; ++i) {
    game.play(1501);
    ASSERT_TRUE(game.edit({0.1f * static_cast<float>(i), 0.5f}));
  }
  game.play(100);
  for (sim::Tick tick = 9100; tick > 700; tick -= 599) {
    game.go_to(tick);
    EXPECT_EQ(game.hash_now(), game.hash_at(tick)) << tick;
  }
}

TEST(GamePast, AnEditIsUndoneBehindIt) {
  PastGame game;
  game.play(1000);
  const std::uint64_t unedited = game.hash_at(900);
  game.go_to(800);
  ASSERT_TRUE(game.edit({1, 0.5f}));
  game.play(100);
  EXPECT_NE(game.hash_now(), unedited);
  game.go_to(799);
  game.play(101);
  EXPECT_EQ(game.hash_now(), unedited);
}

TEST(GamePast, EditsOfOneTickReplaceEachOtherAndThereIsAMost) {
  PastGame game;
  for (std::size_t i = 0; i < GamePast::kEdits; ++i) {
    game.play(1);
    ASSERT_TRUE(game.edit({1, 0.5f}));
    ASSERT_TRUE(game.edit({0.5f, 1}));
  }
  game.play(1);
  EXPECT_FALSE(game.edit({1, 1}));
}

}  // namespace
}  // namespace robot::bridge
