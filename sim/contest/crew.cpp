#include "sim/contest/crew.h"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <type_traits>

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;

constexpr auto kPairs = static_cast<std::size_t>(RunFolder::kPairsPerBlock);
constexpr int kMostKilled = 100, kMostCrashes = 2;  // during one block

/// A worker's answer. The same program reads it, so its layout is free.
struct Message {
  bool good = false;
  DecisionCost cost[2];
  compare::Pair pairs[kPairs];
  char problem[2000] = {};
};
static_assert(std::is_trivially_copyable_v<Message>);

/// Sends all bytes. Returns false if the other end is closed.
bool send_all(int line, const void* bytes, std::size_t size) {
  const char* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = send(line, at, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent, size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int line, void* bytes, std::size_t size) {
  char* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = recv(line, at, size, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

Message play(const Comparison& comparison, std::int64_t block) {
  Message message;
  const auto played = comparison.play(block * RunFolder::kPairsPerBlock, RunFolder::kPairsPerBlock);
  if (!played) {
    std::strncpy(message.problem, played.error().c_str(), sizeof message.problem - 1);
    return message;
  }
  std::ranges::copy(played->pairs, message.pairs);
  for (const int behaviour : {0, 1}) message.cost[behaviour] = played->cost[behaviour];
  message.good = true;
  return message;
}

}  // namespace

Crew::~Crew() {
  for (const Worker& worker : workers_)
    if (worker.pid > 0) kill(worker.pid, SIGKILL);
  for (const Worker& worker : workers_)
    if (worker.pid > 0) waitpid(worker.pid, nullptr, 0);
}

bool Crew::has_somebody_idle() const {
  return std::ranges::any_of(workers_, [](const Worker& worker) { return worker.block < 0; });
}

Result<void> Crew::give(std::int64_t block) {
  const auto idle = std::ranges::find_if(workers_, [](const Worker& worker) { return worker.block < 0; });
  idle->block = block, idle->deaths = 0;
  return hand_out(*idle);
}

Result<void> Crew::hire(Worker& worker) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return Error{std::string("cannot start a worker: ") + std::strerror(errno)};
  robot::FileDescriptor ours(ends[0]), theirs(ends[1]);
  const pid_t self = getpid(), pid = fork();
  if (pid < 0) return Error{std::string("cannot start a worker: ") + std::strerror(errno)};
  if (pid == 0) {
    // end with the parent, also if it ended before this call
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != self) _exit(0);
    work(theirs.get());
  }
  worker.pid = pid, worker.line = std::move(ours);
  return {};
}

void Crew::work(int line) const {
  std::int64_t block = 0;
  while (receive_all(line, &block, sizeof block)) {
    const Message message = play(comparison_, block);
    if (!send_all(line, &message, sizeof message)) break;
  }
  _exit(0);
}

Result<void> Crew::hand_out(Worker& worker) {
  if (worker.pid < 0)
    if (auto hired = hire(worker); !hired) return hired;
  // a worker that has died meanwhile is noticed when its answer is read
  send_all(worker.line.get(), &worker.block, sizeof worker.block);
  return {};
}

/// Replaces a worker that died during its block.
Result<void> Crew::replace(Worker& worker) {
  int status = 0;
  waitpid(worker.pid, &status, 0);
  worker.pid = -1, worker.line.reset();
  ++worker.deaths;
  const bool killed = WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGTERM);
  if (worker.deaths < (killed ? kMostKilled : kMostCrashes)) return hand_out(worker);
  return Error{"block " + std::to_string(worker.block) + ": the worker that plays it died " +
               std::to_string(worker.deaths) + " times, the last time of " +
               (WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                    : "an end with status " + std::to_string(WEXITSTATUS(status)))};
}

std::optional<Result<PlayedBlock>> Crew::hear(Worker& worker) {
  Message message;
  if (!receive_all(worker.line.get(), &message, sizeof message)) {
    if (auto replaced = replace(worker); !replaced) return replaced.failure();
    return {};
  }
  if (!message.good) return Error{message.problem};
  PlayedBlock played{.number = worker.block, .pairs = {message.pairs, message.pairs + kPairs}};
  for (const int behaviour : {0, 1}) played.cost[behaviour] = message.cost[behaviour];
  worker.block = -1;
  return played;
}

std::optional<Result<PlayedBlock>> Crew::wait(Clock::time_point deadline) {
  while (true) {
    std::vector<pollfd> lines;
    std::vector<Worker*> playing;
    for (Worker& worker : workers_) {
      if (worker.block < 0) continue;
      lines.push_back({.fd = worker.line.get(), .events = POLLIN, .revents = 0});
      playing.push_back(&worker);
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return {};
    const int ready = poll(lines.data(), lines.size(), static_cast<int>(std::min<std::int64_t>(left, 1'000'000)));
    if (ready < 0 && errno != EINTR) return Error{std::string("cannot wait for the workers: ") + std::strerror(errno)};
    for (std::size_t i = 0; ready > 0 && i < lines.size(); ++i)
      if (lines[i].revents != 0)
        if (auto heard = hear(*playing[i])) return heard;
  }
}

}  // namespace sim::contest
