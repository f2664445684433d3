// The door by which a team's own processes join: they write into our memory and read from it through a local socket.
//
// What is said there is robot/logging/streams/stream_format.h; what a process uses to say it is robot/client/foresight.h.
#pragma once

#include <filesystem>
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

struct DoorOptions {
  std::filesystem::path path;  // of the socket; default_door() is where a client looks
  std::string robot;           // ours: "14/2"

  /// Objects of this robot that only the runtime writes.
  std::set<std::string> own_objects = {"runtime", "clock", "parameters"};
};

/// Where the door is unless somebody says otherwise: $FORESIGHT_DOOR, or a name of this user's in shared memory, which
/// every process sees whatever its temporary folder.
std::filesystem::path default_door();

/// One connection is one stream: a parser of its own for each object that is written, a logger for each that is read.
/// A thread of the door's own takes connections in, learns what they want, and clears away those that ended.
class Door {
 public:
  /// What waits for a process that does not read [bytes], of one stream.
  static constexpr std::size_t kQueueBytes = 4 << 20;
  static constexpr std::size_t kMaxConnections = 128;

  /// Opens the door for this user and nobody else. An Error if somebody else listens there. `clock` is the time base of
  /// all channels; all given ones outlive the door.
  static Result<std::unique_ptr<Door>> open(DoorOptions options, const SessionClock& clock, memory::Channels& channels,
                                            logging::LoggingBoard& board);

  /// Ends all streams and closes the door.
  ~Door();

 private:
  /// Somebody who came in and has not said yet what he wants; or who wants an object that is not there yet.
  struct Guest {
    std::shared_ptr<Connection> connection;
    std::optional<std::string> wanted;  // the topic, once it was said
    bool leaves = false;
  };
  struct Stream {
    logging::LoggingBoard::StreamId id = 0;
    std::shared_ptr<Connection> reader;  // null: a stream that is written
  };

  Door(DoorOptions options, const SessionClock& clock, memory::Channels& channels, logging::LoggingBoard& board,
       FileDescriptor listening, FileDescriptor bell);

  void run();
  bool wait();
  void take_in();
  void hear(Guest& guest);
  void write(Guest& guest, memory::ChannelInfo announced);
  void serve(Guest& guest);
  void refuse(Guest& guest, const std::string& sentence);
  void clear_away();

  const DoorOptions options_;
  const SessionClock& clock_;
  memory::Channels& channels_;
  logging::LoggingBoard& board_;
  const FileDescriptor listening_, bell_;

  // of the thread
  Objects objects_;
  std::list<Guest> guests_;
  std::vector<Stream> streams_;
  Throttle refusals_;

  Turns turns_;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace robot::body
