// A ground-truth system of a lab's own in C: a ball on a circle and two robots, 30 times a second, without protobuf.
//
//   ./truth [SECONDS]
//
// It writes to a ground-truth server, or to a robot's runtime (foresight-robot --body attached): to the one whose door is
// at $FORESIGHT_DOOR or at the default path. The frame is the field: origin at its centre, +x towards the goal that the
// home team attacks in the first half. A thing that is not seen is left out of the message.
#include <foresight.h>
#include <foresight_fields.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// the numbers of the fields: proto/foresight/truth.proto
static void put_ball(ForesightBytes* truth, float x, float y) {
  unsigned char room[32];
  ForesightBytes ball = foresight_bytes(room, sizeof room);
  foresight_put_float(&ball, 1, x);
  foresight_put_float(&ball, 2, y);
  foresight_put_bytes(truth, 1, ball.bytes, ball.size);
}

static void put_robot(ForesightBytes* truth, unsigned team, unsigned player, float x, float y, float heading) {
  unsigned char room[64];
  ForesightBytes robot = foresight_bytes(room, sizeof room);
  foresight_put_uint(&robot, 1, team);
  foresight_put_uint(&robot, 2, player);
  foresight_put_float(&robot, 3, x);
  foresight_put_float(&robot, 4, y);
  foresight_put_float(&robot, 5, heading);
  foresight_put_bytes(truth, 2, robot.bytes, robot.size);
}

int main(int count, char** words) {
  const uint64_t start_ns = foresight_now_ns();
  const double seconds = count > 1 ? atof(words[1]) : 10;
  ForesightWriter* world = foresight_announce("/truth/world", "foresight.GroundTruth");
  double age = 0;  // [s] since the start
  unsigned written = 0;
  while (age < seconds) {
    // the time when your camera took the image, not the time of its arrival
    const uint64_t image_ns = foresight_now_ns();
    age = (double)(image_ns - start_ns) * 1e-9;
    unsigned char room[256];
    ForesightBytes truth = foresight_bytes(room, sizeof room);
    put_ball(&truth, (float)cos(age), (float)sin(age));
    put_robot(&truth, 14, 2, -2.0f, 0.5f, 0.0f);
    put_robot(&truth, 5, 3, 2.0f, -0.5f, 3.0f);
    written += foresight_write(world, image_ns, truth.bytes, truth.size) != 0;

    const struct timespec pause = {0, 33333333};
    nanosleep(&pause, NULL);
  }
  printf("%u messages; lost: %llu %s\n", written, (unsigned long long)foresight_lost(world), foresight_problem(world));
  foresight_close(world);
  return 0;
}
