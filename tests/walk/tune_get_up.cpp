// tune_get_up back|front|left|right FIRST_SEED GENERATIONS ROBOTS STEP: searches the key frames of getting up by CMA-ES on
// drawn robots. It begins at those of robot/nao/guardian/get_up.cpp; STEP is the deviation of angles at the beginning
// [degrees]. Each generation meets robots of its own. Prints the mean of each generation as rows for that file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string_view>
#include <vector>

#include "robot/nao/guardian/limiter.h"
#include "robot/nao/motion/leg_joints.h"
#include "tests/walk/arm_joints.h"
#include "tests/walk/drop.h"
#include "tests/walk/physics.h"
#include "tests/walk/search.h"

namespace {

using namespace robot::nao;
using namespace robot::nao::walk;

constexpr float kCycle = 0.012f;           // [s] of LoLA
constexpr int kSteps = 6;                  // of the physics in a cycle
constexpr double kTucks = 1, kLies = 0.6;  // [s] before the motion, as under the guardian
constexpr double kFaceUp = 0.9;            // of a robot that lies on its back
constexpr std::array kOtherSides = {Lying::on_front, Lying::on_left, Lying::on_right};
constexpr double kHolds = 2;      // [s] the last pose
constexpr double kStands = 0.95;  // cosine of the tilt
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kHeight = 0.33;    // [m] of the torso of a robot that stands
constexpr double kWeight = 5;       // [kg] on the feet
constexpr double kLonger = 0.03;    // change of the logarithm of a duration, when an angle changes by a degree
constexpr double kSmoothed = 0.05;  // share of a cycle in the smoothed progress

constexpr std::size_t kRow = kGetUpJoints.size() + 1;  // and the duration

using Motion = std::vector<KeyFrame>;

/// Returns the motion of the guardian, changed by this point [degrees]. The stand at its end does not change.
Motion changed(KeyFrames motion, std::size_t searched, const sim::learn::Vector& point) {
  Motion all(motion.begin(), motion.end());
  for (std::size_t frame = 0; frame < searched; ++frame) {
    const double* const change = &point[frame * kRow];
    for (std::size_t i = 0; i + 1 < kRow; ++i) {
      float& angle = all[frame].position[kGetUpJoints[i]];
      angle = clamp(angle + static_cast<float>(kDegree * change[i]), limits_of(kGetUpJoints[i]).range);
    }
    all[frame].seconds *= static_cast<float>(std::exp(kLonger * change[kRow - 1]));
  }
  return all;
}

/// Plays motions on robots that lie there.
class Judge {
 public:
  explicit Judge(Lying side) : side_(side) {
    for (const bool about_origin : {false, true})
      physics_[about_origin] = std::make_unique<Physics>(Scene{.about_origin = about_origin, .arms = true});
  }

  /// The mean cost: 0 for a motion that always ends as it should.
  double cost(const Motion& motion, std::uint64_t first_seed, int robots) {
    double sum = 0;
    for (int i = 0; i < robots; ++i) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      const DrawnRobot robot = draw_robot(seed, i % 2 == 0 ? Servos::stiff : Servos::soft);
      Physics& physics = *physics_[robot.about_origin];
      // from the back it also gets up after it has rolled over
      const Lying side = side_ == Lying::on_back && i / 2 % 2 == 1 ? kOtherSides[i / 4 % 3] : side_;
      lay(physics, robot, seed, side);
      if (side != side_) {
        play(physics, get_up(side), [](const Truth&) {});
        soften(physics, kLies);
        if (physics.truth().face_up < kFaceUp) continue;  // another search is to mend that
      }
      sum += side_ == Lying::on_back ? cost_of_standing(physics, motion) : cost_of_rolling(physics, motion);
    }
    return sum / robots;
  }

 private:
  static void cycle(Physics& physics) {
    for (int i = 0; i < kSteps; ++i) physics.step(0, 0);
  }

  static PerJoint<float> measured(const Physics& physics, const Sensors& sensors) {
    PerJoint<float> positions{};
    put_legs(sensors.joints, positions);
    put_arms(physics.arms(), positions);
    return positions;
  }

  /// Drops the robot, which tucks in and softens as under the guardian.
  static void lay(Physics& physics, const DrawnRobot& robot, std::uint64_t seed, Lying side) {
    const Drop drop = draw_drop(side, seed);
    physics.drop(robot, seed, legs_of(drop.limbs), arms_of(drop.limbs), drop.roll, drop.pitch);
    const KeyFrame& tucked = tuck()[0];
    physics.command(legs_of(tucked.position), tucked.stiffness, arms_of(tucked.position));
    for (double time = 0; time < kTucks; time += kCycle) cycle(physics);
    soften(physics, kLies);
  }

