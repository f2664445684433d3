// The words of a condition, one after the other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::check {

/// The words of a text. `<` `<=` `>` `>=` are words of their own.
class Words {
 public:
  explicit Words(std::string_view text);

  bool at_end() const { return next_ == words_.size(); }
  /// Returns the next word, or "" at the end.
  std::string_view peek() const { return at_end() ? std::string_view() : words_[next_]; }
  /// Removes the next word if it is this one. Returns whether it was.
  bool take(std::string_view word);
  /// Removes the next two words if together they are this one. Returns whether they were.
  bool take_pair(std::string_view words);
  /// Removes the next word and returns it.
  std::string_view take();
  /// Returns the remaining words, for an error sentence.
  std::string rest() const;

 private:
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

}  // namespace sim::check
