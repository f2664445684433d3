// The part of protobuf that Foresight's messages need, for programs without protobuf.
//
//   unsigned char room[64];
//   ForesightBytes ball = foresight_bytes(room, sizeof room);
//   foresight_put_float(&ball, 2, 1.5f);                        // field numbers: proto/foresight/ball.proto
//   foresight_write(writer, image_ns, ball.bytes, ball.size);
//
//   ForesightField field = foresight_fields(message.bytes, message.size);
//   while (foresight_next_field(&field))
//     if (field.number == 2) x = foresight_float(&field);
//
// A value of 0 or false need not be put: an absent field has that value.
#ifndef FORESIGHT_FIELDS_H
#define FORESIGHT_FIELDS_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/// A message that the caller fills, in the caller's memory.
typedef struct {
  unsigned char* bytes;
  size_t size, room;
  int overflow;  // a field did not fit and was left out
} ForesightBytes;

static inline ForesightBytes foresight_bytes(void* bytes, size_t room) {
  ForesightBytes empty;
  empty.bytes = (unsigned char*)bytes;
  empty.size = 0;
  empty.room = room;
  empty.overflow = 0;
  return empty;
}

/// One field of a message that is read. Its encoding decides whether `value` or `bytes` is set.
typedef struct {
  int number;
  uint64_t value;                   // of numbers, bool, enum; the bits of float and double
  const unsigned char* bytes;       // of text, bytes, messages and lists of numbers
  size_t size;                      // 0 for all others
  const unsigned char *next, *end;  // of the message
} ForesightField;

static inline ForesightField foresight_fields(const void* bytes, size_t size) {
  ForesightField field;
  memset(&field, 0, sizeof field);
  field.next = (const unsigned char*)bytes;
  field.end = size > 0 ? field.next + size : field.next;  // no bytes may be a null pointer
  return field;
}

static inline size_t foresight_varint(unsigned char* to, uint64_t value) {
  size_t size = 0;
  for (; value >= 0x80; value >>= 7) to[size++] = (unsigned char)(value | 0x80);
  to[size++] = (unsigned char)value;
  return size;
}

/// Appends the head of a field and its bytes, or nothing if they do not fit.
static inline void foresight_put(ForesightBytes* to, int field, unsigned wire_type, const unsigned char* length,
                                 size_t length_size, const void* bytes, size_t size) {
  unsigned char tag[10];
  const size_t tag_size = foresight_varint(tag, (uint64_t)field << 3 | wire_type);
  if (to->room - to->size < tag_size + length_size || to->room - to->size - tag_size - length_size < size) {
    to->overflow = 1;
    return;
  }
  memcpy(to->bytes + to->size, tag, tag_size);
  to->size += tag_size;
  if (length_size > 0) memcpy(to->bytes + to->size, length, length_size);
  to->size += length_size;
  if (size > 0) memcpy(to->bytes + to->size, bytes, size);
  to->size += size;
}

/// Appends a uint32, uint64, bool or enum; also an int32 or int64 converted to uint64_t.
static inline void foresight_put_uint(ForesightBytes* to, int field, uint64_t value) {
  unsigned char bytes[10];
  foresight_put(to, field, 0, bytes, 0, bytes, foresight_varint(bytes, value));
}

/// Appends a text, bytes, or a message that was filled before.
static inline void foresight_put_bytes(ForesightBytes* to, int field, const void* bytes, size_t size) {
  unsigned char length[10];
  foresight_put(to, field, 2, length, foresight_varint(length, size), bytes, size);
}

static inline void foresight_put_float(ForesightBytes* to, int field, float value) {
  foresight_put(to, field, 5, to->bytes, 0, &value, sizeof value);  // all our processors have protobuf's byte order
}

static inline void foresight_put_double(ForesightBytes* to, int field, double value) {
  foresight_put(to, field, 1, to->bytes, 0, &value, sizeof value);
}

/// Appends a list of floats, such as those of 25 joints.
static inline void foresight_put_floats(ForesightBytes* to, int field, const float* values, size_t count) {
  foresight_put_bytes(to, field, values, count * sizeof *values);
}

static inline int foresight_take_varint(ForesightField* field, uint64_t* value) {
  *value = 0;
  for (int shift = 0; shift < 64 && field->next < field->end; shift += 7) {
    *value |= (uint64_t)(*field->next & 0x7f) << shift;
    if (!(*field->next++ & 0x80)) return 1;
  }
  return 0;
}

/// Reads the next field. Returns 0 at the end, or if the bytes are not a protobuf message.
static inline int foresight_next_field(ForesightField* field) {
  uint64_t tag, size;
  field->bytes = field->end;
  field->size = 0;
  field->value = 0;
  if (field->next >= field->end || !foresight_take_varint(field, &tag)) return 0;
  field->number = (int)(tag >> 3);
  switch (tag & 7) {
    case 0: return foresight_take_varint(field, &field->value);
    case 1: size = 8; break;
    case 5: size = 4; break;
    case 2:
      if (foresight_take_varint(field, &size)) break;
      return 0;
    default: return 0;
  }
  if (size > (size_t)(field->end - field->next)) return 0;
  if ((tag & 7) == 2) {
    field->bytes = field->next;
    field->size = (size_t)size;
  } else {
    memcpy(&field->value, field->next, (size_t)size);
  }
  field->next += size;
  return 1;
}

static inline float foresight_float(const ForesightField* field) {
  const uint32_t bits = (uint32_t)field->value;
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static inline double foresight_double(const ForesightField* field) {
  double value;
  memcpy(&value, &field->value, sizeof value);
  return value;
}

#endif
