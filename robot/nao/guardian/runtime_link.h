// The guardian's end of the link: whom it tells, and who tells it.
#pragma once

#include <poll.h>

#include <filesystem>
#include <list>
#include <optional>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/result.h"
#include "robot/nao/guardian/link.h"

namespace robot::nao {

/// Where guardian and runtime meet: $FORESIGHT_GUARDIAN, or a name of this user's in shared memory.
std::filesystem::path default_link();

/// Nothing here waits: who does not read misses reports, who says nothing is not heard.
///
/// The first connection that gives an order is the runtime's, until it ends; orders of others count for nothing. Requests
/// are everybody's.
class RuntimeLink {
 public:
  static constexpr std::size_t kMaxConnections = 8;

  /// What was said since the last time.
  struct Heard {
    std::optional<Order> order;  // the newest
    bool asked_soft = false, runtime_left = false, runtime_crashed = false;
  };

  /// For this user's programs only; an Error if another guardian listens there.
  static Result<RuntimeLink> open(const std::filesystem::path& path);

  /// Adds what must be waited for.
  void add_to(std::vector<pollfd>& files) const;

  Heard hear();
  void tell(const Report& report);

 private:
  struct Connection {
    FileDescriptor socket;
    bool is_runtime = false, says_goodbye = false, ended = false;
  };

  explicit RuntimeLink(FileDescriptor listening) : listening_(std::move(listening)) {}
  void take_in();
  void hear(Connection& connection, Heard& heard);
  bool has_runtime() const;

  FileDescriptor listening_;
  std::list<Connection> connections_;
};

}  // namespace robot::nao
