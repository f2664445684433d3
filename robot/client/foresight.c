// robot/logging/streams/stream_format.h documents the protocol.
#define _GNU_SOURCE

#include <foresight.h>

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

enum { CHANNEL = 1, MESSAGE, WELCOME, WANTED, MEMORY, SHARED, TAKEN, REFUSED };
enum { VERSION = 1 };
enum { HEAD_BYTES = 5, MESSAGE_HEAD_BYTES = 24, SHARED_BYTES = 40 };
enum { MAX_FRAME_BYTES = 8 << 20 };
enum { MAX_INLINE_BYTES = 16 << 10 };  // the kernel takes up to this size whole or not at all
enum { MIN_PLACE_BYTES = 64 << 10 };
enum { PLACES = 16 };  // half a second of images at 30 Hz may wait; a place costs nothing before its first use
enum { SEND_BUFFER_BYTES = 1 << 20, RECEIVE_BLOCK_BYTES = 64 << 10, SMALL_BLOCK_BYTES = 4 << 10 };
enum { MAX_PIECES = 4 };

static const uint64_t kRetryNs = 100 * 1000 * 1000;          // between attempts to connect
static const uint64_t kRefusedRetryNs = 1000 * 1000 * 1000;  // after the runtime refused us

// ---------------------------------------------------------------------------------------------------------- bytes

typedef struct {
  unsigned char* bytes;
  size_t begin, end, room;
} Buffer;

static size_t filled(const Buffer* buffer) { return buffer->end - buffer->begin; }

/// Makes room for `size` more bytes at the end. Returns 0 if out of memory.
static int reserve(Buffer* buffer, size_t size) {
  if (buffer->begin == buffer->end) buffer->begin = buffer->end = 0;
  if (buffer->room - buffer->end >= size) return 1;
  if (buffer->begin > 0) {
    memmove(buffer->bytes, buffer->bytes + buffer->begin, filled(buffer));
    buffer->end -= buffer->begin;
    buffer->begin = 0;
    if (buffer->room - buffer->end >= size) return 1;
  }
  const size_t room = 2 * buffer->room > buffer->end + size ? 2 * buffer->room : buffer->end + size;
  unsigned char* bytes = realloc(buffer->bytes, room);
  if (!bytes) return 0;
  buffer->bytes = bytes;
  buffer->room = room;
  return 1;
}

static int append(Buffer* to, const void* bytes, size_t size) {
  if (!reserve(to, size)) return 0;
  if (size > 0) memcpy(to->bytes + to->end, bytes, size);
  to->end += size;
  return 1;
}

static unsigned char* put(unsigned char* to, uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) *to++ = (unsigned char)(value >> (8 * i));
  return to;
}

static uint64_t get(const unsigned char* from, int bytes) {
  uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= (uint64_t)from[i] << (8 * i);
  return value;
}

static unsigned char* put_head(unsigned char* to, int kind, size_t body_bytes) {
  return put(put(to, (uint64_t)kind, 1), body_bytes, 4);
}

static int append_text(Buffer* to, const void* text, size_t size) {
  unsigned char length[4];
  put(length, size, 4);
  return append(to, length, sizeof length) && append(to, text, size);
}

// ----------------------------------------------------------------------------------------------------- connection

typedef struct {
  struct sockaddr_un door;
  int socket;            // -1: none
  uint64_t retry_at_ns;  // time of the next attempt to connect
  uint64_t epoch_offset_ns;
  Buffer hello;  // first frame of each connection
  Buffer in;     // received and not yet read
  Buffer out;    // unsent rest of a frame that the kernel took in part
  char problem[512];
} Connection;

