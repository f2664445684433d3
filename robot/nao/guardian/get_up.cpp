#include "robot/nao/guardian/get_up.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace robot::nao {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

/// The angles of a key frame [degrees], in the order of kGetUpJoints, and its duration [s].
struct Row {
  std::array<float, kGetUpJoints.size()> angles;
  float seconds;
};

// clang-format off
constexpr Row kFromBack[] = {
    // raises the legs
    {{  -5, -17, 100, -87,    2,  14, -95,  88,  -34,   21, -68,  -4,  39,  40,  -18, -68,   0,  37, -38}, 0.97f},
    // throws them down and pushes with the elbows
    {{  70,  53, 115, -82,   71, -56,-118,  86,    8,   -9, -34,  -5,  -2,  -2,   11, -36,  -5,   7,  10}, 0.29f},
    // sits up
    {{ 119,  -2, 103,  -2,  115,   8,-104,   4,   -4,  -12, -76,  -3,   6, -15,   10, -85,  -1,   4,  12}, 1.15f},
    // arms behind it
    {{  94,   7, -73,  -5,   91, -11,  80,   7,  -51,   20, -62,  -4,  -7,  11,  -18, -58,  -3,   0, -10}, 0.43f},
    // spreads and bends the legs
    {{ 119,  -1, -90, -22,  112,  -2,  80,  24,  -64,   41, -88,  75,  51, -12,  -33, -88,  76,  50,   3}, 0.48f},
    // left foot under it
    {{ 119,  -8, -81, -17,  119, -40, 100,  10,  -61,   17, -26, 119, -47, -18,  -20, -88,  48,  53,  -1}, 0.63f},
    // waits
    {{ 111,  -7, -90, -20,  117, -35,  98,  12,  -65,   10, -25, 121, -42, -23,  -22, -84,  45,  48,  -4}, 0.25f},
    // right leg pushes
    {{ 100,  20, -97, -12,  112, -16,  92,   9,  -63,    7, -22, 118, -57,   3,  -21, -27,  -5,  45,   3}, 0.54f},
    // pulls the right leg in
    {{  88,  25, -87, -20,   97,   2,  94,  13,  -40,   17, -55, 117, -59,   9,   10, -45,  98, -11,  22}, 0.61f},
    // squats
    {{  82,  13, -80, -17,   81, -11,  99,   6,  -32,   -7, -60, 121, -50,   6,    8, -57, 115, -51, -10}, 0.65f},
    // closes the legs
    {{  84,  14, -81,  -9,   80,  -8, 100,   8,    0,    0, -56, 121, -68,  -6,    9, -50, 121, -68,  -7}, 0.51f},
    // squats
    {{  89,  23, -55, -28,   93, -18,  56,  26,   -2,   -1, -56, 121, -67,   0,    2, -52, 115, -66,   3}, 0.87f},
};
constexpr Row kFromFront[] = {
    // right arm along the head
    {{  27,  76,  13, -88,  -57,   4,  -2,  70,   20,   10,  14,  -4, -14,   6,  -45,  28,  37,   7,  16}, 0.57f},
    // left arm pushes
    {{ -21,  -6, -12, -42, -119,  18,  45,  47,    0,   -1,  28,  23,  18,  28,   21, -28,  -5,  10,  18}, 0.96f},
    // rolls over the right arm
    {{ -29, -18,  -9, -52, -119,  18,  -2,   2,  -22,  -22,  28,  28,  26, -23,    7, -66,  -5, -14,  -7}, 1.03f},
    // arms to the hips
    {{  57,  36, -71,  -2,   56, -34,  25,   2,  -35,  -22,  -5,   4,  37,   8,   15,  14,   0,   1, -13}, 1.31f},
};
constexpr Row kFromLeft[] = {
    // lower arm aside
    {{  39,  68,  12, -42,   55, -35,  -1,  16,  -10,    7, -63,  20,   6, -10,   -2, -45,  51,   5,  13}, 0.30f},
    // pushes
    {{  99,  76, -22, -21,   72, -57, -10,  13,   -9,   17,   3,  -5, -28,  -2,  -39, -11,  -3, -15, -12}, 0.44f},
    // arms to the hips
    {{  56,  19, -79, -22,   58, -17,  67,  33,    2,    6, -22,   8, -10,  10,   -2, -17,  -5, -24, -15}, 0.42f},
};
// clang-format on

constexpr std::size_t kSeated = 4;        // rows from the back that end with a robot that sits
constexpr Range kOffGround{-0.9f, 1.2f};  // [rad] pitch of a torso that does not lie

KeyFrame frame_of(const Row& row, Range pitch) {
  KeyFrame frame{.position = {}, .stiffness = 1, .seconds = row.seconds, .needs_feet = false, .pitch = pitch};
  for (std::size_t i = 0; i < kGetUpJoints.size(); ++i) {
    const Joint joint = kGetUpJoints[i];
    frame.position[joint] = clamp(row.angles[i] * kDegree, limits_of(joint).range);
  }
  return frame;
}

template <std::size_t Size>
std::array<KeyFrame, Size> rolling(const Row (&rows)[Size]) {
  std::array<KeyFrame, Size> frames{};
  for (std::size_t i = 0; i < Size; ++i) frames[i] = frame_of(rows[i], KeyFrame{}.pitch);
  return frames;
}

/// The rows, then the stand. A robot that lies after it should have sat up has failed.
template <std::size_t Size>
std::array<KeyFrame, Size + 1> rising(const Row (&rows)[Size]) {
  std::array<KeyFrame, Size + 1> frames{};
  for (std::size_t i = 0; i < Size; ++i) frames[i] = frame_of(rows[i], i < kSeated ? KeyFrame{}.pitch : kOffGround);
  frames[Size] = stand_pose();
  frames[Size].pitch = kOffGround;
  return frames;
}

template <std::size_t Size>
std::array<KeyFrame, Size> other_side(std::array<KeyFrame, Size> frames) {
  for (KeyFrame& frame : frames) frame.position = mirrored(frame.position);
  return frames;
}

}  // namespace

Lying lying(const std::array<float, 2>& angles) {
  const auto& [roll, pitch] = angles;
  // the components of gravity along the torso: with the pitch near a right angle, the roll says nothing
  const float ahead = std::sin(pitch), aside = std::cos(pitch) * std::sin(roll);
  if (std::abs(ahead) >= std::abs(aside)) return ahead > 0 ? Lying::on_front : Lying::on_back;
  return aside > 0 ? Lying::on_right : Lying::on_left;
}

KeyFrames get_up(Lying lying) {
  static const auto back = rising(kFromBack);
  static const auto front = rolling(kFromFront);
  static const auto left = rolling(kFromLeft), right = other_side(left);
  switch (lying) {
    case Lying::on_back: return back;
    case Lying::on_front: return front;
    case Lying::on_left: return left;
    case Lying::on_right: return right;
  }
  return back;
}

}  // namespace robot::nao
