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
#include <thread>
#include <vector>

#include "robot/nao/guardian/limiter.h"
#include "robot/nao/motion/leg_joints.h"
#include "sim/learn/cma.h"
#include "tests/walk/arm_joints.h"
#include "tests/walk/rise.h"

namespace {

using namespace robot::nao;
using namespace robot::nao::walk;

constexpr float kCycle = 0.012f;  // [s] of LoLA
constexpr int kSteps = 6;         // of the physics in a cycle
constexpr double kSettles = 1.5;  // [s] without stiffness, before the motion
constexpr double kHolds = 2;      // [s] the last pose
constexpr double kStands = 0.95;  // cosine of the tilt
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kHeight = 0.33;    // [m] of the torso of a robot that stands
constexpr double kWeight = 5;       // [kg] on the feet
constexpr double kLonger = 0.03;    // change of the logarithm of a duration, when an angle changes by a degree
constexpr double kSmoothed = 0.05;  // share of a cycle in the smoothed progress

// the joints that are searched, in the order of a row
constexpr Joint kSearched[] = {l_shoulder_pitch, l_shoulder_roll, l_elbow_yaw,   l_elbow_roll,    r_shoulder_pitch,
                               r_shoulder_roll,  r_elbow_yaw,     r_elbow_roll,  l_hip_yaw_pitch, l_hip_roll,
                               l_hip_pitch,      l_knee_pitch,    l_ankle_pitch, l_ankle_roll,    r_hip_roll,
                               r_hip_pitch,      r_knee_pitch,    r_ankle_pitch, r_ankle_roll};
constexpr std::size_t kRow = std::size(kSearched) + 1;  // and the duration

using Motion = std::vector<KeyFrame>;

/// Returns the motion of the guardian, changed by this point [degrees]. The stand at its end does not change.
Motion changed(KeyFrames motion, std::size_t searched, const sim::learn::Vector& point) {
  Motion all(motion.begin(), motion.end());
  for (std::size_t frame = 0; frame < searched; ++frame) {
    const double* const change = &point[frame * kRow];
    for (std::size_t i = 0; i + 1 < kRow; ++i) {
      float& angle = all[frame].position[kSearched[i]];
      angle = clamp(angle + static_cast<float>(kDegree * change[i]), limits_of(kSearched[i]).range);
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
      const Drop drop = draw_drop(side_, seed);
      physics.drop(robot, seed, legs_of(drop.limbs), arms_of(drop.limbs), drop.roll, drop.pitch);
      physics.command(legs_of(drop.limbs), 0, arms_of(drop.limbs));
      for (double time = 0; time < kSettles; time += kCycle) cycle(physics);
      sum += play(physics, motion);
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

  double play(Physics& physics, const Motion& motion) const {
    Limiter limiter;
    limiter.soften(measured(physics, physics.sense()));
    Player player;
    player.play(motion, limiter.pose().position);
    double held = 0, least = 1, seconds = 0, on_feet = 0, best = 0;
    for (; held < kHolds; held += player.finished() ? kCycle : 0, seconds += kCycle) {
      const walk::Sensors sensors = physics.sense();
      const Pose& pose = limiter.next(player.next(kCycle), measured(physics, sensors), kCycle, 1);
      physics.command(legs_of(pose.position), pose.stiffness[l_knee_pitch], arms_of(pose.position));
      cycle(physics);
      const Truth truth = physics.truth();
      if (!(truth.height < 10)) return kWorst;
      // a robot with its weight on its feet has come far
      const double load = std::min(1.0, (sensors.load_of(left) + sensors.load_of(right)) / kWeight);
      const double now = load * (0.4 + 0.6 * std::max(0.0, truth.upright)) * truth.height / kHeight;
      on_feet += kSmoothed * (now - on_feet), best = std::max(best, on_feet);
      if (held > kHolds / 2) least = std::min(least, truth.upright);
      if (side_ == Lying::on_back && player.finished() && truth.upright < 0.3) return 3 + 3 * (1 - best);
    }
    const Truth truth = physics.truth();
    if (side_ != Lying::on_back) return 1 - truth.face_up;
    return (least < kStands ? 1 : 0) + 1 - least + 0.02 * seconds;
  }

  static constexpr double kWorst = 6;

  Lying side_;
  std::array<std::unique_ptr<Physics>, 2> physics_;  // by the reading of the inertias
};

/// Prints the frames as rows of get_up.cpp.
void print(const Motion& motion, std::size_t searched) {
  for (std::size_t frame = 0; frame < searched; ++frame) {
    std::printf("  {");
    for (const Joint joint : kSearched)
      std::printf("%.0f, ", static_cast<double>(motion[frame].position[joint]) / kDegree);
    std::printf("%.2f},\n", static_cast<double>(motion[frame].seconds));
  }
  std::fflush(stdout);
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
  sim::learn::Cma search(sim::learn::Vector(searched * kRow, 0.0), step, 20, first_seed);
  std::array<Judge, 2> judges{Judge(side), Judge(side)};  // one for each thread
  for (int generation = 0; generation < generations; ++generation) {
    const auto points = search.ask();
    std::vector<double> costs(points.size());
    const auto judge = [&](std::size_t thread) {
      for (std::size_t i = thread; i < points.size(); i += judges.size())
        costs[i] = judges[thread].cost(changed(motion, searched, points[i]),
                                       first_seed + static_cast<std::uint64_t>(generation) * 1000, robots);
    };
    std::thread second([&] { judge(1); });
    judge(0);
    second.join();
    search.tell(costs);
    std::printf("// generation %d: best %.3f, worst %.3f, deviation %.2f\n", generation,
                *std::min_element(costs.begin(), costs.end()), *std::max_element(costs.begin(), costs.end()),
                search.deviation());
    print(changed(motion, searched, search.mean()), searched);
  }
  return 0;
}
