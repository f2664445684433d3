#include "robot/lab/whole/runs.h"

#include <utility>

namespace robot::lab {

void Runs::add(std::uint64_t at_ns, const std::vector<std::string>& words) {
  if (full_ || (!runs_.empty() && at_ns < runs_.back().to_ns)) return;
  std::vector<std::uint32_t> indices;
  for (const std::string& word : words) indices.push_back(index_of(word));
  const bool follows = !runs_.empty() && at_ns - runs_.back().to_ns <= kGapNs;
  if (follows) runs_.back().to_ns = at_ns;
  if (follows && runs_.back().words == indices) return;
  full_ = runs_.size() == kMost;
  if (!full_) runs_.push_back({.from_ns = at_ns, .to_ns = at_ns, .words = std::move(indices)});
}

std::uint32_t Runs::index_of(const std::string& word) {
  if (const auto known = index_.find(word); known != index_.end()) return known->second;
  if (words_.size() >= kMostWords && word != "…") return index_of("…");
  const auto index = static_cast<std::uint32_t>(words_.size());
  words_.push_back(word);
  index_.emplace(word, index);
  return index;
}

}  // namespace robot::lab
