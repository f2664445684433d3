#include "robot/lab/relay/robot_link.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "robot/lab/relay/conversation.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::lab {
namespace {

constexpr std::uint64_t kConnectNs = 3 * kSecond, kSilenceNs = 3 * kSecond;
constexpr std::uint64_t kAgainNs = kSecond / 2, kAgainRefusedNs = 5 * kSecond;

std::string without_query(const std::string& address) { return address.substr(0, address.find('?')); }

/// Returns the address with the queries for numbered messages and for lossless delivery, which our servers understand.
std::string asking_for(const std::string& address, bool lossless) {
  return address + (address.find('?') == std::string::npos ? "?" : "&") + "numbered" +
         (lossless ? "&delivery=lossless" : "");
}

}  // namespace

RobotLink::RobotLink(int id, LinkOptions options, memory::Channels& channels, TopicClaims& claims, const Clock& clock,
                     OnClock on_clock)
    : id_(id),
      options_(std::move(options)),
      channels_(channels),
      claims_(claims),
      clock_(clock),
      on_clock_(std::move(on_clock)),
      past_(std::make_unique<Past>()) {
  status_.name = options_.robot.name;
}

Result<void> RobotLink::start() {
  return start_thread(thread_, "relay", [this] { run(); });
}

RobotLink::~RobotLink() { stop(); }

void RobotLink::stop() {
  {
    const std::lock_guard guard(lock_);
    stopping_ = true;
    if (client_) client_->cancel();
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

LinkStatus RobotLink::status() const {
  const std::lock_guard guard(lock_);
  return status_;
}

void RobotLink::run() {
  become_background_thread("relay");
  for (std::size_t tries = 0;; ++tries) {
    const std::string& address = options_.robot.addresses[tries % options_.robot.addresses.size()];
    {
      const std::lock_guard guard(lock_);
      status_.address = without_query(address);
    }
    if (const Result<void> talked = attempt("a conversation", [&] { return converse(address); }); !talked)
      ended(talked.error());
    if (!wait(status().state == LinkStatus::State::refused ? kAgainRefusedNs : kAgainNs)) return;
  }
}

/// Reports the reason of a failed connection, once until the next success or a reason of another kind.
void RobotLink::ended(const std::string& sentence) {
  std::string told;
  {
    const std::lock_guard guard(lock_);
    const bool is_news =
        status_.state == LinkStatus::State::connected || status_.problem.empty() || status_.state != told_;
    if (status_.state == LinkStatus::State::connected) status_.state = LinkStatus::State::connecting;
    told_ = status_.state;
    status_.problem = sentence;
    // the sentences of the connection itself begin with its address, which may be the robot's name
    const std::string who = status_.name + ": ";
    if (is_news && !stopping_) told = (sentence.starts_with(who) ? "" : who) + sentence + "; connecting again";
  }
  if (!told.empty()) report(Level::warning, "relay", told);
}

/// Waits. Returns false if the link stops.
bool RobotLink::wait(std::uint64_t duration_ns) {
  const std::uint64_t until_ns = monotonic_ns() + duration_ns;
  const std::lock_guard guard(lock_);
  while (!stopping_ && monotonic_ns() < until_ns) changed_.wait_until(lock_, until_ns);
  return !stopping_;
}

/// Creates the client of the next connection. Returns null if the link stops.
std::shared_ptr<net::WebSocketClient> RobotLink::new_client() {
  const std::lock_guard guard(lock_);
  if (stopping_) return nullptr;
  client_ = std::make_shared<net::WebSocketClient>();
  return client_;
}

Result<void> RobotLink::converse(const std::string& address) {
  const std::shared_ptr<net::WebSocketClient> client = new_client();
  if (!client) return {};
  if (Result<void> connected = client->connect(asking_for(address, options_.lossless), kConnectNs); !connected)
    return connected;
  Conversation conversation(*this, *client);
  std::uint64_t heard_ns = monotonic_ns();
  while (true) {
    const Result<std::uint64_t> until_ns = conversation.go_on();
    if (!until_ns) return until_ns.failure();
    const std::uint64_t silent_ns = conversation.hears_time() ? heard_ns + kSilenceNs : UINT64_MAX;
    const auto message = client->receive(std::min(*until_ns, silent_ns));
    const std::uint64_t now_ns = monotonic_ns();
    if (!message) {
      if (now_ns >= silent_ns) return Error{"no message for 3 s"};
      if (now_ns >= *until_ns) continue;  // any other error returns with the next call
      return message.failure();
    }
    if (!*message) return Error{"it ended the connection" + (client->closed() ? ": " + client->closed()->reason : "")};
    heard_ns = now_ns;
    if (Result<void> heard = conversation.hear(**message); !heard) return heard;
  }
}

Result<std::string> ask_name(const RobotAddress& robot, std::uint64_t timeout_ns) {
  Error problem{robot.name + ": it has no address"};
  for (const std::string& address : robot.addresses) {
    net::WebSocketClient client;
    if (const Result<void> connected = client.connect(address, timeout_ns); !connected) {
      problem = connected.failure();
      continue;
    }
    const auto message = client.receive(monotonic_ns() + timeout_ns);
    if (!message || !*message) continue;
    const auto said = net::foxglove::parse_server_text((*message)->payload);
    if (!said || !said->info) continue;
    const auto found = said->info->metadata.find("robots");
    if (found != said->info->metadata.end()) return found->second;
  }
  return problem;
}

}  // namespace robot::lab
