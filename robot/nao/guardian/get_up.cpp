#include "robot/nao/guardian/get_up.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace robot::nao {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;
constexpr std::size_t kAngles = 19;

/// The angles of a key frame [degrees], in the order of kOrder, and its duration [s].
struct Row {
  float angles[kAngles];
  float seconds;
};

// clang-format off
constexpr Joint kOrder[kAngles] = {
    l_shoulder_pitch, l_shoulder_roll, l_elbow_yaw, l_elbow_roll,
    r_shoulder_pitch, r_shoulder_roll, r_elbow_yaw, r_elbow_roll,
    l_hip_yaw_pitch,
    l_hip_roll, l_hip_pitch, l_knee_pitch, l_ankle_pitch, l_ankle_roll,
    r_hip_roll, r_hip_pitch, r_knee_pitch, r_ankle_pitch, r_ankle_roll};

constexpr Row kFromBack[] = {
    // raises the legs
    {{  -6, -16, 100, -87,    1,  14, -95,  88,  -36,   18, -69,  -5,  34,  36,  -19, -68,  -3,  34, -38}, 0.93f},
    // throws them down and pushes with the elbows
    {{  71,  55, 116, -81,   72, -57,-118,  88,    8,  -10, -33,  -5,  -3,  -7,   13, -35,  -6,   8,  11}, 0.32f},
    // sits up
    {{ 119,  -4, 103,  -4,  118,   5,-104,   4,   -6,  -14, -77,  -3,   6, -16,   11, -83,  -3,   4,  16}, 1.07f},
    // arms behind it
    {{  93,   5, -74,  -5,   92,  -9,  78,   7,  -50,   19, -62,  -5,  -5,  11,  -18, -57,   0,   0,  -9}, 0.48f},
    // spreads and bends the legs
    {{ 118,   1, -89, -22,  115,  -1,  81,  23,  -65,   43, -85,  77,  51,  -9,  -31, -87,  77,  51,   3}, 0.51f},
    // left foot under it
    {{ 118,  -9, -86, -17,  119, -37,  99,  11,  -63,   17, -28, 121, -45, -17,  -21, -88,  47,  52,  -1}, 0.69f},
    // waits
    {{ 113,  -6, -87, -19,  119, -36,  98,  10,  -66,   10, -24, 121, -42, -23,  -20, -88,  44,  47,  -1}, 0.25f},
    // right leg pushes
    {{  99,  21, -96, -12,  112, -15,  94,   7,  -62,    7, -25, 120, -57,   6,  -20, -25,  -6,  50,   5}, 0.54f},
    // pulls the right leg in
    {{  88,  22, -88, -22,  100,   0,  93,  14,  -41,   19, -60, 118, -58,  12,    8, -42,  98, -12,  21}, 0.61f},
    // squats
    {{  84,  16, -80, -16,   83,  -9, 100,   7,  -34,   -5, -62, 121, -52,   5,    7, -57, 115, -51, -10}, 0.60f},
    // closes the legs
    {{  79,  14, -84, -11,   79, -10,  98,   7,   -1,   -1, -59, 121, -67,  -4,    7, -52, 120, -68,  -6}, 0.47f},
    // squats
    {{  90,  21, -55, -28,   93, -17,  56,  23,    1,   -1, -55, 121, -68,  -1,    2, -52, 117, -65,   2}, 0.87f},
};
constexpr Row kFromFront[] = {
    // right arm along the head
    {{  37,  76,   7, -88,  -96,   0,   3,  67,   16,    0,  13,  16, -13, -10,  -29,  28,  39,   2,  20}, 0.92f},
    // left arm pushes
    {{  -9,  -8,  -8, -34, -114,  18,  24,  23,   11,    4,  25,  10,  41,  24,   19, -29,  -5,  10,   1}, 0.59f},
    // rolls over the right arm
    {{ -16, -18, -14, -48, -119,  18, -12,   2,  -30,  -22,  28,  28,   8, -15,   -4, -65,  -6,   1,   4}, 0.61f},
    // arms to the hips
    {{  61,  20, -57, -19,   60, -29,  30,  10,  -29,  -15, -12,  17,  24,  -7,   16,  12,  -1,   2,  -9}, 1.23f},
};
constexpr Row kFromLeft[] = {
    // lower arm aside
    {{  39,  68,  12, -42,   55, -35,  -1,  16,  -10,    7, -63,  20,   6, -10,   -2, -45,  51,   5,  13}, 0.30f},
    // pushes
    {{  99,  76, -22, -21,   72, -57, -10,  13,   -9,   17,   3,  -5, -28,  -2,  -39, -11,  -3, -15, -12}, 0.44f},
    // arms to the hips
    {{  56,  19, -79, -22,   58, -17,  67,  33,    2,    6, -22,   8, -10,  10,   -2, -17,  -6, -24, -15}, 0.42f},
};
// clang-format on

constexpr std::size_t kSeated = 4;        // rows from the back that end with a robot that sits
constexpr Range kOffGround{-0.9f, 1.2f};  // [rad] pitch of a torso that does not lie

KeyFrame frame_of(const Row& row, Range pitch) {
  KeyFrame frame{.position = {}, .stiffness = 1, .seconds = row.seconds, .needs_feet = false, .pitch = pitch};
  for (std::size_t i = 0; i < kAngles; ++i)
    frame.position[kOrder[i]] = clamp(row.angles[i] * kDegree, limits_of(kOrder[i]).range);
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
