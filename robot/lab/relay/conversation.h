// One connection to a relayed robot, from its server's introduction to its end.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "robot/lab/relay/carried_channel.h"
#include "robot/lab/relay/robot_link.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::lab {

/// The state of a link that outlives one connection.
struct RobotLink::Past {
  std::string session;  // session id of the robot's server when messages were carried last
  std::int64_t shift_ns = 0;
  std::map<std::string, CarriedChannel> carried;  // by topic
  std::map<std::string, memory::ChannelInfo> images;
  std::set<std::string> told;  // sentences about items that are left out
};

/// The client's side of the protocol with the robot's server: clocks first, then subscriptions, then messages. Used by
/// the link's thread.
class Conversation {
 public:
  Conversation(RobotLink& link, net::WebSocketClient& client) : link_(link), client_(client) {}

  /// Processes a message of the server. A wrong item, such as a channel whose schema is unreadable, is left out and
  /// reported once; everything else goes on. An Error ends the connection: it cannot be written to, or the clock is too
  /// far off.
  Result<void> hear(const net::WebSocketClient::Message& message);

  /// Does everything that is due. Returns the time until which it may wait then [monotonic].
  Result<std::uint64_t> go_on();

  /// Returns whether the server publishes the time. Such a server is never silent for long.
  bool hears_time() const { return hears_time_; }

 private:
  struct Subscription {
    CarriedChannel* to = nullptr;
    bool jpeg = false;  // a foxglove.CompressedImage that becomes a foresight.Image
  };

  Result<void> hear_text(std::string_view text);
  Result<void> hear_binary(std::string_view bytes);
  void introduce(const net::foxglove::ServerInfo& info);
  void leave_out(const std::string& problem);
  Result<void> ask_time();
  Result<void> hear_time(std::string_view answer);
  Result<void> give_up_clock(const std::string& problem);
  Result<void> agree();
  Result<void> subscribe();
  std::optional<memory::ChannelInfo> wanted(const net::foxglove::Advertised& offered, bool& jpeg) const;
  CarriedChannel* channel_for(const memory::ChannelInfo& info);
  Result<void> take(const net::foxglove::MessageData& data);
  void update(const std::function<void(LinkStatus&)>& change);

  RobotLink& link_;
  net::WebSocketClient& client_;
  const std::uint64_t began_ns_ = monotonic_ns();

  bool introduced_ = false, hears_time_ = false, new_run_ = true, agreed_ = false;
  std::string session_, robot_;
  std::vector<net::foxglove::Advertised> offered_;  // not subscribed yet

  // clocks
  std::optional<std::uint32_t> clock_service_;
  std::uint32_t call_ = 0;                         // the last one
  std::uint64_t sent_ns_ = 0;                      // of the call that has no answer yet, our clock; 0: none
  std::uint64_t asked_ns_ = 0, next_call_ns_ = 0;  // [monotonic]
  std::uint32_t rounds_ = 0;
  std::optional<ClockOffset> best_, last_;

  std::uint32_t last_subscription_ = 0;
  std::map<std::uint32_t, Subscription> subscriptions_;
};

}  // namespace robot::lab
