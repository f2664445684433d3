// The live protocol without sockets: clients, channels, and who gets what.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/clock.h"
#include "robot/net/foxglove/channel_table.h"
#include "robot/net/foxglove/client.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/inbox.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/playback.h"
#include "robot/net/foxglove/services.h"
#include "robot/net/foxglove/statistics.h"
#include "robot/net/foxglove/stream_control.h"

namespace robot::net {

struct HubOptions {
  std::string name = "foresight";
  std::map<std::string, std::string> metadata;  // {"build", "body", "robots"}
  QueueLimits queues;
  Playback* playback = nullptr;                  // of the recording that is played, if there is one; outlives the hub
  std::uint64_t pong_timeout_ns = 30 * kSecond;  // a client that does not answer a ping for so long is gone
};

/// Speaks the Foxglove protocol with any number of clients. What it says waits in the clients' queues; whoever owns
/// the sockets looks into all of them after each call. Used by one thread, the server's I/O thread.
class Hub {
 public:
  /// Orders do not wait for questions, which may take seconds. There is one question at a time, and one more may wait.
  enum class Kind { order, question };
  /// Does `work` on a thread of its kind that may wait, one piece after the other, then `then` on the hub's own.
  using InBackground = std::function<void(Kind kind, std::function<void()> work, std::function<void()> then)>;

  /// What is referenced outlives the hub.
  Hub(HubOptions options, Parameters& parameters, const Services& services, const Clock& clock, StreamControl& streams,
      InBackground in_background);

  /// Offers `channel`, and what `derive` makes of it, to everybody.
  void add_channel(const std::shared_ptr<memory::Channel>& channel, const Derive& derive);

  /// A client came; it is told who we are and what there is.
  std::shared_ptr<Client> join(ClientIdentity identity);

  /// The client went. It is forgotten, what only it watched is no longer carried, and what it asked is not begun any more.
  void leave(Client& client);

  /// A client said something. What we do not understand is answered with a status.
  void on_text(Client& client, std::string_view text);
  void on_binary(Client& client, std::string_view bytes);
  void on_pong(Client& client, std::uint64_t now_ns);

  /// A stream brought a message for everybody who watches its channel.
  void deliver(const Inbox::Item& item);

  /// Tells everybody the time. It never goes back, except after restart_time() and where a client moved the playback.
  void send_time();

  /// Another time line begins (playback went back): everybody gets a new session id and may see a smaller time.
  void restart_time();

  /// Match mode began or ended: see ClientContext::refusal().
  void set_match_mode(bool match_mode);

  /// Pings, gives up on clients that do not answer, tells who loses messages. Once a second.
  void every_second(std::uint64_t now_ns);

  /// Tells those who watch it the value of a parameter.
  void parameter_changed(const std::string& name);

  /// Sends a whole frame before any message; a client that has too many of them waiting is disconnected.
  void send(Client& client, std::string frame);

  /// Says why, then closes the connection.
  void disconnect(Client& client, std::uint16_t close_code, std::string_view sentence);

  ServerStatistics statistics() const;
  const std::vector<std::shared_ptr<Client>>& clients() const { return clients_; }

 private:
  std::string server_info() const;
  void say(Client& client, std::string_view text);
  void say_binary(Client& client, std::string_view bytes);
  void complain(Client& client, std::string_view sentence);
  void push(Client& client, std::uint32_t channel, const memory::VersionPtr& version);
  void note_gap(OfferedChannel& channel, std::uint64_t missing);
  void tell_drops(Client& client, std::uint64_t now_ns);
  void remove_subscriber(OfferedChannel& channel, Client& client);
  std::string playback_state(bool did_seek, std::string_view request_id) const;
  void tell_playback(bool did_seek, const Client* asker, const std::string& request_id);
  void tell_parameters(Client& client, const std::vector<std::string>& names, const std::optional<std::string>& id);

  // what a client asks for
  void handle(Client& client, const Result<foxglove::ClientMessage>& message);
  void handle(Client& client, const foxglove::Subscribe& message);
  void handle(Client& client, const foxglove::Unsubscribe& message);
  void handle(Client& client, const foxglove::GetParameters& message);
  void handle(Client& client, const foxglove::SetParameters& message);
  void answer(Client& client, const foxglove::ServiceCall& call, const std::string& text);
  void ask(Client& client, const foxglove::ServiceCall& question);
  void run_question();
  void in_turn(Client& client, std::function<std::string()> work,
               std::function<void(Client&, const std::string&)> then);
  void handle(Client& client, const foxglove::WatchParameters& message);
  void handle(Client& client, const foxglove::ServiceCall& message);
  void handle(Client& client, const foxglove::ClientPublish& message);
  void handle(Client& client, const foxglove::PlaybackControl& message);
  void handle(Client& client, const foxglove::Unsupported& message);
  void subscribe(Client& client, const foxglove::Subscribe::Item& item);

  const HubOptions options_;
  Parameters& parameters_;
  const Services& services_;
  const Clock& clock_;
  StreamControl& streams_;
  const InBackground in_background_;

  ChannelTable channels_;
  std::vector<std::shared_ptr<Client>> clients_;
  std::uint64_t last_client_ = 0;
  bool match_mode_ = false;
  std::uint64_t session_ = 0;  // [ms since the epoch] its begin
  std::uint64_t last_time_ns_ = 0;
  foxglove::Playback told_ = foxglove::Playback::playing;  // of the playback, last

  struct PendingCall {
    std::weak_ptr<Client> client;
    foxglove::ServiceCall call;
    std::uint64_t asked_ns = 0;  // [monotonic]
  };
  std::deque<PendingCall> questions_;  // of all clients: the first runs, one more may wait
};

}  // namespace robot::net
