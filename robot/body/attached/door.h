// The door for a team's own processes: a local socket through which they write and read memory.
//
// robot/logging/streams/stream_format.h defines the protocol. Processes use it through robot/client/foresight.h.
#pragma once

#include <filesystem>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "robot/body/attached/connection.h"
#include "robot/body/attached/objects.h"
#include "robot/body/attached/turns.h"
#include "robot/core/clock.h"
#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"

namespace robot::body {

/// Path, robot and protected objects of a door.
struct DoorOptions {
  std::filesystem::path path;  // of the socket; clients look at default_door()
  std::string robot;           // this robot, such as "14/2"

  /// Objects of this robot that only the runtime writes.
  std::set<std::string> own_objects = {"runtime", "clock", "parameters", "live_parameters"};

  /// Processes write only topics that begin with this, such as "/truth/". Empty: any.
  std::string written_below = "";

  std::uint64_t first_frame_ns = 5 * kSecond;  // time for the first frame of a connection

  /// Called by the door's thread when no process that writes `topic` is connected any more. Empty: nobody asks.
  std::function<void(const std::string& topic)> on_end = {};
};

/// Returns the default path of the door: $FORESIGHT_DOOR, or a name of this user in shared memory. Every process sees
/// that name, also with a temporary folder of its own.
std::filesystem::path default_door();

/// The door: one connection is one stream. Each written object has a parser of its own, each read object a logger.
/// The door's own thread accepts connections, reads their first frame, and removes streams that ended. A connection that
/// sends no first frame in time is refused, so that silent ones keep no other process out. Without a free file
/// descriptor it refuses processes with a sentence, at most ten a second.
class Door {
 public:
  /// Size of the queue of one stream for a process that does not read [bytes].
  static constexpr std::size_t kQueueBytes = 4 << 20;
  static constexpr std::size_t kMaxConnections = 128;

  /// Opens the door for this user only. Returns an Error if another program listens there. `clock` is the time base of
  /// all channels. All arguments outlive the door.
  static Result<std::unique_ptr<Door>> open(DoorOptions options, const SessionClock& clock, memory::Channels& channels,
                                            logging::LoggingBoard& board);

  /// Ends all streams and closes the door.
  ~Door();

 private:
  /// A connection before its stream starts: it has sent no first frame yet, or wants an object that does not exist yet.
  struct PendingConnection {
    std::shared_ptr<Connection> connection;
    std::uint64_t late_ns = 0;          // [monotonic] when its first frame is late
    std::optional<std::string> wanted;  // the topic, after the first frame
    bool done = false;                  // refused, disconnected, or its stream has started
  };
  struct Stream {
    logging::LoggingBoard::StreamId id = 0;
    std::shared_ptr<Connection> reader;  // null: a stream that is written
    std::string topic;                   // of a stream that is written
  };

  Door(DoorOptions options, const SessionClock& clock, memory::Channels& channels, logging::LoggingBoard& board,
       FileDescriptor listening, FileDescriptor bell);

  void run();
  bool wait();
  void take_in();
  void turn_away(int error_number);
  void hear(PendingConnection& pending);
  void write(PendingConnection& pending, memory::ChannelInfo announced);
  void serve(PendingConnection& pending);
  void refuse(PendingConnection& pending, const std::string& sentence);
  void clear_away();

  const DoorOptions options_;
  const SessionClock& clock_;
  memory::Channels& channels_;
  logging::LoggingBoard& board_;
  const FileDescriptor listening_, bell_;

  // of the thread
  Objects objects_;
  std::list<PendingConnection> pending_;
  std::vector<Stream> streams_;
  Throttle refusals_;
  FileDescriptor spare_;              // to refuse a process when no other is left
  std::uint64_t rests_until_ns_ = 0;  // [monotonic] it accepts nothing before

  Turns turns_;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::body
