// Standing or fallen, by height.
#pragma once

namespace robot::truth {

/// Heights [m] of a Nao's highest point: it stands with 0.57 m and lies with about 0.2 m. Between the two thresholds, the
/// judgement stays as it was.
constexpr double kFallenBelow = 0.33, kStandingAbove = 0.42;

/// The judgement about one robot.
struct Posture {
  double height = 0;  // [m] mean of the last images, each of them a third; 0: not measured
  bool fallen = false;
};

/// Returns the judgement after one more image. A height that is 0 or no number was not measured.
inline Posture judged(Posture posture, double height) {
  if (!(height > 0)) return posture;
  posture.height += (posture.height > 0 ? 1. / 3 : 1.) * (height - posture.height);
  if (posture.height < kFallenBelow) posture.fallen = true;
  if (posture.height > kStandingAbove) posture.fallen = false;
  return posture;
}

}  // namespace robot::truth
