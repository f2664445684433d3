#include "tests/walk/nao_model.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>

namespace robot::nao::walk {
namespace {

using Vector = std::array<double, 3>;
/// xx, yy, zz, xy, xz, yz [kg m²].
using Inertia = std::array<double, 6>;

/// A joint about a fixed axis.
struct Hinge {
  const char* name;  // without the letter of its side
  Vector axis;
  double low, high;       // [rad] of the left side
  double torque;          // [N m]
  bool outwards = false;  // the right joint turns the other way for the same motion
};

/// A rounded rod, as a part of a link that touches other things.
struct Rod {
  Vector from, to;
  double radius;  // [m]
};

/// A link of the left half or of the middle, in the URDF's frames.
struct Link {
  int depth;  // of the link in the tree of its chain
  Vector origin;
  double mass;
  Vector centre;  // of its mass
  Inertia inertia;
  const Hinge* hinge = nullptr;
  Vector turn_axis{};            // of a fixed turn, for arms that hang down
  double turn = 0;               // [rad]
  const Hinge* moves = nullptr;  // instead of that turn, for arms that move
  const Rod* rod = nullptr;      // if all limbs touch the ground
};

// which things touch: MuJoCo's bits of contype and conaffinity
constexpr int kOfAll = 1, kOfLimbs = 2, kOfArms = 4;

constexpr double kSlant = 0.70710678;
constexpr double kStrong = 13.6884, kWeak = 8.8978;  // [N m] of the two motors with their gears
constexpr Hinge kHipYawPitch{"HipYawPitch", {0, kSlant, -kSlant}, -1.14529, 0.740718, kStrong};
constexpr Hinge kHipRoll{"HipRoll", {1, 0, 0}, -0.379435, 0.79046, kStrong, true};
constexpr Hinge kHipPitch{"HipPitch", {0, 1, 0}, -1.53589, 0.48398, kWeak};
constexpr Hinge kKneePitch{"KneePitch", {0, 1, 0}, -0.0923279, 2.11255, kWeak};
constexpr Hinge kAnklePitch{"AnklePitch", {0, 1, 0}, -1.18944, 0.922581, kWeak};
constexpr Hinge kAnkleRoll{"AnkleRoll", {1, 0, 0}, -0.397761, 0.768992, kStrong, true};

// stall torque of 14.3 mN m times the gears of 150.27 and 173.22: Aldebaran's "Motors", type 3
constexpr double kArmA = 2.149, kArmB = 2.477;  // [N m]
constexpr Hinge kShoulderPitch{"ShoulderPitch", {0, 1, 0}, -2.08567, 2.08567, kArmA};
constexpr Hinge kShoulderRoll{"ShoulderRoll", {0, 0, 1}, -0.314159, 1.32645, kArmB, true};
constexpr Hinge kElbowYaw{"ElbowYaw", {1, 0, 0}, -2.08567, 2.08567, kArmA, true};
constexpr Hinge kElbowRoll{"ElbowRoll", {0, 0, 1}, -1.54462, -0.0349066, kArmB, true};

// our estimate of the shells
constexpr Rod kHeadRod{{0, 0, 0.03}, {0, 0, 0.075}, 0.06};
constexpr Rod kThighRod{{0, 0, -0.03}, {0, 0, -0.1}, 0.045};
constexpr Rod kShankRod{{0, 0, 0}, {0, 0, -0.07}, 0.04};
constexpr Rod kUpperArmRod{{0.02, 0.003, 0}, {0.09, 0.012, 0}, 0.027};
constexpr Rod kForearmRod{{0, 0, 0}, {0.055, 0, 0}, 0.022};
constexpr Rod kHandRod{{0.01, 0, 0}, {0.055, 0, 0}, 0.022};

constexpr Link kTorso{0,
                      {0, 0, 0.34},
                      1.04956,
                      {-0.00413, 0, 0.04342},
                      {0.00308361, 0.0028835, 0.0015924, 1.43116e-05, -3.30211e-05, -2.70793e-05}};
constexpr Link kHead[] = {
    {1,
     {0, 0, 0.1265},
     0.07842,
     {-1e-05, 0, -0.02742},
     {1.60324e-05, 1.70394e-05, 5.53372e-06, 1.57e-09, 3.16276e-09, -5.295e-08}},
    {2,
     {0, 0, 0},
     0.60533,
     {-0.00112, 0, 0.05258},
     {0.000957766, 0.000816836, 0.000984976, 8.78814e-06, 5.33702e-06, -2.99579e-05},
     nullptr,
     {},
     0,
     nullptr,
     &kHeadRod},
};
constexpr Link kLeg[] = {
    {1,
     {0, 0.05, -0.085},
     0.06981,
     {-0.00781, -0.01114, 0.02661},
     {2.3407e-05, 4.76355e-05, 4.97021e-05, 1.07922e-06, -1.76003e-06, 2.76058e-06},
     &kHipYawPitch},
    {2,
     {0, 0, 0},
     0.14053,
     {-0.01549, 0.00029, -0.00515},
     {2.38445e-05, 6.08246e-05, 5.43691e-05, -6.53605e-07, 7.12893e-06, -2.14072e-07},
     &kHipRoll},
    {3,
     {0, 0, 0},
     0.38968,
     {0.00138, 0.00221, -0.05373},
     {0.000509844, 0.000465358, 0.000301098, 2.11296e-06, 5.64129e-05, -7.91029e-06},
     &kHipPitch,
     {},
     0,
     nullptr,
     &kThighRod},
    {4,
     {0, 0, -0.1},
     0.30142,
     {0.00453, 0.00225, -0.04936},
     {0.000446171, 0.000388084, 0.000185516, 3.70584e-06, -3.09008e-05, 6.01953e-06},
     &kKneePitch,
     {},
     0,
     nullptr,
     &kShankRod},
    {5,
     {0, 0, -0.1029},
     0.13416,
     {0.00045, 0.00029, 0.00685},
     {3.22034e-05, 6.7943e-05, 5.48269e-05, -8.83212e-09, 4.27549e-06, 2.84849e-07},
     &kAnklePitch},
    {6,
     {0, 0, 0},
     0.17184,
     {0.02542, 0.0033, -0.03239},
     {8.72911e-05, 0.000353024, 0.000412846, 8.71925e-06, -2.10563e-06, 3.73459e-07},
     &kAnkleRoll},
};
constexpr Link kArm[] = {
    {1,
     {0, 0.098, 0.1},
     0.09304,
     {-0.00165, -0.02663, 0.00014},
     {1.83025e-05, 1.39005e-05, 2.01862e-05, 2.06011e-06, 1.88776e-09, -3.66592e-07},
     nullptr,
     {0, 1, 0},
     1.57,
     &kShoulderPitch},
    {2,
     {0, 0, 0},
     0.15777,
     {0.02455, 0.00563, 0.0033},
     {8.7181e-05, 0.000274712, 0.000241812, -2.53381e-05, -1.4213e-05, 4.71439e-07},
     nullptr,
     {0, 0, 1},
     0.12,
     &kShoulderRoll,
     &kUpperArmRod},
    {3,
     {0.105, 0.015, 0},
     0.06483,
     {-0.02744, 0, -0.00014},
     {5.59588e-06, 2.66179e-05, 2.76294e-05, 4.21e-09, 2.92241e-07, -1.84e-09},
     nullptr,
     {},
     0,
     &kElbowYaw},
    {4,
     {0, 0, 0},
     0.07761,
     {0.02556, 0.00281, 0.00076},
     {2.46746e-05, 3.83837e-05, 3.59708e-05, 3.23152e-06, 1.58221e-06, 1.39194e-07},
     nullptr,
     {0, 0, 1},
     -0.04,
     &kElbowRoll,
     &kForearmRod},
    {5,
     {0.05595, 0, 0},
     0.18533,
     {0.03434, -0.00088, 0.00308},
     {6.86477e-05, 0.000135756, 0.000133228, 1.15465e-07, -2.87254e-06, 2.67539e-06},
     nullptr,
     {},
     0,
     nullptr,
     &kHandRod},
};

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 512> line;
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

std::string text(const Vector& v) { return text("%.9g %.9g %.9g", v[0], v[1], v[2]); }

/// Returns the inertia about the centre of mass plus that of the mass about the origin.
Inertia about_origin(const Link& link) {
  const auto [x, y, z] = link.centre;
  const double m = link.mass;
  const Inertia& i = link.inertia;
  return {i[0] + m * (y * y + z * z), i[1] + m * (x * x + z * z), i[2] + m * (x * x + y * y),
          i[3] - m * x * y,           i[4] - m * x * z,           i[5] - m * y * z};
}

/// Returns the link of the other side: mirrored at the plane between the sides.
Link mirrored(Link link) {
  link.origin[1] = -link.origin[1];
  link.centre[1] = -link.centre[1];
  link.inertia[3] = -link.inertia[3];
  link.inertia[5] = -link.inertia[5];
  // a turn is an axial vector: its x and z change their signs
  link.turn_axis = {-link.turn_axis[0], link.turn_axis[1], -link.turn_axis[2]};
  return link;
}

std::string inertial(const Link& link, bool origin) {
  const Inertia i = origin ? about_origin(link) : link.inertia;
  return text("<inertial pos='%s' mass='%.9g' fullinertia='%.9g %.9g %.9g %.9g %.9g %.9g'/>", text(link.centre).c_str(),
              link.mass, i[0], i[1], i[2], i[3], i[4], i[5]);
}

/// Returns the joint. The slanted axis is mirrored on the right side.
std::string joint(const Hinge& hinge, bool is_left) {
  Vector axis = hinge.axis;
  double low = hinge.low, high = hinge.high;
  if (!is_left && hinge.outwards) low = -hinge.high, high = -hinge.low;
  if (!is_left && !hinge.outwards) axis[2] = -axis[2];
  return text("<joint name='%c%s' axis='%s' limited='true' range='%.9g %.9g'/>", is_left ? 'L' : 'R', hinge.name,
              text(axis).c_str(), low, high);
}

/// The foot's sole with its four sensors.
std::string sole(bool is_left) {
  const char letter = is_left ? 'l' : 'r';
  const double middle = is_left ? 0.003 : -0.003;
  std::string all;
  using Place = std::tuple<const char*, double, double>;
  for (const auto& [name, x, y] : {Place{"fl", 0.059, 0.0215}, Place{"fr", 0.059, -0.0215}, Place{"rl", -0.019, 0.0215},
                                   Place{"rr", -0.019, -0.0215}})
    all += text("<site name='%c_%s' type='box' size='0.041 0.0235 0.02' pos='%g %g -0.0451'/>", letter, name, x,
                middle + y);
  return all +
         text("<geom name='%c_sole' type='box' pos='0.02 %g -0.04011' size='0.078 0.043 0.005'/>", letter, middle);
}

/// Limbs touch the ground and the arms, the arms also the chest.
std::string touching(const Rod& rod, bool is_left, bool is_arm) {
  const double side = is_left ? 1 : -1;
  return text("<geom type='capsule' size='%g' fromto='%g %g %g %g %g %g' contype='%d' conaffinity='%d'/>", rod.radius,
              rod.from[0], side * rod.from[1], rod.from[2], rod.to[0], side * rod.to[1], rod.to[2],
              is_arm ? kOfArms | kOfLimbs : kOfLimbs, is_arm ? 0 : kOfArms);
}

template <std::size_t Size>
std::string chain(const Link (&links)[Size], bool is_left, const Scene& scene) {
  std::string all;
  for (const Link& original : links) {
    const Link link = is_left ? original : mirrored(original);
    all += text("<body pos='%s'", text(link.origin).c_str());
    const bool moves = link.moves && scene.arms;
    if (link.turn != 0 && !moves) all += text(" axisangle='%s %.9g'", text(link.turn_axis).c_str(), link.turn);
    all += ">";
    if (link.hinge) all += joint(*link.hinge, is_left);
    if (moves) all += joint(*link.moves, is_left);
    all += inertial(link, scene.about_origin);
    if (link.rod && scene.arms) all += touching(*link.rod, is_left, std::begin(links) == std::begin(kArm));
    if (link.hinge == &kAnkleRoll) all += sole(is_left);
  }
  for (std::size_t i = 0; i < Size; ++i) all += "</body>";
  return all;
}

std::string motor(const Hinge& hinge, char letter) {
  return text("<motor name='%c%s' joint='%c%s' ctrllimited='true' ctrlrange='-%g %g'/>", letter, hinge.name, letter,
              hinge.name, hinge.torque, hinge.torque);
}

/// First those of the legs.
std::string motors(bool arms) {
  std::string all;
  for (const char letter : {'L', 'R'})
    for (const Link& link : kLeg) all += motor(*link.hinge, letter);
  for (const char letter : {'L', 'R'})
    for (const Link& link : kArm)
      if (arms && link.moves) all += motor(*link.moves, letter);
  return all;
}

std::string sensors() {
  std::string all = "<gyro site='imu'/>";
  for (const char letter : {'l', 'r'})
    for (const char* name : {"fl", "fr", "rl", "rr"}) all += text("<touch site='%c_%s'/>", letter, name);
  return all;
}

}  // namespace

std::string model_of(const Scene& scene) {
  std::string all =
      "<mujoco model='nao'>"
      "<compiler angle='radian' balanceinertia='true' boundmass='0.001' boundinertia='1e-7'/>"
      "<option timestep='0.002' integrator='implicit' cone='elliptic' impratio='5'/>"
      "<default><joint damping='0.1' armature='0.01' frictionloss='0.05'/>"
      "<geom friction='0.9 0.005 0.0001' solref='0.01 1'/></default>";
  if (scene.turf)
    all += text("<asset><hfield name='turf' nrow='300' ncol='300' size='6 6 %g 0.5'/></asset>", kTurfHeight);
  all += "<worldbody>";
  all +=
      scene.turf ? "<geom name='floor' type='hfield' hfield='turf'" : "<geom name='floor' type='plane' size='50 50 1'";
  if (scene.arms) all += text(" conaffinity='%d'", kOfAll | kOfLimbs);
  all += "/>";
  all += text("<body name='torso' pos='%s'><freejoint/>", text(kTorso.origin).c_str());
  all += inertial(kTorso, scene.about_origin);
  all += "<geom name='chest' type='box' pos='0 0 0.03' size='0.05 0.06 0.09'";
  if (scene.arms) all += text(" conaffinity='%d'", kOfAll | kOfArms);
  all += "/><site name='imu' pos='-0.008 0.006 0.029'/>";
  all += chain(kHead, true, scene);
  for (const bool is_left : {true, false}) {
    all += chain(kLeg, is_left, scene);
    all += chain(kArm, is_left, scene);
  }
  all += "</body>";
  // stiffness and damping of a contact after which 0.4 of the speed are left, as the simulator has it
  if (scene.ball)
    all += text(
        "<body name='ball' pos='0 20 %g'><freejoint/><geom name='ball' type='sphere' size='%g' mass='0.044' "
        "friction='0.5 0.003 0.0001' priority='1' solref='-3000 -6.4'/></body>",
        kBallRadius, kBallRadius);
  all += "</worldbody><equality><joint joint1='LHipYawPitch' joint2='RHipYawPitch' solref='0.004 1'/></equality>";
  all += "<actuator>" + motors(scene.arms) + "</actuator><sensor>" + sensors() + "</sensor></mujoco>";
  return all;
}

}  // namespace robot::nao::walk
