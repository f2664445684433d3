// A team's process for `scripts/bench door`: writes messages, reads them back, and times every call.
//
//   bench_door_peer sensors SECONDS    83 Hz of 25 joints and 30 Hz of raw 640x480 images
//   bench_door_peer pulse TOPIC        1000 messages a second of which every eighth is large, read back and checked,
//                                      until SIGTERM
//   bench_door_peer watch TOPIC        only reads and checks such messages, until SIGTERM
//
// Prints one line of JSON. A call counts as waiting if it gave up the processor itself. Preemption by another process is no
// fault of the client and is counted apart.
#define _GNU_SOURCE
#include <foresight.h>
#include <foresight_fields.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

enum { JOINTS = 25, IMAGE_BYTES = 2 * 640 * 480, SMALL_BYTES = 300, LARGE_BYTES = 50000 };

static volatile sig_atomic_t ended = 0;

static void on_end(int signal) {
  (void)signal;
  ended = 1;
}

typedef struct {
  unsigned long calls, waits;
  uint64_t cpu_ns, longest_ns, longest_wait_ns;
} Calls;

static uint64_t cpu_ns(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

static long given_away(void) {
  struct rusage usage;
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nvcsw;
}

typedef struct {
  long given_away;
  uint64_t cpu_ns, wall_ns;
} Start;

static Start start_call(void) {
  Start start = {given_away(), 0, foresight_now_ns()};
  start.cpu_ns = cpu_ns();
  return start;
}

static void end_call(Calls* calls, Start start) {
  calls->cpu_ns += cpu_ns() - start.cpu_ns;
  const uint64_t wall_ns = foresight_now_ns() - start.wall_ns;
  ++calls->calls;
  if (wall_ns > calls->longest_ns) calls->longest_ns = wall_ns;
  if (given_away() == start.given_away) return;
  ++calls->waits;
  if (wall_ns > calls->longest_wait_ns) calls->longest_wait_ns = wall_ns;
}

static void print_calls(const char* name, const Calls* calls) {
  printf("\"%s\": {\"calls\": %lu, \"waits\": %lu, \"cpu_us\": %.2f, \"longest_ms\": %.3f, \"longest_wait_ms\": %.3f}",
         name, calls->calls, calls->waits, calls->calls ? (double)calls->cpu_ns / 1e3 / (double)calls->calls : 0.0,
         (double)calls->longest_ns / 1e6, (double)calls->longest_wait_ns / 1e6);
}

static void sleep_until(uint64_t due_ns) {
  const struct timespec due = {(time_t)(due_ns / 1000000000u), (long)(due_ns % 1000000000u)};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL);
}

static void write_joints(ForesightWriter* writer, Calls* calls) {
  unsigned char room[1024];
  float values[JOINTS];
  ForesightBytes message = foresight_bytes(room, sizeof room);
  for (int field = 1; field <= 5; ++field) {
    for (int i = 0; i < JOINTS; ++i) values[i] = (float)(field + i);
    foresight_put_floats(&message, field, values, JOINTS);
  }
  const Start start = start_call();
  foresight_write(writer, foresight_now_ns(), message.bytes, message.size);
  end_call(calls, start);
}

static int sensors(double seconds) {
  ForesightWriter* joints = foresight_announce("joints", "foresight.Joints");
  ForesightWriter* camera = foresight_announce("camera_top", "foresight.Image");
  unsigned char* image = malloc(IMAGE_BYTES);
  if (!joints || !camera || !image) return 2;
  Calls small = {0}, large = {0};
  const uint64_t start_ns = foresight_now_ns(), end_ns = start_ns + (uint64_t)(seconds * 1e9);
  uint64_t joints_due_ns = start_ns, image_due_ns = start_ns;
  while (joints_due_ns < end_ns || image_due_ns < end_ns) {
    if (joints_due_ns <= image_due_ns) {
      sleep_until(joints_due_ns);
      write_joints(joints, &small);
      joints_due_ns += 1000000000u / 83;
    } else {
      sleep_until(image_due_ns);
      memset(image, (int)large.calls, IMAGE_BYTES);
      const Start start = start_call();
      foresight_write_image(camera, foresight_now_ns(), FORESIGHT_YUYV, 640, 480, image, IMAGE_BYTES);
      end_call(&large, start);
      image_due_ns += 1000000000u / 30;
    }
  }
  printf("{\"lost\": %lu, ", (unsigned long)(foresight_lost(joints) + foresight_lost(camera)));
  print_calls("joints", &small);
  printf(", ");
  print_calls("images", &large);
  printf("}\n");
  foresight_close(joints);
  foresight_close(camera);
  free(image);
  return 0;
}

static int is_torn(const ForesightMessage* message) {
  const unsigned char* bytes = message->bytes;
  return (message->size != SMALL_BYTES && message->size != LARGE_BYTES) ||
         memcmp(bytes, bytes + 1, message->size - 1) != 0;
}

/// Without `writes_too` it only reads.
static int pulse(const char* topic, int writes_too) {
  const ForesightObject object = {topic, "bench.Pulse", "json", "json", NULL, 0, FORESIGHT_FIFO};
  ForesightWriter* writer = foresight_announce_as(&object, NULL);
  ForesightReader* reader = foresight_want(topic);
  unsigned char* bytes = malloc(LARGE_BYTES);
  if (!writer || !reader || !bytes) return 2;
  Calls writes = {0}, reads = {0};
  unsigned long seen = 0, torn = 0, missed = 0;
  uint64_t last = 0, due_ns = foresight_now_ns();
  while (!ended) {
    sleep_until(due_ns += 1000000);
    if (writes_too) {
      const size_t size = writes.calls % 8 == 7 ? LARGE_BYTES : SMALL_BYTES;
      memset(bytes, (int)(writes.calls % 251), size);
      const Start start = start_call();
      foresight_write(writer, foresight_now_ns(), bytes, size);
      end_call(&writes, start);
    }
    for (;;) {
      ForesightMessage message;
      const Start start = start_call();
      const int found = foresight_read(reader, &message);
      end_call(&reads, start);
      if (!found) break;
      ++seen;
      torn += (unsigned long)is_torn(&message);
      if (last != 0 && message.sequence > last + 1) missed += (unsigned long)(message.sequence - last - 1);
      last = message.sequence;
    }
  }
  printf("{\"lost\": %lu, \"seen\": %lu, \"torn\": %lu, \"missed\": %lu, ", (unsigned long)foresight_lost(writer), seen,
         torn, missed);
  print_calls("writes", &writes);
  printf(", ");
  print_calls("reads", &reads);
  printf("}\n");
  foresight_close(writer);
  foresight_end(reader);
  free(bytes);
  return 0;
}

int main(int argc, char** argv) {
  signal(SIGTERM, on_end);
  setvbuf(stdout, NULL, _IOFBF, BUFSIZ);
  if (argc == 3 && strcmp(argv[1], "sensors") == 0) return sensors(atof(argv[2]));
  if (argc == 3 && strcmp(argv[1], "pulse") == 0) return pulse(argv[2], 1);
  if (argc == 3 && strcmp(argv[1], "watch") == 0) return pulse(argv[2], 0);
  fprintf(stderr, "bench_door_peer: expected sensors SECONDS, pulse TOPIC or watch TOPIC\n");
  return 2;
}