static uint64_t time_ns(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

uint64_t foresight_now_ns(void) { return time_ns(CLOCK_MONOTONIC); }

static uint64_t system_offset_ns(void) { return time_ns(CLOCK_REALTIME) - time_ns(CLOCK_MONOTONIC); }

static void complain(Connection* connection, const char* what, const char* why) {
  snprintf(connection->problem, sizeof connection->problem, "%s %s: %s", what, connection->door.sun_path, why);
}

static void begin(Connection* connection, const char* door) {
  memset(connection, 0, sizeof *connection);
  connection->socket = -1;
  connection->epoch_offset_ns = system_offset_ns();
  connection->door.sun_family = AF_UNIX;
  char* path = connection->door.sun_path;
  const size_t room = sizeof connection->door.sun_path;
  if (!door) door = getenv("FORESIGHT_DOOR");
  if (door && *door)
    snprintf(path, room, "%s", door);
  else
    snprintf(path, room, "/dev/shm/foresight-%lu.door", (unsigned long)geteuid());
}

static void disconnect(Connection* connection, uint64_t retry_after_ns) {
  if (connection->socket >= 0) close(connection->socket);
  connection->socket = -1;
  connection->retry_at_ns = retry_after_ns ? foresight_now_ns() + retry_after_ns : 0;
  connection->in.begin = connection->in.end = 0;
  connection->out.begin = connection->out.end = 0;
}

static void finish(Connection* connection) {
  disconnect(connection, 0);
  free(connection->hello.bytes);
  free(connection->in.bytes);
  free(connection->out.bytes);
}

/// Receives the bytes that have come. Returns 0 if the connection has ended.
static int receive(Connection* connection, size_t wanted) {
  Buffer* in = &connection->in;
  if (!reserve(in, wanted)) {
    complain(connection, "cannot read from", "out of memory");
    disconnect(connection, kRetryNs);
    return 0;
  }
  const ssize_t n = recv(connection->socket, in->bytes + in->end, in->room - in->end, MSG_DONTWAIT);
  if (n > 0) {
    in->end += (size_t)n;
    return 1;
  }
  if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return 1;
  if (!connection->problem[0]) complain(connection, "cannot read from", "the runtime has gone");
  disconnect(connection, 0);
  return 0;
}

typedef struct {
  int kind;
  const unsigned char* body;
  size_t size;
} Frame;

/// Reads the next complete frame. Returns 0 if at least `missing` more bytes are needed.
static int next_frame(Connection* connection, Frame* frame, size_t* missing) {
  Buffer* in = &connection->in;
  *missing = HEAD_BYTES;
  if (filled(in) < HEAD_BYTES) return 0;
  frame->kind = in->bytes[in->begin];
  frame->size = (size_t)get(in->bytes + in->begin + 1, 4);
  frame->body = in->bytes + in->begin + HEAD_BYTES;
  if (frame->kind < CHANNEL || frame->kind > REFUSED || frame->size > MAX_FRAME_BYTES) {
    complain(connection, "cannot read from", "expected a frame, got something else");
    disconnect(connection, kRefusedRetryNs);
    return 0;
  }
  *missing = HEAD_BYTES + frame->size;
  if (filled(in) < *missing) {
    *missing -= filled(in);
    return 0;
  }
  in->begin += *missing;
  return 1;
}

/// Handles a frame that readers and writers have in common. Returns 0 if it has ended the connection.
static int heed(Connection* connection, const Frame* frame) {
  if (frame->kind == WELCOME && frame->size == 12) {
    connection->epoch_offset_ns = get(frame->body + 4, 8);
    if (get(frame->body, 4) == VERSION) return 1;
    complain(connection, "expected to speak version 1 at", "the runtime speaks another one");
    disconnect(connection, kRefusedRetryNs);
    return 0;
  }
  if (frame->kind != REFUSED) return 1;
  snprintf(connection->problem, sizeof connection->problem, "the runtime refuses: %.*s", (int)frame->size,
           (const char*)frame->body);
  disconnect(connection, kRefusedRetryNs);
  return 0;
}

/// Handles a write that failed for `reason`. If the runtime has ended the connection,
/// its last message gives the reason.
static void lose(Connection* connection, int reason) {
  complain(connection, "cannot write to", strerror(reason));
  Frame frame;
  size_t missing;
  if (!receive(connection, SMALL_BLOCK_BYTES)) return;
  while (next_frame(connection, &frame, &missing))
    if (!heed(connection, &frame)) return;
  if (connection->socket >= 0) disconnect(connection, 0);
}

/// Sends the unsent rest. Returns 1 if nothing is left.
static int flush(Connection* connection) {
  Buffer* out = &connection->out;
  while (filled(out) > 0) {
    const ssize_t n = send(connection->socket, out->bytes + out->begin, filled(out), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      complain(connection, "cannot write to", "the runtime does not read");
      return 0;
    }
    if (n < 0) {
      lose(connection, errno);
      return 0;
    }
    out->begin += (size_t)n;
  }
  return 1;
}

/// Sends `pieces`, with the descriptor `file` unless it is -1. If the kernel takes a part, the rest is sent later.
/// Returns 0 if nothing was sent.
static int send_pieces(Connection* connection, struct iovec* pieces, int count, int file) {
  union {
    struct cmsghdr head;
    char room[CMSG_SPACE(sizeof(int))];
  } extra;
  struct msghdr message;
  memset(&message, 0, sizeof message);
  message.msg_iov = pieces;
  message.msg_iovlen = (size_t)count;
  if (file >= 0) {
    memset(&extra, 0, sizeof extra);
    message.msg_control = &extra;
    message.msg_controllen = sizeof extra.room;
    struct cmsghdr* head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof(int));
    memcpy(CMSG_DATA(head), &file, sizeof file);
  }
  ssize_t sent;
  do sent = sendmsg(connection->socket, &message, MSG_DONTWAIT | MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  if (sent < 0) {
    if (errno != EAGAIN && errno != EWOULDBLOCK)
      lose(connection, errno);
    else
      complain(connection, "cannot write to", "the runtime does not read");
    return 0;
  }

  // the rest of a message that was sent in part must follow
  size_t taken = (size_t)sent;
  for (int i = 0; i < count; ++i) {
    const size_t skipped = taken < pieces[i].iov_len ? taken : pieces[i].iov_len;
    taken -= skipped;
    if (append(&connection->out, (char*)pieces[i].iov_base + skipped, pieces[i].iov_len - skipped)) continue;
    complain(connection, "cannot write to", "out of memory");
    disconnect(connection, kRetryNs);
    return 0;
  }
  return 1;
}

/// Returns 1 if the other side may own our door: it runs as this user or root.
static int trusted(int socket) {
  struct ucred owner;
  socklen_t size = sizeof owner;
  return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &owner, &size) == 0 && (owner.uid == geteuid() || owner.uid == 0);
}

