// foresight-guardian: owns LoLA's socket on a Nao V6 and decides which values reach the joints.
#include <sched.h>
#include <sys/mman.h>
#include <sys/signalfd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include "robot/nao/guardian/guardian_client.h"
#include "robot/nao/guardian/guardian_program.h"

namespace robot::nao {
namespace {

constexpr int kDone = 0, kNo = 1, kBadInput = 2, kUnknown = 3;
constexpr int kPriority = 40;       // above all threads of the runtime, below those of the kernel
constexpr int kPatience_ms = 2000;  // for a report; at least one a second is sent

/// Returns a file from which the signals that end the process can be read.
FileDescriptor end_signals() {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  sigprocmask(SIG_BLOCK, &ends, nullptr);
  return FileDescriptor(signalfd(-1, &ends, SFD_CLOEXEC | SFD_NONBLOCK));
}

void become_real_time() {
  const sched_param priority{.sched_priority = kPriority};
  const bool locked = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  const bool first = sched_setscheduler(0, SCHED_FIFO, &priority) == 0;
  std::printf("real-time priority: %s; memory locked: %s\n", first ? "yes" : "not allowed",
              locked ? "yes" : "not allowed");
  std::fflush(stdout);
}

int fail(const std::string& sentence) {
  std::fprintf(stderr, "foresight-guardian: %s\n", sentence.c_str());
  return kBadInput;
}

int run(const GuardianOptions& options) {
  const FileDescriptor end = end_signals();
  Result<GuardianProgram> program = GuardianProgram::open(options);
  if (!program) return fail(program.error());
  become_real_time();
  program->run(end.get());
  return kDone;
}

/// Prints the robot's state. Returns 0 if a new guardian may be installed: the robot has no stiffness, or this guardian has
/// no LoLA and so holds no joint. Returns kUnknown while LoLA is connected but its frame could not be read.
int tell_status(const GuardianOptions& options) {
  Result<GuardianClient> client = GuardianClient::open(options.link);
  if (!client) return fail(client.error());
  const auto report = client->next(kPatience_ms);
  if (!report) return fail(report.error());
  if (!*report) return fail("guardian: expected a report within 2 s, got none");
  if ((*report)->has_lola && !(*report)->has_sensors) {
    std::printf("unknown: %s\n", (*report)->problem.data());
    return kUnknown;
  }
  if (!(*report)->has_lola) {
    std::printf("no LoLA: %s\n", (*report)->problem.data());
    return kDone;
  }
  const char* because = sentence_of((*report)->reason);
  std::printf("%s, %s%s%s\n", name_of((*report)->mode), name_of((*report)->doing), *because ? ": " : "", because);
  const bool soft = (*report)->doing == Doing::soft || (*report)->doing == Doing::fallen;
  return soft ? kDone : kNo;
}

int ask_soft(const GuardianOptions& options) {
  Result<GuardianClient> client = GuardianClient::open(options.link);
  if (!client) return fail(client.error());
  if (Result<void> asked = client->ask(Request::What::sit_and_soft); !asked) return fail(asked.error());
  return kDone;
}

int guardian_main(int argc, char** argv) {
  CLI::App app{
      "Owns LoLA's socket on a Nao V6: answers every frame in time, and decides which values reach the joints"};
  GuardianOptions options{.link = default_link()};
  bool status = false, soft = false;
  app.add_option("--lola", options.lola, "LoLA's socket")->capture_default_str();
  app.add_option("--link", options.link, "socket for the runtime; default: $FORESIGHT_GUARDIAN, or a name of this user")
      ->capture_default_str();
  app.add_flag("--status", status,
               "print the robot's state; exit status 0: no stiffness, or no LoLA; 1: stiffness; 3: LoLA is there, the "
               "state unknown");
  app.add_flag("--sit-and-soft", soft, "remove the stiffness at once, until the chest button is pressed");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  }
  if (status) return tell_status(options);
  return soft ? ask_soft(options) : run(options);
}

}  // namespace
}  // namespace robot::nao

int main(int argc, char** argv) { return robot::nao::guardian_main(argc, argv); }
