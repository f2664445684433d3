// The share of one process in a run that several processes play together.
#pragma once

#include <cstddef>
#include <vector>

namespace sim::learn {

/// One of the processes that play a run together, perhaps on several machines. All of them do the same, but take up their
/// tasks in different orders. So no process waits for another, and a dead one is not missed.
struct Share {
  int number = 0;  // 0 .. of - 1; the first one plays the gate and reports
  int of = 1;

  bool is_first() const { return number == 0; }
};

/// Returns where part `part` begins if `total` things in a row are dealt to `parts` parts.
constexpr std::size_t begin_of_part(std::size_t total, std::size_t part, std::size_t parts) {
  return total * part / parts;
}

/// Returns the numbers 0 .. tasks - 1 in the order in which a process takes them up: its own part of them forwards, then the
/// others' parts backwards, since their owners begin at the front.
std::vector<std::size_t> order_of(std::size_t tasks, Share share);

}  // namespace sim::learn
