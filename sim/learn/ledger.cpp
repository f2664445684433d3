#include "sim/learn/ledger.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "robot/core/text.h"
#include "sim/match/hash.h"

namespace sim::learn {
namespace {

using robot::Error;
using robot::Result;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// Returns a line: the key, then for each score its points, with "+" if it was won.
std::string line_of(std::uint64_t key, const std::vector<Score>& scores) {
  std::string line = hex(key);
  for (const Score& score : scores) {
    char points[32];
    const auto end = std::to_chars(points, points + sizeof points, score.points).ptr;
    line.append(" ").append(points, end);
    if (score.won) line += '+';
  }
  return line + '\n';
}

/// Reads a line into `key` and `scores`. Returns whether it is whole.
bool read_line(std::string_view line, std::uint64_t& key, std::vector<Score>& scores) {
  bool first = true;
  for (std::string_view word : robot::split(line, " ")) {
    if (std::exchange(first, false)) {
      const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), key, 16);
      if (failed != std::errc{} || word.size() != 16 || end != word.data() + word.size()) return false;
      continue;
    }
    Score score;
    score.won = word.ends_with('+');
    if (score.won) word.remove_suffix(1);
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), score.points);
    if (failed != std::errc{} || end != word.data() + word.size()) return false;
    scores.push_back(score);
  }
  return !scores.empty();
}

}  // namespace

Result<Ledger> Ledger::open(const std::filesystem::path& file) {
  Ledger ledger;
  ledger.file_ = file;
  if (file.empty()) return ledger;
  ledger.open_ = robot::FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND, 0644));
  if (!ledger.open_) return robot::file_error("ledger", file, errno);
  const auto text = robot::read_file(file, kMostBytes);
  if (!text) return text.failure();
  const std::size_t whole = text->rfind('\n') == text->npos ? 0 : text->rfind('\n') + 1;
  if (whole < text->size() && ::ftruncate(ledger.open_.get(), static_cast<off_t>(whole)) != 0)
    return robot::file_error("ledger", file, errno);
  std::string_view rest(*text);
  rest = rest.substr(0, whole);
  for (int number = 1; !rest.empty(); ++number) {
    std::uint64_t key = 0;
    std::vector<Score> scores;
    if (!read_line(robot::take_line(rest), key, scores))
      return Error{"ledger " + file.string() + ": line " + std::to_string(number) +
                   " must be a key and scores; the file is damaged"};
    ledger.scores_[key] = std::move(scores);
  }
  return ledger;
}

const std::vector<Score>* Ledger::find(std::uint64_t key) const {
  const auto found = scores_.find(key);
  return found == scores_.end() ? nullptr : &found->second;
}

Result<void> Ledger::add(std::uint64_t key, std::vector<Score> scores) {
  if (open_) {
    const std::string line = line_of(key, scores);
    for (std::size_t written = 0; written < line.size();) {
      const ssize_t now = ::write(open_.get(), line.data() + written, line.size() - written);
      if (now < 0 && errno == EINTR) continue;
      if (now < 0) return robot::file_error("ledger", file_, errno);
      written += static_cast<std::size_t>(now);
    }
  }
  scores_[key] = std::move(scores);
  return {};
}

}  // namespace sim::learn
