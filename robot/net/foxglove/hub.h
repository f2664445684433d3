// The live protocol without sockets: clients, channels and subscriptions.
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
  std::map<std::string, std::string> metadata;  // {"build", "body", "robots"}, and "rules" and "session" if known
  QueueLimits queues;
  Playback* playback = nullptr;                  // of the played recording, if any; outlives the hub
  std::uint64_t pong_timeout_ns = 30 * kSecond;  // without an answer to a ping in this time, the client is gone
};

/// A server of the Foxglove protocol for any number of clients. It writes into the clients' queues. The owner of the
/// sockets must look into all queues after each call. Used by one thread, the server's I/O thread.
class Hub {
 public:
  /// The kind of a client's call. Orders do not wait for questions, which may take seconds. One question runs at a
  /// time, and one more may wait.
  enum class Kind { order, question };
  /// Runs `work` in order on the thread of its kind, which may wait, and afterwards `then` on the hub's thread.
  using InBackground = std::function<void(Kind kind, std::function<void()> work, std::function<void()> then)>;

  /// All references must outlive the hub.
  Hub(HubOptions options, Parameters& parameters, const Services& services, const Clock& clock, StreamControl& streams,
      InBackground in_background);

  /// Offers `channel` and the channels that `derive` derives from it to all clients.
  void add_channel(const std::shared_ptr<memory::Channel>& channel, const Derive& derive);

  /// Adds a client, and sends it our name, channels and services.
  std::shared_ptr<Client> join(ClientIdentity identity);

  /// Removes a client that has gone. Streams that only it watched end, and its waiting calls are not begun.
  void leave(Client& client);

  /// Handles a message of a client. A message that we do not understand is answered with a status.
  void on_text(Client& client, std::string_view text);
  void on_binary(Client& client, std::string_view bytes);
  void on_pong(Client& client, std::uint64_t now_ns);

  /// Queues a stream's message for all clients that watch its channel.
  void deliver(const Inbox::Item& item);

  /// Sends the time to all clients. It goes back only after restart_time() or when a client moved the playback.
  void send_time();

  /// Begins another time line (playback went back). All clients that share it get a new session id and may see a smaller
  /// time.
  void restart_time();

  /// Sets an entry of the metadata. All clients get our introduction again, with the same session id.
  void set_metadata(const std::string& key, const std::string& value);

  /// Begins or ends match mode, see ClientContext::refusal().
  void set_match_mode(bool match_mode);

  /// Sends pings, disconnects clients that do not answer, and warns clients that lose messages. Call it once a second.
  void every_second(std::uint64_t now_ns);

  /// Sends the value of a parameter to the clients that watch it.
  void parameter_changed(const std::string& name);

  /// Sends a whole frame before any message. A client with too many waiting frames is disconnected.
  void send(Client& client, std::string frame);

  /// Sends the reason, then closes the connection.
  void disconnect(Client& client, std::uint16_t close_code, std::string_view sentence);

  ServerStatistics statistics() const;
  const std::vector<std::shared_ptr<Client>>& clients() const { return clients_; }

 private:
  std::string server_info() const;
  void say(Client& client, std::string_view text);
  void say_binary(Client& client, std::string_view bytes);
  void complain(Client& client, std::string_view sentence);
  void refuse(Client& client, std::string_view sentence);
  void push(Client& client, std::uint32_t channel, const memory::VersionPtr& version,
            std::optional<std::uint64_t> time_ns = {});
  void note_gap(Client& client, const OfferedChannel& channel, std::uint64_t missing);
  void tell_drops(Client& client, std::uint64_t now_ns);
  void remove_subscriber(OfferedChannel& channel, Client& client);
  void tell_playback(bool did_seek, const Client* asker, const std::string& request_id);
  void tell_own(Client& client, bool did_seek, std::string_view request_id);
  void follow_own(Client& client);
  std::unique_ptr<OwnPlayhead> own_playhead(Client& client, std::optional<std::uint64_t> from_ns);
  void change_playhead(Client& client, std::unique_ptr<OwnPlayhead> own);
  void begin_carrying(Client& client, OfferedChannel& channel);
  void end_carrying(Client& client, OfferedChannel& channel);
  void push_shared(Client& client, std::uint32_t channel, const memory::VersionPtr& version);
  void tell_parameters(Client& client, const std::vector<std::string>& names, const std::optional<std::string>& id);

  // requests of a client
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
  void handle(Client& client, const foxglove::ChoosePlayhead& message);
  void handle(Client& client, const foxglove::Unsupported& message);
  void subscribe(Client& client, const foxglove::Subscribe::Item& item);

  HubOptions options_;  // of these only the metadata changes
  Parameters& parameters_;
  const Services& services_;
  const Clock& clock_;
  StreamControl& streams_;
  const InBackground in_background_;

  ChannelTable channels_;
  std::vector<std::shared_ptr<Client>> clients_;
  std::uint64_t last_client_ = 0;
  bool match_mode_ = false;
  std::uint64_t session_ = 0;  // [ms since the epoch] begin of the time line
  std::uint64_t last_time_ns_ = 0;
  foxglove::Playback told_ = foxglove::Playback::playing;  // the state of the shared playback that was sent last

  /// A stream from the playhead of one client.
  struct OwnStream {
    Client* client = nullptr;
    std::uint32_t channel = 0;
    std::uint64_t last_sequence = 0;
  };
  std::map<std::uint64_t, OwnStream> own_streams_;  // by the number of the stream

  struct PendingCall {
    std::weak_ptr<Client> client;
    foxglove::ServiceCall call;
    std::uint64_t asked_ns = 0;                     // [monotonic]
    std::optional<std::uint64_t> playhead_ns = {};  // of the client's own playhead
  };
  std::deque<PendingCall> questions_;  // of all clients: the first runs, one more may wait
};

}  // namespace robot::net
