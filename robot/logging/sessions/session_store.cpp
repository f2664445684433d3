#include "robot/logging/sessions/session_store.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/report.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;

bool is_session(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(folder / "session.json", ignored));
}

std::vector<fs::path> session_folders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.is_directory(failed) && is_session(entry.path())) folders.push_back(entry.path());
  std::ranges::sort(folders);  // names begin with the time
  return folders;
}

/// Returns a text that changes when a file of the session changes.
std::string fingerprint(const fs::path& folder) {
  std::string print;
  std::error_code failed;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, failed)) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files)
    print += file.filename().string() + ' ' + std::to_string(fs::file_size(file, failed)) + ' ' +
             std::to_string(fs::last_write_time(file, failed).time_since_epoch().count()) + '\n';
  return print;
}

std::uint64_t bytes_in(const fs::path& folder) {
  std::uint64_t bytes = 0;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const std::uintmax_t size = entry.file_size(failed);
    if (!failed) bytes += size;
  }
  return bytes;
}

}  // namespace

Result<Session> SessionStore::read(const fs::path& folder) const {
  const std::string id = folder.filename().string();
  const std::string print = fingerprint(folder) + (id == recording_ ? "recording" : "");
  const auto cached = cache_.find(id);
  if (cached != cache_.end() && cached->second.first == print) return cached->second.second;
  Result<Session> session = read_session(folder, id == recording_);
  if (session) cache_[id] = {print, *session};
  return session;
}

std::vector<Session> SessionStore::list() const {
  const std::lock_guard guard(lock_);
  std::vector<Session> sessions;
  for (const fs::path& folder : session_folders(folder_))
    if (Result<Session> session = read(folder)) sessions.push_back(std::move(*session));
  std::ranges::reverse(sessions);
  return sessions;
}

Result<Session> SessionStore::find(std::string_view id) const {
  const fs::path name(id);
  if (id.empty() || name.filename() != name || id.front() == '.')
    return Error{"session: expected the name of a session, got '" + std::string(id) + "'"};
  const std::lock_guard guard(lock_);
  if (!is_session(folder_ / name)) return Error{"session: there is none called '" + std::string(id) + "'"};
  return read(folder_ / name);
}

Result<void> SessionStore::keep(std::string_view id, bool keep) {
  Result<Session> session = find(id);
  if (!session) return session.failure();
  session->info.kept = keep;
  const std::lock_guard guard(lock_);
  cache_.erase(session->id());
  return replace_file(session->folder / "session.json", to_json(session->info));
}

Result<void> SessionStore::remove(std::string_view id) {
  const Result<Session> session = find(id);
  if (!session) return session.failure();
  const std::lock_guard guard(lock_);
  const std::string who = "session " + session->id() + ": ";
  if (session->id() == recording_) return Error{who + "it is being recorded, and cannot be deleted yet"};
  if (session->info.kept) return Error{who + "it is kept, and cannot be deleted"};
  std::error_code failed;
  fs::remove_all(session->folder, failed);
  cache_.erase(session->id());
  if (failed) return Error{who + "cannot delete it: " + failed.message()};
  return {};
}

void SessionStore::set_recording(std::string id) {
  const std::lock_guard guard(lock_);
  recording_ = std::move(id);
}

bool SessionStore::deletable(const Session& session, std::uint64_t now_ns) const {
  return !session.info.kept && session.id() != recording_ && session.end_ns + kSafeAgeNs <= now_ns;
}

std::uint64_t SessionStore::deletable_bytes(std::uint64_t now_ns) const {
  const std::lock_guard guard(lock_);
  std::uint64_t bytes = 0;
  for (const fs::path& folder : session_folders(folder_))
    if (const Result<Session> session = read(folder); session && deletable(*session, now_ns)) bytes += bytes_in(folder);
  return bytes;
}

std::vector<std::string> SessionStore::make_room(std::uint64_t bytes, std::uint64_t now_ns) {
  const std::lock_guard guard(lock_);
  std::vector<std::string> gone;
  const std::vector<fs::path> folders = session_folders(folder_);
  std::uint64_t taken = 0;
  for (const fs::path& folder : folders) taken += bytes_in(folder);
  for (const fs::path& folder : folders) {
    if (taken + bytes <= max_bytes_) break;
    const Result<Session> session = read(folder);
    if (!session || !deletable(*session, now_ns)) continue;
    const std::uint64_t size = bytes_in(folder);
    std::error_code failed;
    fs::remove_all(folder, failed);
    if (failed) {
      report(Level::warning, "logging", "cannot delete " + folder.string() + ": " + failed.message());
      continue;
    }
    cache_.erase(session->id());
    taken -= size;
    gone.push_back(session->id());
  }
  return gone;
}

std::uint64_t SessionStore::disk_free_bytes() const {
  // if the folder does not exist yet, it will be on the disk of its nearest existing parent
  fs::path folder = fs::absolute(folder_);
  std::error_code failed;
  while (!fs::exists(folder, failed) && folder.has_relative_path()) folder = folder.parent_path();
  const fs::space_info space = fs::space(folder, failed);
  return failed ? 0 : space.available;
}

std::uint64_t SessionStore::size_bytes() const { return sizes_.total(system_ns()); }

}  // namespace robot::logging
