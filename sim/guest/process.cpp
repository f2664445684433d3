#include "sim/guest/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

namespace sim::guest {
namespace {

using Clock = std::chrono::steady_clock;
using robot::Error;
using robot::Result;

constexpr auto kGrace = std::chrono::milliseconds(500);  // to end by itself after its input has ended

double left_until(Clock::time_point deadline) { return std::chrono::duration<double>(deadline - Clock::now()).count(); }

/// Runs in the new process: only system calls between fork and exec.
[[noreturn]] void become(const char* command, int socket) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(socket, STDIN_FILENO);
  dup2(socket, STDOUT_FILENO);
  execl("/bin/sh", "sh", "-c", command, static_cast<char*>(nullptr));
  _exit(127);
}

}  // namespace

Result<Process> Process::start(const std::string& command) {
  // a socket, because writing to it raises no signal when the reader is gone
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return Error{std::string("cannot be started: ") + std::strerror(errno)};
  robot::FileDescriptor ours(ends[0]), theirs(ends[1]);
  const std::string replaced = "exec " + command;
  const pid_t pid = fork();
  if (pid < 0) return Error{std::string("cannot be started: ") + std::strerror(errno)};
  if (pid == 0) become(replaced.c_str(), theirs.get());
  return Process(pid, std::move(ours));
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), socket_(std::move(other.socket_)), read_(std::move(other.read_)) {}

Process::~Process() {
  if (pid_ < 0) return;
  socket_.reset();
  const auto deadline = Clock::now() + kGrace;
  while (waitpid(pid_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > deadline) {
      kill(-pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
      return;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

Error Process::how_it_ended() {
  // it closed its output: wait up to 2 s for its end
  int status = 0;
  pid_t ended = 0;
  for (int i = 0; i < 200 && (ended = waitpid(pid_, &status, WNOHANG)) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (ended != pid_) return Error{"the process closed its output"};
  pid_ = -1;
  if (WIFSIGNALED(status)) return Error{"the process was killed by signal " + std::to_string(WTERMSIG(status))};
  if (WEXITSTATUS(status) == 127) return Error{"the command was not found, or ended with status 127"};
  return Error{"the process ended with status " + std::to_string(WEXITSTATUS(status)) + " instead of answering"};
}

Error Process::more_than_one_line() const {
  return Error{"expected one line as answer, got more: '" +
               read_.substr(0, std::min<std::size_t>(80, read_.find('\n'))) + "'"};
}

Result<std::string> Process::ask(std::string_view line, double patience_seconds) {
  // drop output after the previous answer: it is not an answer to this line
  char unasked[80];
  if (const ssize_t got = recv(socket_.get(), unasked, sizeof unasked, MSG_DONTWAIT); got > 0) {
    read_.append(unasked, static_cast<std::size_t>(got));
    return more_than_one_line();
  }
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience_seconds));
  while (true) {
    if (const std::size_t end = read_.find('\n'); line.empty() && end != read_.npos) {
      std::string answer = read_.substr(0, end);
      read_.erase(0, end + 1);
      if (!read_.empty()) return more_than_one_line();
      return answer;
    }
    if (read_.size() > kLongestLine)
      return Error{"expected a line of at most " + std::to_string(kLongestLine) + " bytes as answer, got more"};
    const double left = left_until(deadline);
    pollfd ready{.fd = socket_.get(), .events = static_cast<short>(line.empty() ? POLLIN : POLLOUT), .revents = 0};
    const int count = left > 0 ? poll(&ready, 1, static_cast<int>(std::ceil(left * 1000))) : 0;
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      char text[80];
      std::snprintf(text, sizeof text, "the process did not answer within %g s", patience_seconds);
      return Error{text};
    }

    if (!line.empty()) {
      const ssize_t sent = send(socket_.get(), line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (sent < 0) return how_it_ended();
      line.remove_prefix(static_cast<std::size_t>(sent));
      continue;
    }
    char block[4096];
    const ssize_t got = recv(socket_.get(), block, sizeof block, MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) return how_it_ended();
    read_.append(block, static_cast<std::size_t>(got));
  }
}

}  // namespace sim::guest
