#include "robot/fit/ball_noise/profile.h"

#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

constexpr std::size_t kProfileSamples = 200;

}  // namespace

double middle_of(std::vector<double> values) { return values.empty() ? 0 : sim::statistics::median(std::move(values)); }

double Profile::best(const std::vector<std::size_t>& events) const {
  const std::size_t size = values_.size();
  std::vector<double> sums(size);
  for (const std::size_t event : events) {
    const double* const row = &costs_[event * size];
    for (std::size_t i = 0; i < size; ++i) sums[i] += row[i];
  }
  const auto least = static_cast<std::size_t>(std::ranges::min_element(sums) - sums.begin());
  const auto place = static_cast<double>(least);
  if (least == 0 || least + 1 == size) return value_at_(place);
  // the summit of the parabola through the best one and its neighbours
  const double before = sums[least - 1] - sums[least], after = sums[least + 1] - sums[least];
  return value_at_(before + after > 0 ? place + (before - after) / (2 * (before + after)) : place);
}

double Profile::deviation(const std::vector<std::size_t>& events) const {
  const auto samples =
      resampled(single_groups(events.size()), kProfileSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        std::vector<std::size_t> drawn;
        for (const std::size_t i : chosen) drawn.push_back(events[i]);
        return {best(drawn)};
      });
  return deviations_of(samples)[0];
}

}  // namespace robot::fit
