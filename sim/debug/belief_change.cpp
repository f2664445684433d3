#include "sim/debug/belief_change.h"

#include <cmath>
#include <functional>
#include <random>

#include "robot/core/text.h"
#include "sim/agent/roles.h"
#include "sim/math/angles.h"

namespace sim::debug {
namespace {

using robot::formatted;

constexpr int kSamplesOfOne = 600, kSamplesOfTwo = 250;
constexpr int kHalvings = 12;        // of the last shrinking: to a thousandth
constexpr std::size_t kShrunk = 20;  // changes of one search that are shrunk
constexpr int kMostNumbers = 3;      // of one belief

/// A belief that can be changed by a few numbers; 0 changes nothing.
struct Belief {
  int numbers = 0;
  float most[kMostNumbers] = {};   // largest change
  float scale[kMostNumbers] = {};  // a change as large as 1 m
  std::function<void(Decision&, const float*)> change;
  std::function<std::string(const Decision& before, const Decision& after)> text;
};

/// A changed belief.
struct Edit {
  const Belief* belief;
  float by[kMostNumbers] = {};
};

double metres(float value) { return static_cast<double>(value); }

std::string moved(const std::string& what, Vec2 before, Vec2 after) {
  return what + formatted(" at (%.2f, %.2f) m instead of (%.2f, %.2f) m", metres(after.x), metres(after.y),
                          metres(before.x), metres(before.y));
}
std::string aged(const std::string& what, Tick now, Tick before, Tick after) {
  if (before == kNever) return what + formatted(" seen %.1f s ago instead of never", metres(age(now, after)));
  return what + formatted(" seen %.1f s ago instead of %.1f s", metres(age(now, after)), metres(age(now, before)));
}

Belief ball_place() {
  return {2,
          {6, 6},
          {1, 1},
          [](Decision& d, const float* by) {
            d.beliefs.ball.position = d.beliefs.ball.position + Vec2{by[0], by[1]};
          },
          [](const Decision& a, const Decision& b) {
            return moved("ball, as the robot sees it,", a.beliefs.ball.position, b.beliefs.ball.position);
          }};
}
Belief ball_speed() {
  return {2,
          {3, 3},
          {1, 1},
          [](Decision& d, const float* by) {
            d.beliefs.ball.velocity = d.beliefs.ball.velocity + Vec2{by[0], by[1]};
          },
          [](const Decision& a, const Decision& b) {
            const Vec2 before = a.beliefs.ball.velocity, after = b.beliefs.ball.velocity;
            return formatted("ball rolls (%.2f, %.2f) m/s instead of (%.2f, %.2f) m/s", metres(after.x),
                             metres(after.y), metres(before.x), metres(before.y));
          }};
}
Belief ball_age(const Decision& decision) {
  // the new age is the present one and the change, never negative; a ball never seen begins with the age 0
  const float now = decision.beliefs.ball.seen == kNever ? 0 : age(decision.tick, decision.beliefs.ball.seen);
  return {1,
          {20},
          {1},
          [now](Decision& d, const float* by) {
            agent::Ball& ball = d.beliefs.ball;
            const Tick ago = ticks(std::max(0.f, now + by[0]));
            if (by[0] == 0 && ball.seen != kNever) return;
            ball.seen = ago < d.tick ? d.tick - ago : 0;
            ball.visible = ago == 0;
          },
          [](const Decision& a, const Decision& b) {
            return aged("ball", a.tick, a.beliefs.ball.seen, b.beliefs.ball.seen);
          }};
}
Belief own_pose() {
  return {3,
          {6, 6, 3.1f},
          {1, 1, 0.35f},
          [](Decision& d, const float* by) {
            Pose2& pose = d.beliefs.pose.pose;
            pose = {pose.position + Vec2{by[0], by[1]}, normalized(pose.heading + by[2])};
          },
          [](const Decision& a, const Decision& b) {
            const Pose2 before = a.beliefs.pose.pose, after = b.beliefs.pose.pose;
            return moved("own pose", before.position, after.position) +
                   formatted(", turned by %.0f deg", metres(kDegrees * normalized(after.heading - before.heading)));
          }};
}
Belief heat() {
  return {1,
          {1},
          {1},
          [](Decision& d, const float* by) {
            d.beliefs.ball.heat = std::min(1.f, std::max(0.f, d.beliefs.ball.heat + by[0]));
          },
          [](const Decision& a, const Decision& b) {
            return formatted("ball_heat %.2f instead of %.2f", metres(b.beliefs.ball.heat),
                             metres(a.beliefs.ball.heat));
          }};
}
Belief role() {
  return {1,
          {3},
          {1},
          [](Decision& d, const float* by) {
            const int step = static_cast<int>(std::abs(std::round(by[0])));
            if (step == 0) return;
            d.mind.role = static_cast<agent::Role>((static_cast<int>(d.mind.role) + step) % agent::kRoleCount);
            // it is not assigned anew in this decision
            d.mind.settled = static_cast<std::uint8_t>(d.tick);
            if (d.mind.leaf == agent::kNoLeaf) d.mind.leaf = 0;
          },
          [](const Decision&, const Decision& b) { return std::string("role ") + name_of(b.mind.role); }};
}
Belief teammate(const Decision& decision, int index) {
  const std::string name = "teammate " + std::to_string(agent::player_of_mate(decision.game.player, index));
  return {3,
          {6, 6, 10},
          {1, 1, 1},
          [index](Decision& d, const float* by) {
            agent::Mate& mate = d.beliefs.mates[index];
            if (by[0] == 0 && by[1] == 0 && by[2] == 0) return;
            if (mate.sent == kNever) mate.sent = d.tick;
            mate.active = true;
            mate.pose.position = mate.pose.position + Vec2{by[0], by[1]};
            mate.time_to_ball_cs = agent::centiseconds(std::max(0.f, mate.time_to_ball() + by[2]));
          },
          [index, name](const Decision& a, const Decision& b) {
            const agent::Mate &before = a.beliefs.mates[index], &after = b.beliefs.mates[index];
            return moved(name, before.pose.position, after.pose.position) +
                   formatted(", %.1f s from the ball", metres(after.time_to_ball()));
          }};
}
Belief opponent(int index) {
  const std::string name = "opponent " + std::to_string(index + 1);
  return {2,
          {6, 6},
          {1, 1},
          [index](Decision& d, const float* by) {
            agent::Opponent& other = d.beliefs.opponents[index];
            if (by[0] == 0 && by[1] == 0) return;
            other = {other.position + Vec2{by[0], by[1]}, d.tick};
          },
          [index, name](const Decision& a, const Decision& b) {
            return moved(name, a.beliefs.opponents[index].position, b.beliefs.opponents[index].position) +
                   ", just seen";
          }};
}

class Search {
 public:
  Search(const Params& params, const agent::Tree& tree, const Decision& decision, const Goal& goal)
      : params_(params), tree_(tree), decision_(decision), goal_(goal) {
    beliefs_ = {ball_place(), ball_speed(), ball_age(decision), own_pose(), heat(), role()};
    for (int i = 0; i + 1 < decision.game.players; ++i) beliefs_.push_back(teammate(decision, i));
    for (int i = 0; i < decision.game.players; ++i) beliefs_.push_back(opponent(i));
  }

