// The guardian's end of the link: connections of the runtime and of other clients.
#pragma once

#include <poll.h>

#include <cstdint>
#include <filesystem>
#include <list>
#include <optional>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

/// Returns the path of the link: $FORESIGHT_GUARDIAN, or a name of this user in shared memory.
std::filesystem::path default_link();

/// The listening socket and its connections. No call waits: a client that does not read misses reports.
///
/// The first connection that sends an order is the runtime, until it ends. Orders of other connections are ignored.
/// Every client may send requests. If there are kMaxConnections, a new one takes the place of the oldest that has sent
/// nothing, so that silent ones do not keep the runtime out. Without a free file descriptor it accepts none for 100 ms.
class RuntimeLink {
 public:
  static constexpr std::size_t kMaxConnections = 8;

  /// Messages and events since the last call of hear().
  struct Heard {
    std::optional<Order> order;  // the newest
    bool asked_soft = false, runtime_left = false, runtime_crashed = false;
  };

  /// Listens at `path` for programs of this user only. Returns an Error if another guardian listens there.
  static Result<RuntimeLink> open(const std::filesystem::path& path);

  /// Adds the files to poll.
  void add_to(std::vector<pollfd>& files) const;

  Heard hear();
  void tell(const Report& report);

 private:
  struct Connection {
    FileDescriptor socket;
    bool is_runtime = false, says_goodbye = false, ended = false;
    bool was_heard = false, spoke = false;
  };

  explicit RuntimeLink(FileDescriptor listening) : listening_(std::move(listening)) {}
  void take_in();
  bool make_room();
  void hear(Connection& connection, Heard& heard);
  bool has_runtime() const;

  FileDescriptor listening_;
  std::uint64_t rests_until_ns_ = 0;  // [monotonic] it accepts nothing before
  std::list<Connection> connections_;
};

}  // namespace robot::nao
