// A session: the recordings of one run, one stream per memory object, and their description.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/sessions/session_info.h"
#include "robot/logging/sessions/session_name.h"

namespace robot::logging {

/// One stream of a session.
struct StreamFile {
  std::string topic, file, schema;
  std::uint64_t messages = 0;
  std::uint64_t size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] capture times; both 0 without messages
  std::string damage;                      // one sentence, or empty without damage
  std::uint64_t left_out = 0;              // messages of the topic with another schema or encoding
  std::string note;                        // one sentence about them, or empty
};

enum class SessionState {
  recording,  // being written now
  complete,   // closed by its writer
  recovered,  // its writer died; everything written until then is readable
  damaged,    // partly unreadable
};

std::string_view name(SessionState state);

/// A session on the disk.
struct Session {
  std::filesystem::path folder;  // without a slash at its end
  SessionInfo info;
  SessionState state = SessionState::complete;
  bool read = true;     // false: its files are still being read; `streams` and times may be missing or old
  std::string message;  // one sentence about a problem, or empty
  std::string rebuilt;  // reason why `info` is from the MCAP files, because session.json cannot be read; or empty
  std::vector<StreamFile> streams;
  std::shared_ptr<const McapFile> one_file;  // holds all streams; null: each stream has a file of its own
  bool numbered = true;  // messages of a stream are numbered 1, 2, 3 …; false for files of other writers
  std::uint64_t size_bytes = 0;
  // [ns since the epoch] of the data that move: without stray messages (time_span()) and retained values (retained.h)
  std::uint64_t start_ns = 0, end_ns = 0;
  std::uint64_t changed_ns = 0;  // [ns since the epoch] of the last change of a stream's file, or else of session.json

  /// Returns the name of the folder, which is the session's name in addresses.
  std::string id() const { return folder.filename().string(); }
};

/// Reads the session in `folder`. Describes the readable part of a damaged stream. If session.json is missing or damaged,
/// takes the facts from the MCAP files. Returns an Error only if there is no session. Skips symbolic links, named pipes
/// and folders in the folder.
Result<Session> read_session(const std::filesystem::path& folder, bool being_written = false);

/// Reads one MCAP file with many channels, such as a downloaded session or a simulated game, as a session. All streams
/// of the session are in that file. Facts that its metadata lack are derived from the file's name and topics. The
/// session's message says which messages are left out and why.
Result<Session> read_recording(const std::filesystem::path& file);

/// Returns `path` without dots and without a slash at its end, so that its last part is the session's name.
std::filesystem::path plain_path(const std::filesystem::path& path);

/// Returns the absolute path of the folder that contains the session at `path`.
std::filesystem::path log_folder_of(const std::filesystem::path& path);

/// Reads a folder as read_session() does, and a file as read_recording() does.
Result<Session> open_session(const std::filesystem::path& path);

}  // namespace robot::logging
