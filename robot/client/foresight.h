// The client of a team's own process: it writes objects into the robot's memory and reads objects from it, through the
// runtime's door (foresight-robot --body attached). C99 on Linux, without dependencies; also for C++.
//
//   ForesightWriter* ball = foresight_announce("ball", "foresight.Ball");
//   foresight_write(ball, foresight_now_ns(), bytes, size);            // for each new value
//
//   ForesightReader* command = foresight_want("motion_command");
//   ForesightMessage message;
//   while (foresight_read(command, &message)) obey(message.bytes, message.size);
//
// No call waits for the runtime, except foresight_wait, even while the runtime is stopped or dead. Each writer and each
// reader has its own connection. It connects at its first use, and connects again after a restart of the runtime. Large
// messages, such as images, go through shared memory. One thread at a time may use a writer or reader; different ones
// are independent. Messages that are written without a runtime are lost and counted.
//
// All times are of this machine's monotonic clock [ns], like those of V4L2 and std::chrono::steady_clock.
// Messages are protobuf, defined in proto/foresight/*.proto, unless announced otherwise. Without protobuf, use
// foresight_fields.h to fill and read them.
#ifndef FORESIGHT_H
#define FORESIGHT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ForesightWriter ForesightWriter;
typedef struct ForesightReader ForesightReader;

/// The messages that a viewer needs when the network is too slow for all of them.
typedef enum {
  FORESIGHT_LATEST,    // only the newest one: images, state
  FORESIGHT_FIFO,      // a short history: sensors
  FORESIGHT_RELIABLE,  // every one: events
} ForesightDelivery;

/// The description of an object, also of one that the runtime does not know.
typedef struct {
  const char* topic;             // "vortex" is an object of this robot, "/debug/vortex" a whole topic
  const char* type;              // name of its message: "team.Vortex"
  const char* message_encoding;  // "protobuf", "json", …
  const char* schema_encoding;   // "protobuf": the schema is a serialised FileDescriptorSet with all imports
  const void* schema;            // NULL: none, or for a message of Foresight the runtime's own
  size_t schema_bytes;
  ForesightDelivery delivery;
} ForesightObject;

/// One message that was read. Valid until the next call with its reader.
typedef struct {
  uint64_t sequence;    // rises; a gap: this reader was too slow for some messages
  uint64_t capture_ns;  // [ns, monotonic] time when the data were sensed
  uint64_t publish_ns;  // [ns, monotonic] time when it entered the robot's memory
  const void* bytes;
  size_t size;
} ForesightMessage;

/// Encodings of foresight.Image.
typedef enum { FORESIGHT_YUYV = 1, FORESIGHT_JPEG = 2 } ForesightPixels;

/// Returns the present time of the monotonic clock [ns].
uint64_t foresight_now_ns(void);

/// Makes a writer of an object that the runtime knows ("ball", "foresight.Ball"). Returns NULL only if out of memory.
/// The door is at $FORESIGHT_DOOR, or at the default path of this user's runtime.
ForesightWriter* foresight_announce(const char* topic, const char* type);

/// Makes a writer of any object, to the door at `door`; NULL: the door of foresight_announce(). Copies its arguments.
ForesightWriter* foresight_announce_as(const ForesightObject* object, const char* door);

/// Writes one message of at most 8 MiB that was sensed at `capture_ns`. Returns 1 if it was sent. Returns 0 if it is
/// lost; foresight_problem() gives the reason.
int foresight_write(ForesightWriter* writer, uint64_t capture_ns, const void* bytes, size_t size);

/// Writes a message of two pieces, one after the other: a head, and pixels that need not be copied behind it.
int foresight_write_pieces(ForesightWriter* writer, uint64_t capture_ns, const void* head, size_t head_size,
                           const void* bytes, size_t size);

/// Writes a foresight.Image: rows from the top without padding, YUYV exactly 2 * width * height bytes.
int foresight_write_image(ForesightWriter* writer, uint64_t capture_ns, ForesightPixels pixels, uint32_t width,
                          uint32_t height, const void* bytes, size_t size);

/// Returns the number of lost messages so far: the runtime was not running or did not keep up.
uint64_t foresight_lost(const ForesightWriter* writer);

/// Returns the reason why the last attempt failed, in one sentence, or "" if it did not fail.
const char* foresight_problem(const ForesightWriter* writer);

/// Converts `monotonic_ns` to the time of the time fields in messages [ns since the epoch, capture time]. The offset is
/// the runtime's; before the first connection it is that of the system clock.
uint64_t foresight_epoch_ns(const ForesightWriter* writer, uint64_t monotonic_ns);

/// Closes the connection and frees the writer. Messages that were sent still arrive.
void foresight_close(ForesightWriter* writer);

/// Makes a reader of the object `topic`, named as for a writer. The object need not exist yet.
ForesightReader* foresight_want(const char* topic);
ForesightReader* foresight_want_from(const char* topic, const char* door);

/// Reads the next message, beginning with the newest one at the time of connecting. Returns 0 if there is none now.
int foresight_read(ForesightReader* reader, ForesightMessage* message);

/// Reads the newest message and skips all before it. Returns 0 if there is none now.
int foresight_read_newest(ForesightReader* reader, ForesightMessage* message);

/// Waits until there may be a message to read, at most `timeout_ms`. Returns at once if that is 0 or less.
void foresight_wait(ForesightReader* reader, int timeout_ms);

/// Returns the runtime's description of the object, or NULL before the first message. Valid
/// until the next call with `reader`.
const ForesightObject* foresight_object(const ForesightReader* reader);

/// As foresight_problem() and foresight_epoch_ns().
const char* foresight_reader_problem(const ForesightReader* reader);
uint64_t foresight_reader_epoch_ns(const ForesightReader* reader, uint64_t monotonic_ns);

/// Closes the connection and frees the reader.
void foresight_end(ForesightReader* reader);

#ifdef __cplusplus
}
#endif

#endif
