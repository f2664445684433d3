// Robots that wait until they fill the lanes. Internal to sim/motion.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sim/math/lanes.h"

namespace sim::motion {

/// Reports whether lanes are faster for this number of robots than one robot after the other.
constexpr bool worth_lanes(std::size_t robots) { return robots >= 3; }

/// Items that are worked on when they fill the lanes, and at the end. `run(items)` returns the number of those that it
/// has moved to the front because they need another run.
template <class Item, class Run>
class Batch {
 public:
  explicit Batch(Run run) : run_(run) {}

  void add(const Item& item) {
    items_[count_++] = item;
    while (count_ == kLanes) work();
  }
  void finish() {
    while (count_ > 0) work();
  }

 private:
  void work() { count_ = run_(std::span<Item>{items_.data(), count_}); }

  Run run_;
  std::array<Item, kLanes> items_;
  std::size_t count_ = 0;
};

template <class Item, class Run>
Batch<Item, Run> batch_of(Run run) {
  return Batch<Item, Run>(run);
}

}  // namespace sim::motion
