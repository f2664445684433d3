// The service that plays another session of the folder.
#pragma once

#include <filesystem>
#include <optional>

#include "robot/core/lock.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/net/foxglove/services.h"

namespace robot::app {

/// The session that a client wants to watch next. Any thread.
class WatchWish {
 public:
  void set(std::filesystem::path session);
  std::optional<std::filesystem::path> get() const;

 private:
  mutable Mutex lock_;
  std::optional<std::filesystem::path> session_;
};

/// Adds `watch_session`: {"session": name} -> {"ok": true}. It opens the session of the store for a check and then sets
/// `wish`, which the program fulfils; all its clients connect again. "game.mcap" names a file with many channels in the
/// store's folder. Both arguments outlive the services.
void add_watch_service(net::Services& services, const logging::SessionStore& store, WatchWish& wish);

}  // namespace robot::app