  static void soften(Physics& physics, double seconds) {
    physics.command({}, 0, {});
    for (double time = 0; time < seconds; time += kCycle) cycle(physics);
  }

  /// Plays a motion, then holds its last pose for 2 s. Calls see(truth) after each cycle.
  template <class See>
  static void play(Physics& physics, KeyFrames motion, See&& see) {
    Limiter limiter;
    limiter.soften(measured(physics, physics.sense()));
    Player player;
    player.play(motion, limiter.pose().position);
    for (double held = 0; held < kHolds; held += player.finished() ? kCycle : 0) {
      const Pose& pose = limiter.next(player.next(kCycle), measured(physics, physics.sense()), kCycle, 1);
      physics.command(legs_of(pose.position), pose.stiffness[l_knee_pitch], arms_of(pose.position));
      cycle(physics);
      see(physics.truth());
    }
  }

  /// 0 for a robot that lies on its back, 2 for one on its front.
  static double cost_of_rolling(Physics& physics, const Motion& motion) {
    play(physics, motion, [](const Truth&) {});
    return 1 - physics.truth().face_up;
  }

  /// 0 for a robot that stands upright in the last second; more for one that has not come far.
  static double cost_of_standing(Physics& physics, const Motion& motion) {
    double on_feet = 0, best = 0, time = 0, least = 1, duration = 0;
    for (const KeyFrame& frame : motion) duration += frame.seconds;
    play(physics, motion, [&](const Truth& truth) {
      time += kCycle;
      // a robot with its weight on its feet has come far
      const walk::Sensors sensors = physics.sense();
      const double load = std::min(1.0, (sensors.load_of(left) + sensors.load_of(right)) / kWeight);
      const double now = load * (0.4 + 0.6 * std::max(0.0, truth.upright)) * truth.height / kHeight;
      on_feet += kSmoothed * (now - on_feet), best = std::max(best, on_feet);
      if (time > duration + kHolds / 2) least = std::min(least, truth.upright);
    });
    if (!(least > 0.3)) return 3 + 3 * (1 - best);
    return (least < kStands ? 1 : 0) + 1 - least + 0.02 * duration;
  }

  Lying side_;
  std::array<std::unique_ptr<Physics>, 2> physics_;  // by the reading of the inertias
};

/// Prints the frames as rows of get_up.cpp.
void print(const Motion& motion, std::size_t searched) {
  for (std::size_t frame = 0; frame < searched; ++frame) {
    const char* before = "    {{";
    for (const Joint joint : kGetUpJoints) {
      std::printf("%s%4.0f", before, static_cast<double>(motion[frame].position[joint]) / kDegree);
      before = ",";
    }
    std::printf("}, %.2ff},\n", static_cast<double>(motion[frame].seconds));
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string_view what = count == 6 ? words[1] : "";
  const Lying side = what == "back"    ? Lying::on_back
                     : what == "front" ? Lying::on_front
                     : what == "left"  ? Lying::on_left
                                       : Lying::on_right;
  const int generations = count == 6 ? std::atoi(words[3]) : 0, robots = count == 6 ? std::atoi(words[4]) : 0;
  const double step = count == 6 ? std::atof(words[5]) : 0;
  if ((side == Lying::on_right && what != "right") || generations < 1 || robots < 2 || !(step > 0)) {
    std::fprintf(stderr,
                 "tune_get_up: expected back|front|left|right FIRST_SEED GENERATIONS ROBOTS STEP, with at least 1 "
                 "generation of 2 robots and a step above 0 degrees\n");
    return 2;
  }
  const KeyFrames motion = get_up(side);
  const std::size_t searched = side == Lying::on_back ? motion.size() - 1 : motion.size();
  const std::uint64_t first_seed = std::strtoull(words[2], nullptr, 10);
  std::array<Judge, 2> judges{Judge(side), Judge(side)};
  const Search search{.dimensions = searched * kRow,
                      .step = step,
                      .population = 20,
                      .first_seed = first_seed,
                      .generations = generations};
  run(
      search, judges,
      [&](Judge& judge, const sim::learn::Vector& point, std::uint64_t seed) {
        return judge.cost(changed(motion, searched, point), seed, robots);
      },
      [&](const sim::learn::Vector& mean) { print(changed(motion, searched, mean), searched); });
  return 0;
}
