// bench_fanout: what one message to one client costs a server, in CPU time of its process.
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <new>
#include <thread>

#include "robot/core/json_library.h"
#include "tests/bench/counting_client.h"
#include "tests/bench/fanout.h"

namespace bench {
namespace {

using std::chrono::milliseconds;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The other process: all clients in one thread. Its CPU time does not count.
int receive(const FanoutLoad& load, FanoutShared& shared) {
  while (shared.port == 0) std::this_thread::sleep_for(milliseconds(5));
  const robot::SessionClock clock;
  std::vector<std::unique_ptr<CountingClient>> clients;
  std::vector<pollfd> sockets;
  for (std::size_t i = 0; i < load.clients; ++i) {
    clients.push_back(std::make_unique<CountingClient>(
        CountingClient::Options{.url = "ws://127.0.0.1:" + std::to_string(shared.port) + "/?delivery=lossless",
                                .watch = {},
                                .parameters = {}},
        clock));
    if (auto connected = clients.back()->connect(); !connected) {
      std::fprintf(stderr, "bench_fanout: %s\n", connected.error().c_str());
      return 2;
    }
    sockets.push_back({clients.back()->socket(), POLLIN, 0});
  }
  while (!shared.ended) {
    poll(sockets.data(), sockets.size(), 20);
    for (std::size_t i = 0; i < clients.size(); ++i) {
      if (sockets[i].revents == 0) continue;
      if (!clients[i]->read()) {
        if (shared.ended) return 0;
        std::fprintf(stderr, "bench_fanout: a client was sent away: %s\n", clients[i]->reason().c_str());
        return 2;
      }
      shared.received[i] = clients[i]->messages();
    }
  }
  return 0;
}

/// Counts the arrived messages and this process's CPU time.
nlohmann::json watch(const FanoutLoad& load, FanoutShared& shared, double seconds) {
  for (int waited = 0; shared.least(load.clients) < 10 && waited < 500; ++waited)
    std::this_thread::sleep_for(milliseconds(10));
  std::this_thread::sleep_for(milliseconds(500));
  const auto counted_cpu = [&] { return cpu_seconds() - static_cast<double>(shared.making_ns) * 1e-9; };
  const double cpu_before = counted_cpu();
  const std::uint64_t before = shared.total(load.clients);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const double cpu = counted_cpu() - cpu_before;
  const auto messages = static_cast<double>(shared.total(load.clients) - before);
  return {{"messages", messages},
          {"cpu_seconds", cpu},
          {"per_cpu_second", cpu > 0 ? messages / cpu : 0},
          {"per_second", messages / seconds}};
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  CLI::App app{"What a message costs a server; a report in JSON"};
  bench::FanoutLoad load;
  std::string server = "ours";
  double seconds = 3;
  app.add_option("--server", server, "ours or beast")->check(CLI::IsMember({"ours", "beast"}));
  app.add_option("--bytes", load.payload_bytes, "of each message");
  app.add_option("--clients", load.clients, "who all get all")
      ->check(CLI::Range(std::size_t{1}, bench::kMaxFanoutClients));
  app.add_option("--seconds", seconds, "how long");
  CLI11_PARSE(app, argc, argv);

  void* pages = mmap(nullptr, sizeof(bench::FanoutShared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto& shared = *new (pages) bench::FanoutShared;
  const pid_t clients = fork();
  if (clients == 0) _exit(bench::receive(load, shared));

  nlohmann::json report;
  std::thread watching([&] {
    report = bench::watch(load, shared, seconds);
    shared.ended = true;
  });
  server == "ours" ? serve_ours(load, shared) : serve_beast(load, shared);
  watching.join();
  int status = 0;
  waitpid(clients, &status, 0);
  std::printf("%s\n", report.dump().c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
