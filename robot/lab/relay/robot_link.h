// The one connection to a live robot that is relayed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/lab/clocks/clock_offset.h"
#include "robot/lab/relay/robot_address.h"
#include "robot/lab/relay/topic_claims.h"
#include "robot/memory/channels.h"
#include "robot/net/websocket/web_socket_client.h"

namespace robot::lab {

/// How the pictures of a robot's cameras are fetched.
enum class Pictures {
  jpeg,  // as JPEG, as many a second as the robot makes: what a wireless network can carry
  raw,   // as they are in its memory
  none,
};

struct LinkOptions {
  RobotAddress robot;
  Pictures pictures = Pictures::jpeg;
  bool lossless = false;                        // every message, or the robot ends the connection
  std::uint64_t most_offset_ns = 60 * kSecond;  // a clock further off is refused
};

/// How one robot is doing.
struct LinkStatus {
  enum class State { connecting, connected, refused };

  State state = State::connecting;
  std::string name, address, robot;  // as it was called, without a token; "14/2", empty before it said so
  std::uint64_t received = 0;        // [messages] entered
  std::uint64_t lost = 0;            // [messages] that did not get here, as far as the robot numbers them
  std::uint32_t connections = 0;
  std::optional<ClockOffset> clock;  // of the robot against ours; nothing: it cannot be asked
  std::int64_t shift_ns = 0;         // added to its times
  std::string problem;               // one sentence, empty while connected
};

/// Carries all that a robot's server offers into channels of this process, on a thread of its own, over one connection
/// that comes back by itself: half a second after it ended, or when nothing was heard for three. Before anything is
/// carried the robot's clock is compared with ours. Topics, schemas and times stay as they are (unless the clock is
/// off); what the server derives from other channels is left out, for whoever serves these derives it again.
/// Services and parameters of the robot are not passed on.
class RobotLink {
 public:
  /// Hears of each measurement of the robot's clock. Called by the link's thread.
  using OnClock = std::function<void(const std::string& robot, const ClockOffset& offset)>;

  /// Starts at once. The given ones outlive the link; `clock` is our time; `id` tells links apart.
  RobotLink(int id, LinkOptions options, memory::Channels& channels, TopicClaims& claims, const Clock& clock,
            OnClock on_clock);

  /// As stop().
  ~RobotLink();

  void stop();

  /// Any thread.
  LinkStatus status() const;

 private:
  friend class Conversation;

  void run();
  Result<void> converse(const std::string& address);  // no Error: the link is to end
  std::shared_ptr<net::WebSocketClient> new_client();
  void ended(const std::string& sentence);
  bool wait(std::uint64_t duration_ns);

  const int id_;
  const LinkOptions options_;
  memory::Channels& channels_;
  TopicClaims& claims_;
  const Clock& clock_;
  const OnClock on_clock_;

  // of the link's thread: what outlives a connection
  struct Past;
  const std::unique_ptr<Past> past_;

  mutable Mutex lock_;  // guards the rest
  Condition changed_;
  LinkStatus status_;
  LinkStatus::State told_ = LinkStatus::State::connecting;  // with the last problem
  std::shared_ptr<net::WebSocketClient> client_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all the others
};

/// Which robot ("14/2") the server at one of these addresses is the runtime of; an Error where none answers in time.
Result<std::string> ask_name(const RobotAddress& robot, std::uint64_t timeout_ns);

}  // namespace robot::lab
