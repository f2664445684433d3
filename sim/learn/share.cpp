#include "sim/learn/share.h"

namespace sim::learn {

std::vector<std::size_t> order_of(std::size_t tasks, Share share) {
  const auto number = static_cast<std::size_t>(share.number), of = static_cast<std::size_t>(share.of);
  const std::size_t begin = begin_of_part(tasks, number, of), end = begin_of_part(tasks, number + 1, of);
  std::vector<std::size_t> order;
  for (std::size_t task = begin; task < end; ++task) order.push_back(task);
  for (std::size_t task = begin; task-- > 0;) order.push_back(task);
  for (std::size_t task = tasks; task-- > end;) order.push_back(task);
  return order;
}

}  // namespace sim::learn
