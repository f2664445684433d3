// The answers of the HTTP API about this process: its state, its sessions and their downloads.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "robot/app/services/game_service.h"
#include "robot/core/byte_source.h"
#include "robot/core/clock.h"
#include "robot/logging/recent/recent_past.h"
#include "robot/logging/sessions/checksums.h"
#include "robot/logging/sessions/downloads.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/net/serve/backend.h"

namespace robot::app {

/// The names of this process, as the status reports them.
struct Identity {
  std::string name;                 // of the program: "foresight-robot"
  std::string body;                 // "replay", "sim", …
  std::vector<std::string> robots;  // "14/2"
  std::string session_id;           // of this run of the server
};

/// Makes one more file for a download of `recorded`, with what other viewers draw: see foxglove_download.h.
using FoxgloveFile = std::function<Result<std::shared_ptr<const ByteSource>>(
    std::shared_ptr<const ByteSource> recorded, const std::filesystem::path& folder, const std::string& rules,
    const net::ClientLeft& left)>;

/// The backend of the server. Used by any thread.
class Application final : public net::Backend {
 public:
  /// `clock`, `store` and `recorder` outlive this. `recorder` is null in a process that does not record.
  Application(Identity identity, const Clock& clock, logging::SessionStore& store, const logging::Recorder* recorder)
      : identity_(std::move(identity)), clock_(clock), store_(store), recorder_(recorder) {}

  /// Sets the function that counts the clients. Each status calls it. Call this before the server starts.
  void count_clients_by(std::function<std::size_t()> count) { count_clients_ = std::move(count); }

  /// Sets the function that returns the state of the game. Each status calls it; without it the game's fields are
  /// empty. Call this before the server starts.
  void tell_game_by(std::function<GameStatus()> game) { game_ = std::move(game); }

  /// Sets the function that answers requests for parts of the played recording. Without it such requests get 404.
  /// Call this before the server starts.
  void play_by(std::function<net::HttpResponse(const net::PlayedRequest&)> played) { played_ = std::move(played); }

  /// Sets the function that makes downloads with `?foxglove`. Without it such requests get 404. Call this before the
  /// server starts.
  void draw_downloads_by(FoxgloveFile foxglove_file) { foxglove_file_ = std::move(foxglove_file); }

  /// Sets the function that answers questions about the whole played recording, likewise.
  void know_whole_by(std::function<net::HttpResponse(const net::Target&, const net::ClientLeft&)> whole) {
    whole_ = std::move(whole);
  }

  /// Sets the last minutes of this process, which outlive this. Without them a request gets 404. Call this before the
  /// server starts.
  void recall_from(logging::RecentPast& recent) { recent_ = &recent; }

  std::string status_json() override;
  std::string sessions_json() override;
  Result<net::LogFile> open_log(const net::LogRequest& request) override;
  net::HttpResponse session_files(const std::string& session, const net::ClientLeft& left) override;
  net::HttpResponse delete_session(const std::string& session) override;
  net::HttpResponse played(const net::PlayedRequest& request) override {
    return played_ ? played_(request) : net::Backend::played(request);
  }
  net::HttpResponse whole(const net::Target& target, const net::ClientLeft& left) override {
    return whole_ ? whole_(target, left) : net::Backend::whole(target, left);
  }
  net::HttpResponse report_page(const std::string& page) override;
  net::HttpResponse recent(const std::vector<std::string>& topics) override;
  bool match_mode() const override;

 private:
  const Identity identity_;
  const Clock& clock_;
  logging::SessionStore& store_;
  const logging::Recorder* const recorder_;
  std::function<std::size_t()> count_clients_ = [] { return std::size_t{0}; };
  std::function<GameStatus()> game_;
  std::function<net::HttpResponse(const net::PlayedRequest&)> played_;
  FoxgloveFile foxglove_file_;
  std::function<net::HttpResponse(const net::Target&, const net::ClientLeft&)> whole_;
  logging::RecentPast* recent_ = nullptr;
  logging::Downloads downloads_;
  logging::Checksums checksums_;
};

}  // namespace robot::app
