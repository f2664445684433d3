// bench_client: any number of viewers in one thread, which count the messages that they receive.
#include <poll.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <deque>
#include <memory>
#include <random>

#include "robot/core/clock.h"
#include "robot/core/json_library.h"
#include "tests/bench/counting_client.h"
#include "tests/bench/load.h"

namespace bench {
namespace {

using nlohmann::json;
using robot::kMillisecond;
using robot::kSecond;
using robot::monotonic_ns;

constexpr std::size_t kNoLimit = SIZE_MAX;

struct Options {
  std::string url = "ws://127.0.0.1:8765", watch = "objects";
  std::vector<std::string> parameters;
  std::size_t clients = 1;
  double seconds = 10;
  double stall_after = -1;  // [s] from this time on it reads nothing; < 0: never
  double bytes_per_second = 0;
  double lifetime = 0;  // [s] mean time of a connection; 0: no end
  int receive_buffer_bytes = 0;
};

std::atomic<bool> ended = false;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

json to_json(const TopicCount& topic, bool counted) {
  const double seconds = static_cast<double>(topic.last_ns - topic.first_ns) * 1e-9;
  const auto age_ms = [&](double p) { return percentile(topic.ages_us, p) / 1000.0; };
  json result{{"messages", topic.messages},
              {"bytes", topic.bytes},
              {"rate_hz", topic.messages > 1 ? static_cast<double>(topic.messages - 1) / seconds : 0},
              {"age_p50_ms", age_ms(0.5)},
              {"age_p95_ms", age_ms(0.95)},
              {"age_p99_ms", age_ms(0.99)},
              {"age_max_ms", age_ms(1)}};
  if (counted) result["missed"] = topic.missed;
  return result;
}

json to_json(const CountingClient& client) {
  json topics = json::object();
  for (const auto& [name, topic] : client.topics()) topics[name] = to_json(topic, is_counted(name));
  return {{"messages", client.messages()},
          {"bytes", client.bytes()},
          {"ended", client.reason()},
          {"statuses", client.statuses()},
          {"topics", topics}};
}

/// A place for one client at a time; with a lifetime, clients follow each other.
class Seat {
 public:
  Seat(const Options& options, CountingClient::Options client, unsigned seed)
      : options_(options), client_options_(std::move(client)), random_(seed) {}

  robot::Result<void> sit(std::uint64_t now_ns) {
    client_ = std::make_unique<CountingClient>(client_options_, clock_);
    since_ns_ = now_ns;
    stalls_ = false;
    leaves_ns_ = UINT64_MAX;
    if (options_.lifetime > 0) {
      const double stay = options_.lifetime * std::uniform_real_distribution(0.0, 2.0)(random_);
      leaves_ns_ = now_ns + static_cast<std::uint64_t>(stay * 1e9);
      stalls_ = random_() % 8 == 0;  // some viewers sleep
    }
    auto connected = client_->connect();
    if (connected) ++connections_;
    return connected;
  }

  /// Number of bytes that it may read now; slow clients may read a few from time to time.
  std::size_t may_read(std::uint64_t now_ns) const {
    const double seconds = static_cast<double>(now_ns - since_ns_) * 1e-9;
    if (stalls_ || (options_.stall_after >= 0 && seconds >= options_.stall_after)) return 0;
    if (options_.bytes_per_second <= 0) return kNoLimit;
    const auto allowed = static_cast<std::uint64_t>(seconds * options_.bytes_per_second);
    return allowed > client_->bytes() ? allowed - client_->bytes() : 0;
  }

  void read(std::size_t most) {
    if (!client_->read(most)) gone_ = true;
  }

  /// Disconnects and connects again after its lifetime, or when the server disconnected it.
  void move_on(std::uint64_t now_ns) {
    // a client that was disconnected tries again after a moment
    if (options_.lifetime <= 0 || now_ns < (gone_ ? since_ns_ + kSecond / 2 : leaves_ns_)) return;
    messages_ += client_->messages();
    gone_ = !sit(now_ns);
  }

  bool gone() const { return gone_; }
  bool stays() const { return options_.lifetime <= 0; }
  std::uint64_t connections() const { return connections_; }
  std::uint64_t messages() const { return messages_ + client_->messages(); }
  const CountingClient& client() const { return *client_; }

