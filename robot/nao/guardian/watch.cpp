#include "robot/nao/guardian/watch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace robot::nao {
namespace {

constexpr int kCharging = 0x80;  // bit of the battery's status
constexpr std::uint64_t kUprightLasts_ns = 1'000'000'000;

}  // namespace

void Watch::Lasting::see(bool now, std::uint64_t now_ns, std::uint64_t lasts_ns) {
  if (now == value || since_ns == 0) since_ns = now_ns;
  if (now != value && now_ns - since_ns >= lasts_ns) value = now;
}

void Watch::Lasting::see_or_end(bool now, std::uint64_t now_ns, std::uint64_t lasts_ns) {
  if (!now) value = false;
  see(now, now_ns, lasts_ns);
}

void Watch::see(const Sensors& sensors, std::uint64_t now_ns) {
  const auto worst = [](auto value_of) { return std::max(value_of(0), value_of(1)); };
  const float lean = worst([&](std::size_t i) { return std::abs(sensors.angles[i]); });
  const float lean_soon =
      worst([&](std::size_t i) { return std::abs(sensors.angles[i] + bounds_.ahead * sensors.gyroscope[i]); });
  upright_ = lean < bounds_.upright;
  falls_ = lean > bounds_.falls || (lean > bounds_.falls_soon / 2 && lean_soon > bounds_.falls_soon);
  upright_lasts_.see_or_end(upright_, now_ns, kUprightLasts_ns);
  const float turns =
      std::max({std::abs(sensors.gyroscope[0]), std::abs(sensors.gyroscope[1]), std::abs(sensors.gyroscope[2])});
  still_.see_or_end(turns < bounds_.still, now_ns, bounds_.lasts_ns);

  on_feet_ = std::accumulate(sensors.fsr.begin(), sensors.fsr.end(), 0.0f) >= bounds_.on_feet;

  const float hottest = *std::max_element(sensors.temperature.begin(), sensors.temperature.end());
  warm_.see(hottest >= (warm_.value ? bounds_.cool : bounds_.warm), now_ns, bounds_.lasts_ns);
  hot_.see(hottest >= (hot_.value ? bounds_.cooled : bounds_.hot), now_ns, bounds_.lasts_ns);

  const float charge = sensors.battery[0];
  const bool charging = (static_cast<int>(clamp(sensors.battery[1], {-32768, 65535})) & kCharging) != 0;
  low_.see(!charging && charge < bounds_.low, now_ns, bounds_.lasts_ns);
  empty_.see(!charging && charge < (empty_.value ? bounds_.low : bounds_.empty), now_ns, bounds_.lasts_ns);
}

}  // namespace robot::nao
