#include "sim/check/words.h"

namespace sim::check {
namespace {

constexpr std::string_view kBlank = " \t\r\n", kOperator = "<>=";

}  // namespace

Words::Words(std::string_view text) {
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBlank);
    if (begin == text.npos) return;
    text.remove_prefix(begin);
    const bool is_operator = kOperator.find(text.front()) != kOperator.npos;
    const std::size_t end =
        is_operator ? text.find_first_not_of(kOperator) : text.find_first_of(std::string(kBlank).append(kOperator));
    words_.push_back(text.substr(0, end));
    text.remove_prefix(words_.back().size());
  }
}

bool Words::take(std::string_view word) {
  const bool is_next = !at_end() && words_[next_] == word;
  if (is_next) ++next_;
  return is_next;
}

bool Words::take_pair(std::string_view words) {
  const std::size_t blank = words.find(' ');
  const bool are_next = next_ + 1 < words_.size() && words_[next_] == words.substr(0, blank) &&
                        words_[next_ + 1] == words.substr(blank + 1);
  if (are_next) next_ += 2;
  return are_next;
}

std::string_view Words::take() { return at_end() ? std::string_view() : words_[next_++]; }

std::string Words::rest() const {
  std::string all;
  for (std::size_t i = next_; i < words_.size(); ++i) all.append(i > next_ ? " " : "").append(words_[i]);
  return all;
}

}  // namespace sim::check