/// Connects if there is no connection and the retry time has passed. Never waits.
static int connected(Connection* connection) {
  if (connection->socket >= 0) return 1;
  if (foresight_now_ns() < connection->retry_at_ns) return 0;
  connection->retry_at_ns = foresight_now_ns() + kRetryNs;
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (file < 0 || connect(file, (const struct sockaddr*)&connection->door, sizeof connection->door) != 0) {
    complain(connection, "cannot connect to", strerror(errno));
    if (file >= 0) close(file);
    return 0;
  }
  if (!trusted(file)) {
    complain(connection, "expected a runtime of this user at", "it belongs to another user");
    close(file);
    return 0;
  }
  const int buffer_bytes = SEND_BUFFER_BYTES;  // the kernel may give less
  setsockopt(file, SOL_SOCKET, SO_SNDBUF, &buffer_bytes, sizeof buffer_bytes);
  connection->socket = file;
  connection->problem[0] = '\0';
  struct iovec hello = {connection->hello.bytes, filled(&connection->hello)};
  return send_pieces(connection, &hello, 1, -1);
}

static uint64_t epoch_ns(const Connection* connection, uint64_t monotonic_ns) {
  return monotonic_ns + connection->epoch_offset_ns;
}

// --------------------------------------------------------------------------------------------------------- writer

struct ForesightWriter {
  Connection connection;
  uint64_t sequence, lost;

  // large messages are in a file that the runtime has open too, each at its own place
  int memory;  // -1: none yet
  size_t place_bytes;
  uint64_t taken[PLACES];  // number of the message at that place; 0: free
};

/// Appends the channel frame that describes `object`. Returns 0 if out of memory.
static int announce(Buffer* hello, const ForesightObject* object) {
  static const char kNone[] = "";
  const char* texts[] = {object->topic, object->message_encoding, object->type, object->schema_encoding};
  const size_t head_at = hello->end;
  unsigned char head[HEAD_BYTES] = {0};
  if (!append(hello, head, sizeof head)) return 0;
  for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
    const char* text = texts[i] ? texts[i] : kNone;
    if (!append_text(hello, text, strlen(text))) return 0;
  }
  const unsigned char delivery = (unsigned char)object->delivery;
  if (!append_text(hello, object->schema, object->schema ? object->schema_bytes : 0) || !append(hello, &delivery, 1))
    return 0;
  put_head(hello->bytes + head_at, CHANNEL, hello->end - head_at - HEAD_BYTES);
  return 1;
}

ForesightWriter* foresight_announce_as(const ForesightObject* object, const char* door) {
  ForesightWriter* writer = calloc(1, sizeof *writer);
  if (!writer) return NULL;
  begin(&writer->connection, door);
  writer->memory = -1;
  if (announce(&writer->connection.hello, object)) return writer;
  foresight_close(writer);
  return NULL;
}

