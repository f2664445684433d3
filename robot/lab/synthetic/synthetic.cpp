#include "robot/lab/synthetic/synthetic.h"

#include <algorithm>
#include <cmath>

#include "proto/foresight/runtime.pb.h"

namespace robot::lab {
namespace {

using namespace synthetic;

constexpr std::uint64_t kStepsPerSecond = 100;
constexpr std::uint64_t kStepNs = 1'000'000'000 / kStepsPerSecond;
constexpr std::uint64_t kThink = 3, kImage = 6, kTruth = 10, kGame = 50, kSecond = 100;  // [steps] between two

struct Saying {
  double t;  // [s]
  pb::LogText::Level level;
  const char* source;
  const char* text;
};
constexpr Saying kSayings[] = {
    {0, pb::LogText::LEVEL_INFO, "runtime", "synthetic recording: nothing of this happened"},
    {1, pb::LogText::LEVEL_INFO, "motion", "inertial sensors are calibrated"},
    {kReady, pb::LogText::LEVEL_INFO, "game", "ready: walking to the kick-off position"},
    {kPlaying, pb::LogText::LEVEL_INFO, "game", "playing: team 14 has kick-off"},
    {9, pb::LogText::LEVEL_WARNING, "vision", "image took 41 ms, budget is 33 ms"},
    {kKick, pb::LogText::LEVEL_INFO, "agent", "kick walk_forward towards the opponent goal"},
    {kGoal, pb::LogText::LEVEL_INFO, "game", "goal for team 14, 1:0"},
    {kTakenAway, pb::LogText::LEVEL_DEBUG, "vision", "lost the ball"},
};

pb::LogText text_of(const Saying& saying) {
  pb::LogText text;
  text.set_level(saying.level);
  text.set_source(saying.source);
  text.set_text(saying.text);
  return text;
}

/// The messages of one step, passed on until the sink fails.
class Step {
 public:
  Step(const SyntheticMoment& moment, ImportSink& sink) : moment_(moment), sink_(sink) {}

  void put(std::string_view object, const google::protobuf::Message& value) {
    if (done_) done_ = sink_.message(object, moment_.epoch_ns + moment_.step * kStepNs, value);
  }
  bool every(std::uint64_t steps) const { return moment_.step % steps == 0; }
  const Result<void>& done() const { return done_; }

 private:
  const SyntheticMoment& moment_;
  ImportSink& sink_;
  Result<void> done_;
};

void put_body(Step& step, const SyntheticMoment& moment, const Noise& noise) {
  step.put("joints", joints_of(moment, noise));
  step.put("inertial", inertial_of(moment, noise));
  step.put("fsr", fsr_of(moment));
  step.put("touch", touch_of(moment));
  step.put("odometry", odometry_of(moment));
  step.put("motion_status", motion_status_of(moment));
  if (step.every(kSecond)) step.put("battery", battery_of(moment));
}

void put_thoughts(Step& step, const SyntheticMoment& moment, const Sight& sight, const Noise& noise) {
  if (step.every(kImage)) {
    step.put("camera_top", image_of(moment));
    step.put("camera_top_matrix", camera_matrix_of(moment));
  }
  step.put("vision", vision_of(moment, sight, noise));
  const auto ball = ball_of(moment, sight, noise);
  if (ball) step.put("ball", *ball);
  step.put("pose", pose_of(moment, noise));
  step.put("decision", decision_of(moment, ball));
  step.put("motion_command", motion_command_of(moment));
}

void put_rest(Step& step, const SyntheticMoment& moment) {
  if (step.every(kTruth)) step.put("/truth/world", truth_of(moment));
  if (step.every(kGame)) step.put("game", game_of(moment));
  if (step.every(kSecond)) step.put("team", team_of(moment));
  for (const Saying& saying : kSayings)
    if (std::llround(saying.t * kStepsPerSecond) == static_cast<long long>(moment.step))
      step.put("log", text_of(saying));
}

/// Returns the first step at `t` [s] or later.
std::uint64_t first_step(double t) {
  return static_cast<std::uint64_t>(std::ceil(std::max(0.0, t) * kStepsPerSecond - 1e-6));
}

SyntheticRobot::Options limited(SyntheticRobot::Options options) {
  options.seconds = std::clamp(options.seconds, 0.0, 600.0);
  options.image_width = std::clamp(options.image_width, 64, 640) / 8 * 8;
  return options;
}

}  // namespace

SyntheticRobot::SyntheticRobot(const Options& options) : options_(limited(options)), noise_(options_.seed) {
  const std::uint64_t steps = first_step(options_.seconds);
  Sight sight;
  for (std::uint64_t step = 0; step < steps; step += kThink) {
    const double t = static_cast<double>(step) / kStepsPerSecond;
    const bool visible = ball_visible(t, options_.image_width, options_.image_width * 3 / 4);
    sight.run = visible == sight.visible ? sight.run + 1 : 1;
    sight.visible = visible;
    if (visible) sight.last_seen = t;
    sights_.push_back(sight);
  }
}

Result<ImportReport> SyntheticRobot::write(ImportSink& sink) const { return write(0, options_.seconds, sink); }

Result<ImportReport> SyntheticRobot::write(double from, double to, ImportSink& sink) const {
  ImportReport report;
  CountingSink counting(sink, report);
  const std::uint64_t end = first_step(std::min(to, options_.seconds));
  for (std::uint64_t number = first_step(from); number < end; ++number) {
    const SyntheticMoment moment{static_cast<double>(number) / kStepsPerSecond, number, options_.epoch_ns,
                                 options_.image_width, options_.image_width * 3 / 4};
    Step step(moment, counting);
    put_body(step, moment, noise_);
    if (number % kThink == 0) put_thoughts(step, moment, sights_[static_cast<std::size_t>(number / kThink)], noise_);
    put_rest(step, moment);
    if (!step.done()) return step.done().failure();
  }
  return report;
}

}  // namespace robot::lab
