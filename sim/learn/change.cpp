#include "sim/learn/change.h"

#include <algorithm>

namespace sim::learn {

std::string text_of(const Change& change) {
  if (change.before.empty()) return change.what + ": removed, worth nothing";
  return change.what + ": " + change.before + " → " + change.after;
}

std::vector<Change> merged(const std::vector<Change>& changes) {
  std::vector<Change> left;
  for (const Change& change : changes) {
    if (change.before.empty())
      std::erase_if(left, [&](const Change& each) {
        return each.what == change.what || each.what.starts_with(change.what + ": ");
      });
    const auto same = std::ranges::find_if(left, [&](const Change& each) {
      return each.what == change.what && !change.before.empty() && each.after == change.before;
    });
    if (same == left.end())
      left.push_back(change);
    else
      same->after = change.after;
  }
  return left;
}

}  // namespace sim::learn
