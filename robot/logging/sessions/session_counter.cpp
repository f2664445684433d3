#include "robot/logging/sessions/session_counter.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "robot/core/files.h"

namespace robot::logging {
namespace {

/// No robot records this many sessions: a greater number in the file is damage.
constexpr std::uint64_t kGreatest = 1'000'000'000'000;

std::uint64_t number_in(int file) {
  char text[32];
  const ssize_t size = ::pread(file, text, sizeof text, 0);
  std::uint64_t number = 0;
  if (size > 0) std::from_chars(text, text + size, number);
  return number <= kGreatest ? number : 0;
}

void write_number(int file, std::uint64_t number) {
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%llu\n", static_cast<unsigned long long>(number));
  if (::pwrite(file, text, static_cast<std::size_t>(size), 0) == size) ::fsync(file);
}

}  // namespace

std::uint64_t next_session_number(const std::filesystem::path& log_folder, std::uint64_t greatest) {
  greatest = std::min(greatest, kGreatest);
  const FileDescriptor file(
      ::open((log_folder / kCounterFile).c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
  if (!file || ::flock(file.get(), LOCK_EX) != 0) return greatest + 1;
  const std::uint64_t next = std::max(number_in(file.get()), greatest) + 1;
  write_number(file.get(), next);
  return next;
}

std::string boot_id() {
  const auto text = read_file("/proc/sys/kernel/random/boot_id", 100);
  return text ? text->substr(0, text->find('\n')) : "";
}

}  // namespace robot::logging