 private:
  const Options& options_;
  const CountingClient::Options client_options_;
  const robot::SessionClock clock_;
  std::mt19937 random_;
  std::unique_ptr<CountingClient> client_;
  bool gone_ = false, stalls_ = false;
  std::uint64_t since_ns_ = 0, leaves_ns_ = UINT64_MAX;
  std::uint64_t connections_ = 0, messages_ = 0;
};

void serve(std::deque<Seat>& seats, std::uint64_t until_ns) {
  std::vector<pollfd> sockets(seats.size());
  for (std::uint64_t now = monotonic_ns(); now < until_ns && !ended; now = monotonic_ns()) {
    bool slow = false, somebody = false;
    for (std::size_t i = 0; i < seats.size(); ++i) {
      seats[i].move_on(now);
      const std::size_t most = seats[i].gone() ? 0 : seats[i].may_read(now);
      sockets[i] = {most > 0 ? seats[i].client().socket() : -1, POLLIN, 0};
      slow |= most != kNoLimit;
      somebody |= !seats[i].gone();
    }
    if (!somebody && seats.front().stays()) return;
    const std::uint64_t longest = (slow ? 5 : 50) * kMillisecond;
    poll(sockets.data(), sockets.size(), static_cast<int>(std::min(until_ns - now, longest) / kMillisecond + 1));
    for (std::size_t i = 0; i < seats.size(); ++i)
      if (sockets[i].revents != 0) seats[i].read(seats[i].may_read(now));
  }
}

int run(const Options& options) {
  const auto watch = parse_watch(options.watch);
  if (!watch) return std::fprintf(stderr, "bench_client: %s\n", watch.error().c_str()), 2;
  CountingClient::Options client{
      .url = options.url, .watch = *watch, .receive_buffer_bytes = options.receive_buffer_bytes, .parameters = {}};
  for (const std::string& parameter : options.parameters)
    client.parameters[parameter.substr(0, parameter.find('='))] = parameter.substr(parameter.find('=') + 1);

  std::deque<Seat> seats;
  for (std::size_t i = 0; i < options.clients; ++i) {
    seats.emplace_back(options, client, static_cast<unsigned>(i + 1));
    if (auto connected = seats.back().sit(monotonic_ns()); !connected)
      return std::fprintf(stderr, "bench_client: %s\n", connected.error().c_str()), 2;
  }
  const std::uint64_t started = monotonic_ns();
  serve(seats, started + static_cast<std::uint64_t>(options.seconds * 1e9));
  const double seconds = static_cast<double>(monotonic_ns() - started) * 1e-9;

  json report{{"seconds", seconds}, {"cpu_seconds", cpu_seconds()}, {"clients", json::array()}};
  std::uint64_t connections = 0, messages = 0;
  for (const Seat& seat : seats) {
    connections += seat.connections(), messages += seat.messages();
    if (options.lifetime <= 0) report["clients"].push_back(to_json(seat.client()));
  }
  report["connections"] = connections, report["messages"] = messages;
  std::printf("%s\n", report.dump().c_str());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  CLI::App app{"Viewers that count what they get; a report in JSON at the end, also when stopped by SIGTERM"};
  bench::Options options;
  app.add_option("--url", options.url, "of the server, with ?delivery=lossless where all is wanted");
  app.add_option("--watch", options.watch,
                 "objects, images, jpeg, topics such as /truth/world, several with commas, or nothing");
  app.add_option("--set", options.parameters, "name=value: a parameter to set first");
  app.add_option("--clients", options.clients, "so many of them");
  app.add_option("--seconds", options.seconds, "how long");
  app.add_option("--stall-after", options.stall_after, "[s] reads nothing from then on");
  app.add_option("--bytes-per-second", options.bytes_per_second, "reads slowly");
  app.add_option("--receive-buffer", options.receive_buffer_bytes, "[bytes] of the kernel");
  app.add_option("--lifetime", options.lifetime, "[s] mean stay of a viewer; then another one comes in its place");
  CLI11_PARSE(app, argc, argv);
  std::signal(SIGTERM, [](int) { bench::ended = true; });
  return bench::run(options);
}
