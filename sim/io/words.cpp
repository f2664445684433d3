#include "sim/io/words.h"

#include <algorithm>
#include <numeric>

#include "sim/io/source.h"

namespace sim::io {
namespace {

/// Returns the number of letters to insert, remove or exchange.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t exchanged = diagonal + (a[i] != b[k]);
      diagonal = row[k + 1];
      row[k + 1] = std::min({exchanged, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string hint(std::string_view word, const std::vector<std::string_view>& known) {
  constexpr std::size_t kLongestWord = 64, kFew = 16;
  if (known.empty()) return "; there are none";
  std::size_t least = word.size() / 3 + 1;
  std::string_view nearest;
  if (word.size() <= kLongestWord)
    for (const std::string_view one : known)
      if (const std::size_t edits = edits_between(word, one); edits <= least && (edits < least || nearest.empty()))
        least = edits, nearest = one;
  if (!nearest.empty()) return "; did you mean '" + std::string(nearest) + "'?";
  return known.size() <= kFew ? "; there are: " + listed(known) : "";
}

}  // namespace sim::io