  std::optional<BeliefChange> run() {
    for (const Belief& belief : beliefs_) sample({{&belief}}, kSamplesOfOne);
    if (best_.empty())
      for (std::size_t i = 0; i < beliefs_.size(); ++i)
        for (std::size_t k = i + 1; k < beliefs_.size(); ++k) sample({{&beliefs_[i]}, {&beliefs_[k]}}, kSamplesOfTwo);
    if (best_.empty()) return {};
    BeliefChange change{.decision = changed(best_), .changes = {}, .size = size_of(best_)};
    for (const Edit& edit : best_) change.changes.push_back(edit.belief->text(decision_, change.decision));
    change.leaf = leaf(change.decision);
    return change;
  }

 private:
  Decision changed(const std::vector<Edit>& edits) const {
    Decision all = decision_;
    for (const Edit& edit : edits) edit.belief->change(all, edit.by);
    return all;
  }

  std::uint16_t leaf(const Decision& decision) const {
    return agent::leaf_of(tree_, Thought(params_, tree_, decision).view());
  }
  bool reaches(const std::vector<Edit>& edits) const { return goal_[leaf(changed(edits))]; }

  static float size_of(const std::vector<Edit>& edits) {
    float size = 0;
    for (const Edit& edit : edits)
      for (int i = 0; i < edit.belief->numbers; ++i) size += std::abs(edit.by[i]) / edit.belief->scale[i];
    return size;
  }

  /// Returns a number in [-1, 1], more often a small one.
  float any() {
    const float flat = static_cast<float>(random_() >> 8) * 0x1p-23f - 1;
    return flat * std::abs(flat);
  }

  void sample(std::vector<Edit> edits, int samples) {
    std::size_t shrunk = 0;
    for (int n = 0; n < samples; ++n) {
      for (Edit& edit : edits)
        for (int i = 0; i < edit.belief->numbers; ++i) edit.by[i] = any() * edit.belief->most[i];
      const bool is_promising = best_.empty() || shrunk < kShrunk || size_of(edits) < size_of(best_);
      if (!is_promising || !reaches(edits)) continue;
      ++shrunk;
      keep(smaller(edits));
    }
  }

  void keep(std::vector<Edit> edits) {
    if (best_.empty() || size_of(edits) < size_of(best_)) best_ = std::move(edits);
  }

  /// Shrinks each number on its own, and then again, as long as the goal is reached.
  std::vector<Edit> smaller(std::vector<Edit> edits) const {
    for (int round = 0; round < 2; ++round)
      for (Edit& edit : edits)
        for (int i = 0; i < edit.belief->numbers; ++i) {
          float& by = edit.by[i];
          float good = by, bad = 0;
          by = 0;
          if (reaches(edits)) continue;
          for (int n = 0; n < kHalvings; ++n) {
            by = 0.5f * (good + bad);
            (reaches(edits) ? good : bad) = by;
          }
          by = good;
        }
    return edits;
  }

  const Params& params_;
  const agent::Tree& tree_;
  const Decision& decision_;
  const Goal& goal_;
  std::vector<Belief> beliefs_;
  std::vector<Edit> best_;
  std::mt19937 random_{1};  // fixed: the same question has the same answer
};

}  // namespace

std::optional<BeliefChange> nearest_beliefs(const Params& params, const agent::Tree& tree, const Decision& decision,
                                            const Goal& goal) {
  if (!agent::plays(decision.game)) return {};
  return Search(params, tree, decision, goal).run();
}

}  // namespace sim::debug