ForesightWriter* foresight_announce(const char* topic, const char* type) {
  ForesightObject object = {topic, type, "protobuf", "protobuf", NULL, 0, FORESIGHT_LATEST};
  return foresight_announce_as(&object, NULL);
}

static void forget_memory(ForesightWriter* writer) {
  if (writer->memory >= 0) close(writer->memory);
  writer->memory = -1;
  writer->place_bytes = 0;
  memset(writer->taken, 0, sizeof writer->taken);
}

void foresight_close(ForesightWriter* writer) {
  if (!writer) return;
  forget_memory(writer);
  finish(&writer->connection);
  free(writer);
}

/// Handles the frames that the runtime has sent. Returns 0 if the connection has ended.
static int listen_to_runtime(ForesightWriter* writer) {
  Connection* connection = &writer->connection;
  if (!receive(connection, SMALL_BLOCK_BYTES)) return 0;
  Frame frame;
  size_t missing;
  while (next_frame(connection, &frame, &missing)) {
    if (!heed(connection, &frame)) return 0;
    if (frame.kind != TAKEN || frame.size != 8) continue;
    for (int i = 0; i < PLACES; ++i)
      if (writer->taken[i] == get(frame.body, 8)) writer->taken[i] = 0;
  }
  return connection->socket >= 0;
}

/// Makes sure that there is a file with places of `size` bytes. Returns 1 if it existed, 2 if it is new, 0 on failure.
static int have_memory(ForesightWriter* writer, size_t size) {
  if (writer->memory >= 0 && size <= writer->place_bytes) return 1;
  forget_memory(writer);
  char name[] = "/dev/shm/foresight-XXXXXX";
  writer->memory = mkostemp(name, O_CLOEXEC);
  if (writer->memory < 0) {
    snprintf(writer->connection.problem, sizeof writer->connection.problem, "cannot make shared memory in /dev/shm: %s",
             strerror(errno));
    return 0;
  }
  unlink(name);
  writer->place_bytes = MIN_PLACE_BYTES;
  while (writer->place_bytes < size) writer->place_bytes *= 2;
  return 2;
}

/// Writes a large message into shared memory and sends its place to the runtime. Returns 0 on failure.
static int share(ForesightWriter* writer, uint64_t capture_ns, const struct iovec* pieces, int count, size_t size) {
  Connection* connection = &writer->connection;
  const int memory = have_memory(writer, size);
  if (!memory) return 0;
  int place = 0;
  while (place < PLACES && writer->taken[place] != 0) ++place;
  if (place == PLACES) {
    complain(connection, "cannot write to", "the runtime does not free shared memory");
    return 0;
  }
  const uint64_t offset = (uint64_t)place * writer->place_bytes;
  if (pwritev(writer->memory, pieces, count, (off_t)offset) != (ssize_t)size) {
    snprintf(connection->problem, sizeof connection->problem, "cannot write to shared memory: %s", strerror(errno));
    if (memory == 2) forget_memory(writer);
    return 0;
  }

  unsigned char frames[HEAD_BYTES + HEAD_BYTES + SHARED_BYTES];
  unsigned char* at = frames;
  if (memory == 2) at = put_head(at, MEMORY, 0);
  at = put_head(at, SHARED, SHARED_BYTES);
  at = put(put(put(at, writer->sequence, 8), capture_ns, 8), foresight_now_ns(), 8);
  at = put(put(at, offset, 8), size, 8);
  struct iovec whole = {frames, (size_t)(at - frames)};
  if (!send_pieces(connection, &whole, 1, memory == 2 ? writer->memory : -1)) {
    if (memory == 2) forget_memory(writer);
    return 0;
  }
  writer->taken[place] = writer->sequence;
  return 1;
}

static int send_inline(ForesightWriter* writer, uint64_t capture_ns, const struct iovec* pieces, int count,
                       size_t size) {
  unsigned char head[HEAD_BYTES + MESSAGE_HEAD_BYTES];
  put(put(put(put_head(head, MESSAGE, MESSAGE_HEAD_BYTES + size), writer->sequence, 8), capture_ns, 8),
      foresight_now_ns(), 8);
  struct iovec all[1 + MAX_PIECES] = {{head, sizeof head}};
  memcpy(all + 1, pieces, (size_t)count * sizeof *pieces);
  return send_pieces(&writer->connection, all, 1 + count, -1);
}

