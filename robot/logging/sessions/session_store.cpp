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
    : folder_(std::move(folder)),
      max_bytes_(max_bytes),
      sizes_(folder_),
      boot_(boot_id()),
      reader_([this](const std::string& id) { (void)read(candidate(id)); }) {}

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

bool SessionStore::may_be_session(const Candidate& candidate) {
  return candidate.described || std::ranges::any_of(candidate.entries, [](const FolderEntry& entry) {
           return entry.kind == Kind::file && entry.name.ends_with(".mcap");
         });
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
  return may_be_session(candidate) && read(candidate);
}

std::vector<SessionStore::Candidate> SessionStore::session_candidates() const {
  std::vector<Candidate> found = candidates();
  std::erase_if(found, [&](const Candidate& candidate) { return !is_session(candidate); });
  return found;
}

/// Returns the session as it was read last.
std::optional<SessionStore::Known> SessionStore::known(const Candidate& candidate) const {
  const std::lock_guard guard(lock_);
  const auto cached = cache_.find(candidate.folder.filename().string());
  if (cached == cache_.end()) return {};
  const auto& [print, session] = cached->second;
  return Known{.session = session, .is_current = print == fingerprint(candidate.entries, candidate.owned)};
}

Result<Session> SessionStore::read(const Candidate& candidate) const {
  if (std::optional<Known> before = known(candidate); before && before->is_current) return std::move(before->session);
  Result<Session> session = read_session(candidate.folder, candidate.owned);
  if (session && !session->rebuilt.empty() && !candidate.owned) mend(*session);
  const std::lock_guard guard(lock_);
  cache_.insert_or_assign(candidate.folder.filename().string(),
                          std::pair(fingerprint(candidate.entries, candidate.owned), session));
  return session;
}

/// Returns a session with the facts of its session.json alone.
Session SessionStore::described(const Candidate& candidate) {
  Session session{.folder = candidate.folder, .size_bytes = candidate.size_bytes};
  if (const auto text = read_file(candidate.folder / "session.json", kMaxSessionJsonBytes))
    (void)take_session_info(*text, session.info);
  session.state = candidate.owned         ? SessionState::recording
                  : session.info.complete ? SessionState::complete
                                          : SessionState::recovered;
  session.start_ns = session.end_ns = session.info.start_ns;
  return session;
}

/// Returns true the first time that it is called with this text.
bool SessionStore::is_news(const std::string& text) const {
  const std::lock_guard guard(lock_);
  return reported_.insert(text).second;
}

void SessionStore::forget(const std::string& id) const {
  const std::lock_guard guard(lock_);
  cache_.erase(id);
}

/// Writes session.json anew, with the facts that were found elsewhere.
void SessionStore::mend(const Session& session) const {
  const Result<void> written = store_file(session.folder / "session.json", to_json(session.info));
  if (!is_news(session.id())) return;
  report(Level::warning, "logging",
         "session " + session.id() + ": " + session.rebuilt + "; its facts were taken from its MCAP files" +
             (written ? "" : "; " + written.error()));
}

std::vector<Session> SessionStore::list() const {
  std::vector<Session> sessions;
  for (const Candidate& candidate : session_candidates())
    if (Result<Session> session = read(candidate)) sessions.push_back(std::move(*session));
  std::ranges::sort(sessions, [](const Session& left, const Session& right) { return is_older(right, left); });
  return sessions;
}

std::vector<Session> SessionStore::list_within(std::uint64_t wait_ns) const {
  const std::vector<Candidate> found = candidates();
  std::vector<std::string> unread;
  for (const Candidate& candidate : found) {
    if (!may_be_session(candidate)) continue;
    if (const auto before = known(candidate); !before || !before->is_current)
      unread.push_back(candidate.folder.filename().string());
  }
  if (!unread.empty()) reader_.add(unread, wait_ns);

  std::vector<Session> sessions;
  for (const Candidate& candidate : found) {
    std::optional<Known> session = known(candidate);
    if (!session && candidate.described) session = Known{.session = described(candidate), .is_current = false};
    if (!session || !session->session) continue;
    sessions.push_back(std::move(*session->session));
    if (session->is_current || !may_be_session(candidate)) continue;
    if (sessions.back().state == SessionState::recording) continue;
    sessions.back().read = false;
    sessions.back().message = "its files are being read; until then this is incomplete";
  }
  std::ranges::sort(sessions, [](const Session& left, const Session& right) { return is_older(right, left); });
  return sessions;
}

Result<Session> SessionStore::find(std::string_view id) const {
  const fs::path name(id);
  if (id.empty() || name.filename() != name || id.front() == '.' || id.find('\0') != id.npos)
    return Error{"session: expected the name of a session, got '" + std::string(id) + "'"};
  std::error_code failed;
  const Candidate found = candidate(std::string(id));
  if (fs::is_symlink(fs::symlink_status(found.folder, failed)) || !is_session(found))
    return Error{"session: there is none called '" + std::string(id) + "'"};
  return read(found);
}

Result<void> SessionStore::keep(std::string_view id, bool keep) {
  const std::lock_guard changing(changes_);
  Result<Session> session = find(id);
  if (!session) return session.failure();
  session->info.kept = keep;
  forget(session->id());
  return store_file(session->folder / "session.json", to_json(session->info));
}

Result<void> SessionStore::remove(std::string_view id) {
  const std::lock_guard changing(changes_);
  const Result<Session> session = find(id);
  if (!session) return session.failure();
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
  forget(id);
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
  std::uint64_t bytes = 0;
  for (const auto& [session, candidate] : deletable(now_ns)) bytes += candidate.size_bytes;
  return bytes;
}

std::vector<std::string> SessionStore::make_room(std::uint64_t bytes, std::uint64_t now_ns) {
  std::uint64_t taken = size_bytes();
  std::vector<std::string> gone;
  if (taken + bytes <= max_bytes_) return gone;
  const std::lock_guard changing(changes_);
  for (const auto& [session, candidate] : deletable(now_ns)) {
    if (taken + bytes <= max_bytes_) break;
    if (const Result<void> erased = erase(candidate); !erased) {
      if (is_news(session.id() + " stays")) report(Level::warning, "logging", erased.error());
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
  std::uint64_t greatest = 0;
  for (const Candidate& candidate : session_candidates())
    if (const Result<Session> session = read(candidate)) greatest = std::max(greatest, session->info.number);
  return greatest;
}

}  // namespace robot::logging
