// A session: one run's recordings, one stream per memory object, and what describes them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/logging/mcap/writer.h"

namespace robot::logging {

/// What is known of a session when it begins; kept as `session.json` in its folder.
struct SessionInfo {
  std::string name;   // given by a person, may be empty
  std::string robot;  // "14/2"
  int team = 0, player = 0;
  std::string build;           // of the program that recorded it
  std::string profile;         // "game", "vision", "full", or "import"
  std::uint64_t start_ns = 0;  // [ns since the epoch]
  bool kept = false;           // never deleted to make room
  bool complete = false;       // ended in good order

  bool operator==(const SessionInfo&) const = default;
};

/// What `session.json` says, and back.
std::string to_json(const SessionInfo& info);
Result<SessionInfo> parse_session_info(std::string_view json);

/// The same for the metadata records of each stream: a file that was sent away alone still tells where it comes from.
MetadataByName metadata_of(const SessionInfo& info);

/// One stream of a session.
struct StreamFile {
  std::string topic, file, schema;
  std::uint64_t messages = 0;
  std::uint64_t size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] capture times; both 0 without messages
  std::string damage;                      // one sentence, empty if the file is sound
};

enum class SessionState {
  recording,  // being written now
  complete,   // ended in good order
  recovered,  // its writer died; everything it had handed over is readable
  damaged,    // some of it cannot be read; the rest can
};

std::string_view name(SessionState state);

/// A session as it lies on the disk.
struct Session {
  std::filesystem::path folder;
  SessionInfo info;
  SessionState state = SessionState::complete;
  std::string message;  // what is wrong, one sentence, or empty
  std::vector<StreamFile> streams;
  bool one_file = false;  // holds all streams
  bool numbered = true;   // messages of a stream are numbered 1, 2, 3 …; other writers number as they like
  std::uint64_t size_bytes = 0;
  std::uint64_t start_ns = 0, end_ns = 0;  // [ns since the epoch] of all messages

  /// The name of the folder: what the session is called in addresses.
  std::string id() const { return folder.filename().string(); }
};

/// The file name of the stream of `topic`: "/14/2/ball" is in "14.2.ball.mcap".
/// Characters that a file name or an address should not hold become '_'.
std::string stream_file_name(std::string_view topic);

/// Reads the session in `folder`. A damaged stream is described as far as it can be read; an Error only if there is
/// no session at all.
Result<Session> read_session(const std::filesystem::path& folder, bool being_written = false);

/// Reads one MCAP file with many channels, such as a downloaded session or a simulated game, as a session whose streams
/// are all in that file. What the file does not tell of the session is made up from its name and topics.
Result<Session> read_recording(const std::filesystem::path& file);

/// As read_session() of a folder, as read_recording() of a file.
Result<Session> open_session(const std::filesystem::path& path);

/// A file of a session, as it lies on the disk.
struct SessionFile {
  std::string name;  // "14.2.ball.mcap", "session.json"
  std::uint64_t size_bytes = 0;
  std::uint32_t crc32 = 0;  // of all its bytes
};

/// All files in the folder of a session, by name; reads every byte of them.
Result<std::vector<SessionFile>> read_session_files(const std::filesystem::path& folder);

/// A folder name for a session that starts now: UTC, so that names sort by time: "2026-11-21_14-02-11_game".
std::string session_folder_name(std::uint64_t start_ns, std::string_view name, std::string_view profile);

}  // namespace robot::logging
