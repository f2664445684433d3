// How a team's own process joins Foresight on its robot: it writes objects into the robot's memory and reads objects
// from it, through the runtime's door (foresight-robot --body attached). C99 on Linux, without dependencies; also for C++.
//
//   ForesightWriter* ball = foresight_announce("ball", "foresight.Ball");
//   foresight_write(ball, foresight_now_ns(), bytes, size);            // as often as there is news
//
//   ForesightReader* command = foresight_want("motion_command");
//   ForesightMessage message;
//   while (foresight_read(command, &message)) obey(message.bytes, message.size);
//
// No call waits for the runtime, except foresight_wait: not while it is stopped, not while it is gone. Each writer and
// each reader has a connection of its own, makes it when it is used, and makes it anew when the runtime has gone and
// come back. Large messages, such as images, go through shared memory. A writer or reader is used by one thread at a time;
// different ones do not know of each other. What is written while no runtime is there is lost and counted.
//
// All times are of this machine's monotonic clock [ns], as those of V4L2 and std::chrono::steady_clock.
// Messages are protobuf as proto/foresight/*.proto has them, unless announced otherwise; who has no protobuf fills and
// reads them with foresight_fields.h.
#ifndef FORESIGHT_H
#define FORESIGHT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ForesightWriter ForesightWriter;
typedef struct ForesightReader ForesightReader;

/// What matters to somebody who watches an object over a network that is too slow for all of it.
typedef enum {
  FORESIGHT_LATEST,    // only the newest counts: images, state
  FORESIGHT_FIFO,      // a short history counts: sensors
  FORESIGHT_RELIABLE,  // each one counts: events
} ForesightDelivery;

/// What is to be known of an object that the runtime does not know.
typedef struct {
  const char* topic;             // "vortex" is an object of this robot, "/debug/vortex" a topic as it stands
  const char* type;              // name of its message: "team.Vortex"
  const char* message_encoding;  // "protobuf", "json", …
  const char* schema_encoding;   // "protobuf": the schema is a serialised FileDescriptorSet with all imports
  const void* schema;            // NULL: none, and for a message of ours the runtime's own
  size_t schema_bytes;
  ForesightDelivery delivery;
} ForesightObject;

/// One message that was read. Valid until the next call for its reader.
typedef struct {
  uint64_t sequence;    // rises; a gap tells of messages that this reader was too slow for
  uint64_t capture_ns;  // [ns, monotonic] when the data were sensed
  uint64_t publish_ns;  // [ns, monotonic] when it entered the robot's memory
  const void* bytes;
  size_t size;
} ForesightMessage;

/// Encodings of foresight.Image.
typedef enum { FORESIGHT_YUYV = 1, FORESIGHT_JPEG = 2 } ForesightPixels;

/// Now, by the clock of all times here.
uint64_t foresight_now_ns(void);

/// A writer of one of the runtime's own kinds of objects ("ball", "foresight.Ball"). NULL only without memory.
/// The door is at $FORESIGHT_DOOR, or where the runtime of the same user has it.
ForesightWriter* foresight_announce(const char* topic, const char* type);

/// A writer of an object of any kind, to the door at `door`; NULL is the one above. What is given is copied.
ForesightWriter* foresight_announce_as(const ForesightObject* object, const char* door);

/// Writes one message, sensed at `capture_ns`, of at most 8 MiB. 1: it is on its way; 0: it is lost, and
/// foresight_problem() says why.
int foresight_write(ForesightWriter* writer, uint64_t capture_ns, const void* bytes, size_t size);

/// Writes a message in two pieces, the second behind the first: a head, and pixels that need not be copied to it.
int foresight_write_pieces(ForesightWriter* writer, uint64_t capture_ns, const void* head, size_t head_size,
                           const void* bytes, size_t size);

/// Writes a foresight.Image: rows from the top without padding, YUYV exactly 2 * width * height bytes.
int foresight_write_image(ForesightWriter* writer, uint64_t capture_ns, ForesightPixels pixels, uint32_t width,
                          uint32_t height, const void* bytes, size_t size);

/// How many messages were lost so far, because the runtime was gone or did not keep up.
uint64_t foresight_lost(const ForesightWriter* writer);

/// Why the last attempt failed, in one sentence; "" while all is well.
const char* foresight_problem(const ForesightWriter* writer);

/// `monotonic_ns` as time fields within messages have it [ns since the epoch, capture time], by the runtime's offset; by
/// that of the system clock until the runtime was met.
uint64_t foresight_epoch_ns(const ForesightWriter* writer, uint64_t monotonic_ns);

/// Ends the connection. What was written still arrives.
void foresight_close(ForesightWriter* writer);

/// A reader of the object `topic`, named as above; it need not be there yet.
ForesightReader* foresight_want(const char* topic);
ForesightReader* foresight_want_from(const char* topic, const char* door);

/// Fills in the next message, beginning with the newest there was; 0 when there is none now.
int foresight_read(ForesightReader* reader, ForesightMessage* message);

/// Passes over all but the newest message.
int foresight_read_newest(ForesightReader* reader, ForesightMessage* message);

/// Waits until there may be something to read, at most `timeout_ms`; not at all where that is 0 or less.
void foresight_wait(ForesightReader* reader, int timeout_ms);

/// What the runtime says of the object; NULL until the first message was read. Valid until the next call for the reader.
const ForesightObject* foresight_object(const ForesightReader* reader);

const char* foresight_reader_problem(const ForesightReader* reader);
uint64_t foresight_reader_epoch_ns(const ForesightReader* reader, uint64_t monotonic_ns);
void foresight_end(ForesightReader* reader);

#ifdef __cplusplus
}
#endif

#endif
