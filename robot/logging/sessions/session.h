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

namespace robot::logging {

/// The facts about a session at its beginning. The file `session.json` in its folder holds them.
struct SessionInfo {
  std::string name;   // from a person; may be empty
  std::string robot;  // "14/2"
  int team = 0, player = 0;
  std::string build;           // of the recording program
  std::string profile;         // "game", "vision", "full", or "import"
  std::uint64_t start_ns = 0;  // [ns since the epoch]
  bool kept = false;           // never deleted to make room
  bool complete = false;       // its writer closed it

  bool operator==(const SessionInfo&) const = default;
};

/// Convert to the text of `session.json` and back.
std::string to_json(const SessionInfo& info);
Result<SessionInfo> parse_session_info(std::string_view json);

/// Returns the same facts as metadata records for each stream, so that a single downloaded file still names its origin.
MetadataByName metadata_of(const SessionInfo& info);

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
  std::filesystem::path folder;
  SessionInfo info;
  SessionState state = SessionState::complete;
  std::string message;  // one sentence about a problem, or empty
  std::vector<StreamFile> streams;
  std::shared_ptr<const McapFile> one_file;  // holds all streams; null: each stream has a file of its own
  bool numbered = true;  // messages of a stream are numbered 1, 2, 3 …; false for files of other writers
  std::uint64_t size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] of all messages, without stray ones (time_span())

  /// Returns the name of the folder, which is the session's name in addresses.
  std::string id() const { return folder.filename().string(); }
};

/// Returns the file name of the stream of `topic`: "14.2.ball.mcap" for "/14/2/ball".
/// Characters that do not suit a file name or an address become '_'.
std::string stream_file_name(std::string_view topic);

/// Reads the session in `folder`. Describes the readable part of a damaged stream. Returns an Error only if there is no
/// session.
Result<Session> read_session(const std::filesystem::path& folder, bool being_written = false);

/// Reads one MCAP file with many channels, such as a downloaded session or a simulated game, as a session. All streams
/// of the session are in that file. Facts that its metadata lack are derived from the file's name and topics. The
/// session's message says which messages are left out and why.
Result<Session> read_recording(const std::filesystem::path& file);

/// Reads a folder as read_session() does, and a file as read_recording() does.
Result<Session> open_session(const std::filesystem::path& path);

/// A file of a session on the disk.
struct SessionFile {
  std::string name;  // "14.2.ball.mcap", "session.json"
  std::uint64_t size_bytes = 0;
  std::uint32_t crc32 = 0;  // of all its bytes
};

/// Returns all files in the folder of a session, by name. Reads every byte of them.
Result<std::vector<SessionFile>> read_session_files(const std::filesystem::path& folder);

/// Returns a folder name for a session that starts at `start_ns`, for example "2026-11-21_14-02-11_game". The time is
/// UTC, so that names sort by time.
std::string session_folder_name(std::uint64_t start_ns, std::string_view name, std::string_view profile);

}  // namespace robot::logging
