// A stand-in for a team's framework: it writes its images, joints, pose, ball, team and game state to Foresight, and
// reads the motion commands. People change its path in the viewer: live parameters. Ends after the given number of
// seconds.
#include <foresight.h>
#include <foresight_fields.h>
#include <foresight_parameters.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { WIDTH = 640, HEIGHT = 480, JOINTS = 25, CYCLE_NS = 12000000 };
enum { TEAM = 14, PLAYER = 2, PLAYING = 5 };

static unsigned char yuyv[2 * WIDTH * HEIGHT];

int main(int argc, char** argv) {
  ForesightWriter* joints = foresight_announce("joints", "foresight.Joints");
  ForesightWriter* camera = foresight_announce("camera_top", "foresight.Image");
  ForesightWriter* pose = foresight_announce("pose", "foresight.Pose");
  ForesightWriter* ball = foresight_announce("ball", "foresight.Ball");
  ForesightWriter* team = foresight_announce("team", "foresight.Team");
  ForesightWriter* game = foresight_announce("game", "foresight.GameState");
  ForesightReader* command = foresight_want("motion_command");

  double radius = 1;
  int clockwise = 0;
  ForesightParameters* path = foresight_parameters("path", NULL);
  foresight_add_number(path, "radius", &radius, 0.2, 3, "m", "Radius of the circle on which the robot walks.");
  foresight_add_yes_no(path, "clockwise", &clockwise, "The direction of the walk, seen from above.");

  const uint64_t start_ns = foresight_now_ns();
  const double seconds = argc > 1 ? atof(argv[1]) : 10;
  unsigned long commands = 0;
  for (unsigned long cycle = 0; (double)cycle * CYCLE_NS < seconds * 1e9; ++cycle) {
    const uint64_t now_ns = foresight_now_ns();
    const float t = (float)(now_ns - start_ns) * 1e-9f;
    foresight_poll_parameters(path);
    unsigned char room[256], inner_room[128];
    ForesightBytes message = foresight_bytes(room, sizeof room), inner = foresight_bytes(inner_room, sizeof inner_room);

    float angles[JOINTS];
    for (int i = 0; i < JOINTS; ++i) angles[i] = 0.1f * sinf(t + (float)i);
    foresight_put_floats(&message, 1, angles, JOINTS);
    foresight_write(joints, now_ns, message.bytes, message.size);

    if (cycle % 3 == 0) {  // a new image, and the beliefs from it
      for (size_t i = 0; i < sizeof yuyv; i += 2) yuyv[i] = (unsigned char)(i / 2 % WIDTH + cycle);
      foresight_write_image(camera, now_ns, FORESIGHT_YUYV, WIDTH, HEIGHT, yuyv, sizeof yuyv);

      message.size = 0;  // the robot walks on a circle round the centre of the field
      const float way = clockwise ? -t : t, quarter = clockwise ? -1.571f : 1.571f;
      foresight_put_float(&message, 1, (float)radius * cosf(way));
      foresight_put_float(&message, 2, (float)radius * sinf(way));
      foresight_put_float(&message, 3, remainderf(way + quarter, 6.2832f));
      foresight_write(pose, now_ns, message.bytes, message.size);

      message.size = 0;  // the ball, always a metre to its left
      foresight_put_uint(&message, 1, foresight_epoch_ns(ball, now_ns));
      foresight_put_float(&message, 3, 1);
      foresight_put_float(&message, 6, 0.1f);
      foresight_put_uint(&message, 7, 1);
      foresight_write(ball, now_ns, message.bytes, message.size);
    }

    if (cycle % 42 == 0) {  // twice a second: a packet of the GameController, and one of player 3
      message.size = 0;
      foresight_put_uint(&message, 5, TEAM);
      foresight_put_uint(&message, 6, PLAYER);
      foresight_put_uint(&message, 7, PLAYING);
      foresight_put_float(&message, 11, 600 - t);
      foresight_write(game, now_ns, message.bytes, message.size);

      message.size = 0;
      foresight_put_uint(&inner, 1, 3);
      foresight_put_bytes(&inner, 2, "striker", 7);
      foresight_put_uint(&inner, 7, 1);
      foresight_put_bytes(&message, 1, inner.bytes, inner.size);
      foresight_write(team, now_ns, message.bytes, message.size);
    }

    ForesightMessage wanted;
    while (foresight_read(command, &wanted)) ++commands;  // a real framework would walk

    const struct timespec rest = {0, CYCLE_NS};
    nanosleep(&rest, NULL);
  }
  printf("%lu commands; lost: %lu joints, %lu images %s\n", commands, (unsigned long)foresight_lost(joints),
         (unsigned long)foresight_lost(camera), foresight_problem(joints));
  foresight_close(joints);
  foresight_close(camera);
  foresight_close(pose);
  foresight_close(ball);
  foresight_close(team);
  foresight_close(game);
  foresight_end(command);
  foresight_end_parameters(path);
  return 0;
}
