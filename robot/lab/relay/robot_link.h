// The only connection to a live robot that is relayed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/lab/clocks/clock_offset.h"
#include "robot/lab/relay/robot_address.h"
#include "robot/lab/relay/topic_claims.h"
#include "robot/memory/channels.h"
#include "robot/net/websocket/web_socket_client.h"

namespace robot::lab {

/// The form in which camera images are fetched.
enum class Pictures {
  jpeg,  // as JPEG, at the robot's rate: a wireless network can carry them
  raw,   // unchanged from the robot's memory
  none,
};

/// The options of one link.
struct LinkOptions {
  RobotAddress robot;
  Pictures pictures = Pictures::jpeg;
  std::vector<std::string> objects = {};        // those of the robot that are fetched, such as "pose"; empty: all
  bool lossless = false;                        // receive every message; otherwise the robot ends the connection
  std::uint64_t most_offset_ns = 60 * kSecond;  // greatest accepted offset of the robot's clock
  // gets the rules of the robot's game, if it reports them, before its first message; by the link's thread; may be empty
  std::function<void(const std::string& rules)> on_rules = {};
};

/// The state of one link.
struct LinkStatus {
  enum class State { connecting, connected, refused };

  State state = State::connecting;
  std::string name, address, robot;  // name and address without a token; "14/2", empty until the robot has sent it
  std::uint64_t received = 0;        // [messages] written to our channels
  std::uint64_t lost = 0;            // [messages] missing, as far as the robot numbers them
  std::uint32_t connections = 0;
  std::optional<ClockOffset> clock;  // of the robot to ours; nothing: the server has no clock_sync
  std::int64_t shift_ns = 0;         // added to the robot's times
  std::string problem;               // one sentence, empty while connected
};

/// The link that carries all channels of a robot's server into channels of this process, on its own thread, over one
/// connection. It connects again half a second after the connection ended, and after 3 s of silence. The robot's clock
/// is compared with ours before the first message. Topics and schemas stay the same, and times unless the clock is off.
/// Channels that the server derives from others are left out, because our server derives them again. Services and
/// parameters of the robot are not passed on.
class RobotLink {
 public:
  /// A function that receives each measurement of the robot's clock. Called by the link's thread.
  using OnClock = std::function<void(const std::string& robot, const ClockOffset& offset)>;

  /// All references outlive the link. `clock` is our time. `id` is different for each link.
  RobotLink(int id, LinkOptions options, memory::Channels& channels, TopicClaims& claims, const Clock& clock,
            OnClock on_clock);

  /// Starts the thread, once. Returns an Error if the system allows no more threads.
  Result<void> start();

  /// Calls stop().
  ~RobotLink();

  /// Ends the connection and the thread. A second call has no effect.
  void stop();

  /// Returns the current state. Called by any thread.
  LinkStatus status() const;

 private:
  friend class Conversation;

  void run();
  Result<void> converse(const std::string& address);  // returns without an Error only when the link stops
  std::shared_ptr<net::WebSocketClient> new_client();
  void ended(const std::string& sentence);
  bool wait(std::uint64_t duration_ns);

  const int id_;
  const LinkOptions options_;
  memory::Channels& channels_;
  TopicClaims& claims_;
  const Clock& clock_;
  const OnClock on_clock_;

  // used by the link's thread only: the state that outlives a connection
  struct Past;
  const std::unique_ptr<Past> past_;

  mutable Mutex lock_;  // guards the rest
  Condition changed_;
  LinkStatus status_;
  LinkStatus::State told_ = LinkStatus::State::connecting;  // at the last reported problem
  std::shared_ptr<net::WebSocketClient> client_;
  bool stopping_ = false;
  std::thread thread_;  // last, because it uses all the others
};

/// Asks the server at one of the addresses for the name of its robot ("14/2"). Returns an Error if none answers in
/// time.
Result<std::string> ask_name(const RobotAddress& robot, std::uint64_t timeout_ns);

}  // namespace robot::lab
