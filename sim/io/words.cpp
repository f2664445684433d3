#include "sim/io/words.h"

#include <algorithm>
#include <numeric>

#include "sim/io/source.h"

namespace sim::io {
namespace {

constexpr std::size_t kLongestWord = 64;  // bytes; longer words have no similar one
constexpr std::size_t kMostSimilar = 3;
constexpr std::size_t kFew = 16;

/// Returns the words that need the fewest edits, in the order of `known`. Empty if all need too many.
std::vector<std::string_view> most_similar(std::string_view word, const std::vector<std::string_view>& known) {
  std::vector<std::string_view> similar;
  if (word.empty() || word.size() > kLongestWord) return similar;
  // a word of which no letter remains is another word
  std::size_t least = std::min(word.size() / 3 + 1, word.size() - 1);
  for (const std::string_view one : known) {
    const std::size_t edits = edits_between(word, one);
    if (edits < least) similar.clear(), least = edits;
    if (edits == least) similar.push_back(one);
  }
  if (similar.size() > kMostSimilar) similar.resize(kMostSimilar);
  return similar;
}

}  // namespace

std::size_t edits_between(std::string_view a, std::string_view b) {
  // rows of the table of edits between the beginnings of both words
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      row[k] = std::min({last[k - 1] + (a[i - 1] != b[k - 1]), last[k] + 1, row[k - 1] + 1});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], before_last[k - 2] + 1);
    }
  }
  return row.back();
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::vector<std::string_view> similar = most_similar(word, known);
  std::string all;
  for (std::size_t i = 0; i < similar.size(); ++i) {
    if (i > 0) all += i + 1 == similar.size() ? " or " : ", ";
    all.append("'").append(similar[i]).append("'");
  }
  return all.empty() ? "" : "; did you mean " + all + "?";
}

std::string hint(std::string_view word, const std::vector<std::string_view>& known) {
  if (known.empty()) return "; there are none";
  if (std::string similar = did_you_mean(word, known); !similar.empty()) return similar;
  return known.size() <= kFew ? "; there are: " + listed(known) : "";
}

}  // namespace sim::io
