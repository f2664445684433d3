#include "robot/logging/sessions/session_store.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/logging/sessions/owned_folder.h"
#include "robot/logging/sessions/session_counter.h"

namespace robot::logging {
namespace {

namespace fs = std::filesystem;
using Kind = FolderEntry::Kind;

/// Returns a text that changes when a file of the session changes.
std::string fingerprint(const std::vector<FolderEntry>& entries, bool owned) {
  std::string print = owned ? "owned" : "";
  for (const FolderEntry& entry : entries)
    print += entry.name + ' ' + std::to_string(entry.size_bytes) + ' ' + std::to_string(entry.changed_ns) + '\n';
  return print;
}

bool has(const std::vector<FolderEntry>& entries, std::string_view name) {
  return std::ranges::find(entries, name, &FolderEntry::name) != entries.end();
}

}  // namespace

SessionStore::SessionStore(fs::path folder, std::uint64_t max_bytes)
    : folder_(std::move(folder)), max_bytes_(max_bytes), sizes_(folder_), boot_(boot_id()) {}

SessionStore::Candidate SessionStore::candidate(const std::string& id) const {
  Candidate candidate{.folder = folder_ / id};
  if (auto entries = list_folder(candidate.folder)) candidate.entries = std::move(*entries);
  for (const FolderEntry& entry : candidate.entries) {
    if (entry.kind != Kind::file) continue;
    candidate.size_bytes += entry.size_bytes;
    candidate.described |= entry.name == "session.json";
  }
  candidate.owned = has(candidate.entries, kLockFile) && is_owned(candidate.folder);
  return candidate;
}

std::vector<SessionStore::Candidate> SessionStore::candidates() const {
  std::vector<Candidate> found;
  const auto entries = list_folder(folder_);
  if (!entries) return found;
  for (const FolderEntry& entry : *entries)
    if (entry.kind == Kind::folder && !entry.name.starts_with('.')) found.push_back(candidate(entry.name));
  return found;
}

bool SessionStore::is_session(const Candidate& candidate) const {
  if (candidate.described) return true;
  // a folder of other MCAP files is no session: read() returns an Error
  const bool recorded = std::ranges::any_of(candidate.entries, [](const FolderEntry& entry) {
    return entry.kind == Kind::file && entry.name.ends_with(".mcap");
  });
  return recorded && read(candidate);
}

std::vector<SessionStore::Candidate> SessionStore::session_candidates() const {
  std::vector<Candidate> found = candidates();
  std::erase_if(found, [&](const Candidate& candidate) { return !is_session(candidate); });
  return found;
}

Result<Session> SessionStore::read(const Candidate& candidate) const {
  const std::string id = candidate.folder.filename().string();
  const std::string print = fingerprint(candidate.entries, candidate.owned);
  const auto cached = cache_.find(id);
  if (cached != cache_.end() && cached->second.first == print) return cached->second.second;
  Result<Session> session = read_session(candidate.folder, candidate.owned);
  if (session && !session->rebuilt.empty() && !candidate.owned) mend(*session);
  cache_.insert_or_assign(id, std::pair(print, session));
  return session;
}

/// Writes session.json anew, with the facts that were found elsewhere.
void SessionStore::mend(const Session& session) const {
  const Result<void> written = store_file(session.folder / "session.json", to_json(session.info));
  if (!reported_.insert(session.id()).second) return;
  report(Level::warning, "logging",
         "session " + session.id() + ": " + session.rebuilt + "; its facts were taken from its MCAP files" +
             (written ? "" : "; " + written.error()));
}

std::vector<Session> SessionStore::list() const {
  const std::lock_guard guard(lock_);
  std::vector<Session> sessions;
  for (const Candidate& candidate : session_candidates())
    if (Result<Session> session = read(candidate)) sessions.push_back(std::move(*session));
  std::ranges::sort(sessions, [](const Session& left, const Session& right) { return is_older(right, left); });
  return sessions;
}

Result<Session> SessionStore::find(std::string_view id) const {
  const fs::path name(id);
  if (id.empty() || name.filename() != name || id.front() == '.' || id.find('\0') != id.npos)
    return Error{"session: expected the name of a session, got '" + std::string(id) + "'"};
  const std::lock_guard guard(lock_);
  std::error_code failed;
  const Candidate found = candidate(std::string(id));
  if (fs::is_symlink(fs::symlink_status(found.folder, failed)) || !is_session(found))
    return Error{"session: there is none called '" + std::string(id) + "'"};
  return read(found);
}

Result<void> SessionStore::keep(std::string_view id, bool keep) {
  Result<Session> session = find(id);
  if (!session) return session.failure();
  session->info.kept = keep;
  const std::lock_guard guard(lock_);
  cache_.erase(session->id());
  return store_file(session->folder / "session.json", to_json(session->info));
}

Result<void> SessionStore::remove(std::string_view id) {
  const Result<Session> session = find(id);
  if (!session) return session.failure();
  const std::lock_guard guard(lock_);
  const std::string who = "session " + session->id() + ": ";
  const Candidate found = candidate(session->id());
  if (found.owned) return Error{who + "it is being recorded, and cannot be deleted yet"};
  if (session->info.kept) return Error{who + "it is kept, and cannot be deleted"};
  return erase(found);
}

/// Deletes the files of a session and its folder. A link is deleted, not followed.
Result<void> SessionStore::erase(const Candidate& candidate) {
  const std::string id = candidate.folder.filename().string();
  const std::string who = "session " + id + ": cannot delete it: ";
  const auto inner = std::ranges::find(candidate.entries, Kind::folder, &FolderEntry::kind);
  if (inner != candidate.entries.end())
    return Error{who + "it contains the folder '" + inner->name + "', which no recording makes"};
  cache_.erase(id);
  for (const FolderEntry& entry : candidate.entries) {
    const fs::path path = candidate.folder / entry.name;
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) return file_error(who + "cannot remove", path, errno);
  }
  if (::rmdir(candidate.folder.c_str()) != 0 && errno != ENOENT)
    return file_error(who + "cannot remove", candidate.folder, errno);
  return {};
}

