#include "sim/learn/ledger.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "robot/core/folder.h"
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

/// Returns the bytes of a file from `from` on.
Result<std::string> read_behind(const std::filesystem::path& path, std::uint64_t from) {
  const robot::FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return robot::file_error("ledger", path, errno);
  std::string text;
  char piece[1 << 16];
  while (text.size() < kMostBytes) {
    const ssize_t got = ::pread(file.get(), piece, sizeof piece, static_cast<off_t>(from + text.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return robot::file_error("ledger", path, errno);
    if (got == 0) break;
    text.append(piece, static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

Result<Ledger> Ledger::open(const std::filesystem::path& folder, Share share) {
  Ledger ledger;
  ledger.share_ = share;
  if (folder.empty()) return ledger;
  ledger.folder_ = folder;
  ledger.own_ = "ledger-" + std::to_string(share.number) + ".txt";
  const std::filesystem::path file = folder / ledger.own_;
  ledger.open_ = robot::FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND, 0644));
  if (!ledger.open_) return robot::file_error("ledger", file, errno);
  if (::flock(ledger.open_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return robot::file_error("cannot lock", file, errno);
    return Error{"ledger " + file.string() + ": another process is working on it"};
  }
  if (auto read = ledger.read_on(ledger.own_); !read) return read.failure();
  if (::ftruncate(ledger.open_.get(), static_cast<off_t>(ledger.known_[ledger.own_].bytes)) != 0)
    return robot::file_error("ledger", file, errno);
  if (auto read = ledger.refresh(); !read) return read.failure();
  return ledger;
}

Result<void> Ledger::refresh() {
  if (!open_) return {};
  const auto entries = robot::list_folder(folder_);
  if (!entries) return entries.failure();
  for (const robot::FolderEntry& entry : *entries) {
    const bool is_other = entry.name.starts_with("ledger-") && entry.name.ends_with(".txt") && entry.name != own_;
    if (!is_other || entry.size_bytes <= known_[entry.name].bytes) continue;
    if (auto read = read_on(entry.name); !read) return read;
  }
  return {};
}

Result<void> Ledger::read_on(const std::string& name) {
  Known& known = known_[name];
  const Result<std::string> text = read_behind(folder_ / name, known.bytes);
  if (!text) return text.failure();
  std::string_view rest(*text);
  rest = rest.substr(0, rest.rfind('\n') + 1);  // without a newline: nothing
  while (!rest.empty()) {
    const std::string_view line = robot::take_line(rest);
    std::uint64_t key = 0;
    std::vector<Score> scores;
    if (!read_line(line, key, scores))
      return Error{"ledger " + (folder_ / name).string() + ": line " + std::to_string(known.lines + 1) +
                   " must be a key and scores; the file is damaged"};
    scores_.try_emplace(key, std::move(scores));
    known.bytes += line.size() + 1, ++known.lines;
  }
  return {};
}

const std::vector<Score>* Ledger::find(std::uint64_t key) const {
  const auto found = scores_.find(key);
  return found == scores_.end() ? nullptr : &found->second;
}

Result<void> Ledger::add(std::uint64_t key, std::vector<Score> scores) {
  const auto [added, is_new] = scores_.try_emplace(key, std::move(scores));
  if (!open_ || !is_new) return {};
  const std::string line = line_of(key, added->second);
  for (std::size_t written = 0; written < line.size();) {
    const ssize_t now = ::write(open_.get(), line.data() + written, line.size() - written);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return robot::file_error("ledger", folder_ / own_, errno);
    written += static_cast<std::size_t>(now);
  }
  return {};
}

}  // namespace sim::learn
