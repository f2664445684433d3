/* The walk of another team, as a library for the harness: robots it never met, pushes, falls.
 *
 * A library exports these four functions:
 *
 *   cc -shared -fPIC -o libmywalk.so mywalk.c
 *   bench_walk "push 1.2 walking" 1 20 ./libmywalk.so
 *
 * tests/walk/our_walk_library.cpp exports our own walk. Angles in radians, by LoLA's conventions; frame: torso, +x
 * forward, +y left, +z up. All calls come from one thread. */
#ifndef FORESIGHT_WALK_H
#define FORESIGHT_WALK_H

#ifdef __cplusplus
extern "C" {
#endif

/* One frame of sensors. */
typedef struct foresight_walk_sensors {
  double rate[3];      /* [rad/s] of the torso, about x, y and z */
  double roll;         /* [rad] > 0 to the right */
  double pitch;        /* [rad] > 0 forward */
  double load[2][4];   /* [kg] left, right; front left, front right, rear left, rear right */
  double joints[2][6]; /* [rad] left, right; hip yaw pitch, hip roll, hip pitch, knee pitch, ankle pitch, ankle roll */
} foresight_walk_sensors;

/* A velocity over ground. All zero: stand. */
typedef struct foresight_walk_command {
  double forward, left; /* [m/s] */
  double turn;          /* [rad/s] > 0 to the left */
} foresight_walk_command;

/* Fills the legs of a robot that stands, and returns the height of its hips above the soles [m]. */
double foresight_walk_stand(double legs[2][6]);

/* Returns a new walk. A null pointer is an error. */
void* foresight_walk_begin(void);

/* Fills the targets of the legs for the next `dt` [s]. Returns 1 while the robot makes steps, else 0. */
int foresight_walk_tick(void* walk, const foresight_walk_sensors* sensors, const foresight_walk_command* command,
                        double dt, double targets[2][6]);

/* Ends a walk. */
void foresight_walk_end(void* walk);

#ifdef __cplusplus
}
#endif
#endif
