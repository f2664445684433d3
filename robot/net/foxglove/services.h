// Services: questions and orders from clients, JSON in and JSON out.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/clock.h"
#include "robot/net/foxglove/to_client.h"

namespace robot::net {

/// The client of a call, and the call's time.
struct ClientContext {
  std::uint64_t id = 0;        // counts up; never used twice in one run
  std::string address;         // "10.0.14.7:51234"
  bool loopback = false;       // it runs on this machine
  bool may_control = false;    // it is on loopback or gave the token
  bool match_mode = false;     // a real game is in progress: only clients on this machine may control; all may ask
  std::uint64_t asked_ns = 0;  // [monotonic] arrival of the call
  std::optional<std::uint64_t> playhead_ns = {};  // the time of its own playhead in a recording, at the call

  /// Returns why it may not control now in one sentence, or an empty string if it may.
  std::string refusal() const;

  /// Returns the cause of a refusal for programs: "token" if the right token would help, else "game".
  std::string_view cause() const { return may_control ? "game" : "token"; }
};

/// Returns {"ok": false, "error": sentence}, the answer of a service that failed.
nlohmann::json failure(std::string_view sentence);

/// Returns the answer to a client that may not call a service: a failure with the field "cause".
nlohmann::json refused(std::string_view sentence, const ClientContext& client);

/// The list of services. It is filled before the server starts, then only read.
class Services {
 public:
  /// A function from a JSON object to a JSON object. Services for all clients run on the server's I/O thread and must
  /// not wait. Services for control run one after the other on a thread that may wait for the disk.
  /// Questions run one after the other on a thread that may take seconds. They are allowed during a game too, because the
  /// server then has no clients over wireless networks.
  using Handler = std::function<nlohmann::json(const nlohmann::json& request, const ClientContext& client)>;

  enum class For { everybody, control, questions };  // the last two need the token, except on loopback

  void add(std::string name, For whom, Handler handler);

  /// Returns all services, with ids from 1.
  std::vector<foxglove::Service> list() const;

  bool has(std::uint32_t id) const { return id >= 1 && id <= services_.size(); }
  For whom(std::uint32_t id) const { return services_.at(id - 1).whom; }
  const std::string& name(std::uint32_t id) const { return services_.at(id - 1).name; }

  /// Returns why `client` may not call the existing service `id` now, in one sentence that begins with its name.
  /// Returns an empty string if it may.
  std::string refusal(std::uint32_t id, const ClientContext& client) const;

  /// Returns the answer of service `id` to `request`, as JSON text. Errors and refusals are part of the answer.
  std::string call(std::uint32_t id, std::string_view request, const ClientContext& client) const;

 private:
  struct Entry {
    std::string name;
    For whom;
    Handler handler;
  };
  nlohmann::json answer(const Entry& entry, std::string_view request, const ClientContext& client) const;

  std::vector<Entry> services_;
};

/// The offset of a client's clock, measured by the client.
struct PeerClock {
  std::string peer;            // its address
  std::int64_t offset_ns = 0;  // to add to our time to get the client's
  std::optional<std::uint64_t> round_trip_ns;
};

/// Adds `clock_sync`, one half of an NTP-like exchange: {"sent_ns"} -> {"ok", "sent_ns", "received_ns"}, where
/// `received_ns` is the time of `clock`. The client may add its last measurement to its next call as "offset_ns"
/// and "round_trip_ns"; it is passed to `on_measured`.
void add_clock_sync(Services& services, const Clock& clock, std::function<void(const PeerClock&)> on_measured);

}  // namespace robot::net
