#include "robot/app/services/watch_service.h"

#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "robot/body/replay/replay.h"
#include "robot/core/folder.h"
#include "robot/core/json_library.h"

namespace robot::app {
namespace {

/// Returns the MCAP file with many channels that lies beside the sessions, or nothing.
std::optional<std::filesystem::path> file_called(const logging::SessionStore& store, const std::string& name) {
  const std::filesystem::path path(name);
  if (path.filename() != path || path.extension() != ".mcap") return {};
  const std::filesystem::path file = store.folder() / path;
  if (!is_plain_file(file)) return {};
  return file;
}

Result<std::filesystem::path> playable(const logging::SessionStore& store, const std::string& name) {
  if (auto file = file_called(store, name)) {
    if (const auto replay = body::Replay::open({*file}, {}); !replay) return replay.failure();
    return *file;
  }
  const Result<logging::Session> session = store.find(name);
  if (!session) return session.failure();
  if (session->state == logging::SessionState::recording)
    return Error{"session " + name + ": it is still being recorded; watch it when it is complete"};
  if (const auto replay = body::Replay::open({session->folder}, {}); !replay) return replay.failure();
  return session->folder;
}

}  // namespace

void WatchWish::set(std::filesystem::path session) {
  const std::lock_guard guard(lock_);
  session_ = std::move(session);
}

std::optional<std::filesystem::path> WatchWish::get() const {
  const std::lock_guard guard(lock_);
  return session_;
}

void add_watch_service(net::Services& services, const logging::SessionStore& store, WatchWish& wish) {
  services.add("watch_session", net::Services::For::control,
               [&](const nlohmann::json& request, const net::ClientContext&) {
                 const auto name = request.find("session");
                 if (name == request.end() || !name->is_string())
                   return net::failure("watch_session: expected {\"session\": the name of a session}");
                 auto session = playable(store, name->get<std::string>());
                 if (!session) return net::failure("watch_session: " + session.error());
                 wish.set(std::move(*session));
                 return nlohmann::json{{"ok", true}};
               });
}

}  // namespace robot::app
