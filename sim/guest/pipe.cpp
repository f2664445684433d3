#include "sim/guest/pipe.h"

#include "sim/guest/process.h"
#include "sim/guest/wire.h"

namespace sim::guest {
namespace {

using robot::Error;
using robot::Result;

constexpr double kFirstPatience = 30, kPatience = 5;  // [s] timeouts; libraries are loaded before the first answer

/// Returns the error in its answer to the greeting.
std::string greet(Process& process, const ForesightPlayer& player) {
  const auto answer = process.ask(greeting_of(player), kFirstPatience);
  return answer ? check_greeting(*answer) : answer.error();
}

class PipeGuest final : public GuestBehaviour {
 public:
  PipeGuest(std::string name, std::uint64_t seed, std::string command)
      : GuestBehaviour(std::move(name), seed), command_(std::move(command)) {}

 private:
  std::string ask(const ForesightPlayer& player, const ForesightMoment& moment, ForesightCommand& command) override {
    if (!process_) {
      auto started = Process::start(command_);
      if (!started) return started.error();
      process_ = std::make_unique<Process>(*std::move(started));
      if (std::string wrong = greet(*process_, player); !wrong.empty()) return wrong;
    }
    const auto answer = process_->ask(question_of(player, moment), kPatience);
    return answer ? read_answer(*answer, player, command) : answer.error();
  }

  const std::string command_;
  std::unique_ptr<Process> process_;  // one per game: games do not influence each other
};

class Pipe final : public GuestFactory {
 public:
  Pipe(std::string name, std::string command) : name_(std::move(name)), command_(std::move(command)) {}

  std::unique_ptr<GuestBehaviour> begin(std::uint64_t seed) const override {
    return std::make_unique<PipeGuest>(name_, seed, command_);
  }
  bool saves() const override { return false; }

 private:
  const std::string name_, command_;
};

}  // namespace

Result<std::shared_ptr<const GuestFactory>> open_pipe(const std::string& name, const std::string& command) {
  const std::string called = "behaviour '" + name + "': ";
  if (command.find_first_not_of(' ') == command.npos) return Error{called + "expected a command behind pipe:"};
  auto process = Process::start(command);
  if (!process) return Error{called + process.error()};
  if (const std::string wrong = greet(*process, ForesightPlayer{}); !wrong.empty()) return Error{called + wrong};
  return std::shared_ptr<const GuestFactory>(std::make_shared<Pipe>(name, command));
}

}  // namespace sim::guest