/// Returns the sessions that may be deleted to make room, the oldest first.
std::vector<std::pair<Session, SessionStore::Candidate>> SessionStore::deletable(std::uint64_t now_ns) const {
  const Now now{.times_ns = {now_ns, system_ns()}, .boot = boot_};
  std::vector<std::pair<Session, Candidate>> found;
  for (Candidate& candidate : session_candidates()) {
    if (candidate.owned) continue;
    Result<Session> session = read(candidate);
    if (session && is_deletable(*session, now)) found.emplace_back(std::move(*session), std::move(candidate));
  }
  std::ranges::sort(found, [](const auto& left, const auto& right) { return is_older(left.first, right.first); });
  return found;
}

std::uint64_t SessionStore::deletable_bytes(std::uint64_t now_ns) const {
  const std::lock_guard guard(lock_);
  std::uint64_t bytes = 0;
  for (const auto& [session, candidate] : deletable(now_ns)) bytes += candidate.size_bytes;
  return bytes;
}

std::vector<std::string> SessionStore::make_room(std::uint64_t bytes, std::uint64_t now_ns) {
  std::uint64_t taken = size_bytes();
  std::vector<std::string> gone;
  if (taken + bytes <= max_bytes_) return gone;
  const std::lock_guard guard(lock_);
  for (const auto& [session, candidate] : deletable(now_ns)) {
    if (taken + bytes <= max_bytes_) break;
    if (const Result<void> erased = erase(candidate); !erased) {
      if (reported_.insert(session.id() + " stays").second) report(Level::warning, "logging", erased.error());
      continue;
    }
    report(Level::info, "logging", "deleted the session " + session.id() + " to make room");
    taken -= std::min(taken, candidate.size_bytes);
    gone.push_back(session.id());
  }
  return gone;
}

std::uint64_t SessionStore::disk_free_bytes() const {
  // if the folder does not exist yet, it will be on the disk of its nearest existing parent
  std::error_code failed;
  fs::path folder = fs::absolute(folder_, failed);
  while (!fs::exists(folder, failed) && folder.has_relative_path()) folder = folder.parent_path();
  const fs::space_info space = fs::space(folder, failed);
  return failed ? 0 : space.available;
}

std::uint64_t SessionStore::size_bytes() const { return sizes_.total(system_ns()); }

std::uint64_t SessionStore::greatest_number() const {
  const std::lock_guard guard(lock_);
  std::uint64_t greatest = 0;
  for (const Candidate& candidate : session_candidates())
    if (const Result<Session> session = read(candidate)) greatest = std::max(greatest, session->info.number);
  return greatest;
}

}  // namespace robot::logging