/// Tries once to send a message.
static int hand_over(ForesightWriter* writer, uint64_t capture_ns, const struct iovec* pieces, int count, size_t size) {
  Connection* connection = &writer->connection;
  const int is_new = connection->socket < 0;
  if (!connected(connection)) return 0;
  if (is_new) forget_memory(writer);  // the previous runtime may still read it
  if (!listen_to_runtime(writer) || !flush(connection)) return 0;
  return size <= MAX_INLINE_BYTES ? send_inline(writer, capture_ns, pieces, count, size)
                                  : share(writer, capture_ns, pieces, count, size);
}

static int write_pieces(ForesightWriter* writer, uint64_t capture_ns, const struct iovec* pieces, int count) {
  size_t size = 0;
  for (int i = 0; i < count; ++i) size += pieces[i].iov_len;
  ++writer->sequence;
  int sent = 0;
  if (size > MAX_FRAME_BYTES) {
    complain(&writer->connection, "cannot write to", "a message has at most 8 MiB");
  } else {
    // only a write shows that the runtime has ended; the next one may be running already
    sent = hand_over(writer, capture_ns, pieces, count, size) ||
           (writer->connection.socket < 0 && hand_over(writer, capture_ns, pieces, count, size));
  }
  if (sent)
    writer->connection.problem[0] = '\0';
  else
    ++writer->lost;
  return sent;
}

int foresight_write(ForesightWriter* writer, uint64_t capture_ns, const void* bytes, size_t size) {
  const struct iovec piece = {(void*)bytes, size};
  return write_pieces(writer, capture_ns, &piece, 1);
}

int foresight_write_pieces(ForesightWriter* writer, uint64_t capture_ns, const void* head, size_t head_size,
                           const void* bytes, size_t size) {
  const struct iovec pieces[] = {{(void*)head, head_size}, {(void*)bytes, size}};
  return write_pieces(writer, capture_ns, pieces, 2);
}

static unsigned char* put_varint(unsigned char* to, uint64_t value) {
  for (; value >= 0x80; value >>= 7) *to++ = (unsigned char)(value | 0x80);
  *to++ = (unsigned char)value;
  return to;
}

int foresight_write_image(ForesightWriter* writer, uint64_t capture_ns, ForesightPixels pixels, uint32_t width,
                          uint32_t height, const void* bytes, size_t size) {
  // the fields encoding = 1, width = 2, height = 3, and the head of data = 4
  unsigned char head[40];
  unsigned char* at = head;
  *at++ = 1 << 3;
  at = put_varint(at, (uint64_t)pixels);
  *at++ = 2 << 3;
  at = put_varint(at, width);
  *at++ = 3 << 3;
  at = put_varint(at, height);
  *at++ = 4 << 3 | 2;
  at = put_varint(at, size);
  return foresight_write_pieces(writer, capture_ns, head, (size_t)(at - head), bytes, size);
}

uint64_t foresight_lost(const ForesightWriter* writer) { return writer->lost; }

const char* foresight_problem(const ForesightWriter* writer) { return writer->connection.problem; }

uint64_t foresight_epoch_ns(const ForesightWriter* writer, uint64_t monotonic_ns) {
  return epoch_ns(&writer->connection, monotonic_ns);
}

// --------------------------------------------------------------------------------------------------------- reader

struct ForesightReader {
  Connection connection;
  Buffer channel;  // the frame that described the object; `object` points into it
  ForesightObject object;
  Buffer newest;  // the bytes of the message that foresight_read_newest returned
};

ForesightReader* foresight_want_from(const char* topic, const char* door) {
  ForesightReader* reader = calloc(1, sizeof *reader);
  if (!reader) return NULL;
  begin(&reader->connection, door);
  unsigned char head[HEAD_BYTES];
  put_head(head, WANTED, strlen(topic));
  Buffer* hello = &reader->connection.hello;
  if (append(hello, head, sizeof head) && append(hello, topic, strlen(topic))) return reader;
  foresight_end(reader);
  return NULL;
}

ForesightReader* foresight_want(const char* topic) { return foresight_want_from(topic, NULL); }

void foresight_end(ForesightReader* reader) {
  if (!reader) return;
  finish(&reader->connection);
  free(reader->channel.bytes);
  free(reader->newest.bytes);
  free(reader);
}

