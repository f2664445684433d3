#include "robot/truth/tracks/ball_fusion.h"

#include "robot/truth/tracks/shared_error.h"
#include "robot/truth/tracks/times.h"

namespace robot::truth {
namespace {

constexpr double kBallHidden = 0.1;  // [s] unseen: another ball may take its place

/// Lets the ball take the measurement, if it explains it.
bool took(BallTrack& ball, const std::vector<Sensor>& sensors, const Measurement& measurement, std::uint64_t now_ns) {
  const double dt = seconds_between(ball.paths_ns, now_ns);
  if (!ball.paths.explains(measurement, ball.sightings.shared, dt)) return false;
  ball.paths.advance(measurement, ball.sightings.shared, dt);
  ball.paths_ns = now_ns;
  ball.measurement = measurement;
  const BallPaths::Path& best = ball.paths.paths()[0];
  if (best.event != BallEvent::not_a_ball)
    ball.sightings.see(measurement, ball_errors(sensors, best.estimate.position()), best.estimate.velocity(), now_ns);
  return true;
}

BallTrack begun(TrackScene& scene, const std::vector<Sensor>& sensors, const Measurement& measurement) {
  const SharedErrors shared = ball_errors(sensors, measurement.place.position);
  return {Sightings::begun(++scene.serials, measurement, shared, scene.now_ns), BallPaths(measurement, shared),
          scene.now_ns, measurement};
}

void accept_new_ball(TrackScene& scene) {
  if (!scene.new_ball || !scene.new_ball->sightings.proved()) return;
  if (scene.ball && seconds_between(scene.ball->sightings.newest_ns, scene.now_ns) <= kBallHidden) return;
  scene.ball = scene.new_ball;
  scene.ball->sightings.track = ++scene.balls_born;
  scene.new_ball.reset();
}

}  // namespace

void advance_ball(TrackScene& scene, const std::vector<Sensor>& sensors, const SensorImage& image) {
  for (std::optional<BallTrack>* ball : {&scene.ball, &scene.new_ball})
    if (*ball && (*ball)->sightings.lost(scene.now_ns)) ball->reset();

  if (image.detections.ball) {
    const Measurement measurement{image.sensor, image.detections.ball->place};
    if (scene.ball && took(*scene.ball, sensors, measurement, scene.now_ns)) return;
    if (!scene.new_ball || !took(*scene.new_ball, sensors, measurement, scene.now_ns))
      scene.new_ball = begun(scene, sensors, measurement);
  } else if (scene.new_ball) {
    scene.new_ball->sightings.miss(image.sensor);
  }
  accept_new_ball(scene);
}

}  // namespace robot::truth
