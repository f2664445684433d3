// The vision of a simulated robot as memory objects.
//
// The simulator's camera model joins both cameras of a Nao. So a simulated robot has one camera, the top one, whose image spans the
// view of both. A pixel of it is as large as the model says. The simulated view ends at bearings, the image of a pinhole at a
// rectangle. Far things are in both or in none within 2°; a ball at the feet may be in the image alone.
#pragma once

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/vision.pb.h"
#include "sim/match/params.h"
#include "sim/perception/ball_sight.h"
#include "sim/world/world.h"

namespace robot::bridge {

/// One image of a robot.
struct SimulatedImage {
  bool taken = false;                  // false: the robot lies or is beside the field
  float head_yaw = 0, head_pitch = 0;  // [rad]
  sim::perception::BallPercept ball{};
  float ball_radius = 0;  // [px] as the vision measures it; 0 without a ball
};

/// Takes the image of a robot at `world.tick`. Its ball is that of sim::perception::look_for_ball() for a single image. With the
/// effect ball_noise the radius has an error of 0.7 `noise.pixels`: both edges have one.
SimulatedImage image_of(const sim::Params& params, const sim::World& world, int robot);

/// Fills the pose and the projection of the camera.
void to_proto(const SimulatedImage& image, const sim::perception::Camera& camera, foresight::CameraMatrix& message);

/// Fills the percepts: the ball alone.
void to_proto(const SimulatedImage& image, const sim::Models& models, foresight::Vision& message);

}  // namespace robot::bridge