/// Keeps the content of a channel frame. Returns 0 if the frame is malformed. The end of each text overwrites the
/// length of the next one, which has been read by then.
static int learn(ForesightReader* reader, const Frame* frame) {
  reader->channel.begin = reader->channel.end = 0;
  if (!append(&reader->channel, frame->body, frame->size)) return 0;
  unsigned char* texts[5];
  size_t sizes[5];
  size_t at = 0;
  for (int i = 0; i < 5; ++i) {
    if (frame->size - at < 4) return 0;
    sizes[i] = (size_t)get(frame->body + at, 4);
    at += 4;
    if (frame->size - at < sizes[i]) return 0;
    texts[i] = reader->channel.bytes + at;
    at += sizes[i];
  }
  if (frame->size - at != 1 || frame->body[at] > FORESIGHT_RELIABLE) return 0;
  for (int i = 0; i < 5; ++i) texts[i][sizes[i]] = '\0';
  const ForesightObject object = {(char*)texts[0],
                                  (char*)texts[2],
                                  (char*)texts[1],
                                  (char*)texts[3],
                                  texts[4],
                                  sizes[4],
                                  (ForesightDelivery)frame->body[at]};
  reader->object = object;
  return 1;
}

/// Reads the next message that has come. Returns 0 if there is none; then at least `missing` more bytes are needed.
static int next_message(ForesightReader* reader, ForesightMessage* message, size_t* missing) {
  Connection* connection = &reader->connection;
  Frame frame;
  while (next_frame(connection, &frame, missing)) {
    if (!heed(connection, &frame)) return 0;
    if (frame.kind == CHANNEL && !learn(reader, &frame)) {
      complain(connection, "cannot read from", "expected a channel frame, got something else");
      disconnect(connection, kRefusedRetryNs);
      return 0;
    }
    if (frame.kind != MESSAGE || frame.size < MESSAGE_HEAD_BYTES) continue;
    message->sequence = get(frame.body, 8);
    message->capture_ns = get(frame.body + 8, 8);
    message->publish_ns = get(frame.body + 16, 8);
    message->bytes = frame.body + MESSAGE_HEAD_BYTES;
    message->size = frame.size - MESSAGE_HEAD_BYTES;
    return 1;
  }
  return 0;
}

/// Receives more bytes; at least `missing` are needed. Returns 0 if none came.
static int fetch(ForesightReader* reader, size_t missing) {
  Connection* connection = &reader->connection;
  if (connection->socket < 0) return 0;
  const size_t before = filled(&connection->in);
  return receive(connection, missing > RECEIVE_BLOCK_BYTES ? missing : RECEIVE_BLOCK_BYTES) &&
         filled(&connection->in) > before;
}

int foresight_read(ForesightReader* reader, ForesightMessage* message) {
  if (!connected(&reader->connection) || !flush(&reader->connection)) return 0;
  size_t missing = 0;
  do
    if (next_message(reader, message, &missing)) return 1;
  while (fetch(reader, missing));
  return 0;
}

int foresight_read_newest(ForesightReader* reader, ForesightMessage* message) {
  if (!connected(&reader->connection) || !flush(&reader->connection)) return 0;
  int found = 0;
  size_t missing = 0;
  do {
    int news = 0;
    while (next_message(reader, message, &missing)) news = 1;
    if (!news) continue;
    // receiving more moves the earlier bytes
    reader->newest.begin = reader->newest.end = 0;
    found = append(&reader->newest, message->bytes, message->size);
    message->bytes = reader->newest.bytes;
  } while (fetch(reader, missing));
  return found;
}

void foresight_wait(ForesightReader* reader, int timeout_ms) {
  Connection* connection = &reader->connection;
  const int retry_ms = (int)(kRetryNs / 1000000);
  if (timeout_ms < 0) timeout_ms = 0;  // poll would wait forever
  struct pollfd readable = {-1, POLLIN, 0};
  if (connected(connection)) readable.fd = connection->socket;
  // without a connection it waits for the next attempt only
  poll(&readable, 1, readable.fd < 0 && timeout_ms > retry_ms ? retry_ms : timeout_ms);
}

const ForesightObject* foresight_object(const ForesightReader* reader) {
  return reader->object.topic ? &reader->object : NULL;
}

const char* foresight_reader_problem(const ForesightReader* reader) { return reader->connection.problem; }

uint64_t foresight_reader_epoch_ns(const ForesightReader* reader, uint64_t monotonic_ns) {
  return epoch_ns(&reader->connection, monotonic_ns);
}
