#include "robot/fit/visibility/along.h"

#include "robot/fit/math/angles.h"

#include <algorithm>
#include <cmath>

namespace robot::fit {
namespace {

constexpr double kPut = 0.3;  // [m] a shorter step may be an error of the truth

}  // namespace

std::optional<lab::PlaceAt> Along::at(double seconds) {
  const lab::Path& path = *path_;
  while (next_ < path.size() && path[next_].at < seconds) ++next_;
  while (next_ > 0 && path[next_ - 1].at >= seconds) --next_;
  if (next_ == path.size()) return std::nullopt;
  const lab::PlaceAt& after = path[next_];
  if (after.at == seconds) return after;
  if (next_ == 0) return std::nullopt;
  const lab::PlaceAt& before = path[next_ - 1];
  const double gap = after.at - before.at;
  if (!(gap <= lab::SmoothCurve::kLongestGap)) return std::nullopt;
  if (std::hypot(after.x - before.x, after.y - before.y) > std::max(kPut, fastest_ * gap)) return std::nullopt;
  const double part = (seconds - before.at) / gap;
  const double turn = wrapped(after.heading - before.heading);
  return lab::PlaceAt{.at = seconds,
                      .x = before.x + part * (after.x - before.x),
                      .y = before.y + part * (after.y - before.y),
                      .heading = before.heading + part * turn,
                      .fallen = part < 0.5 ? before.fallen : after.fallen};
}

}  // namespace robot::fit
