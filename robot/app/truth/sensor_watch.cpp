#include "robot/app/truth/sensor_watch.h"

#include <mutex>
#include <utility>

#include "robot/app/truth/sensor_messages.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::app {
namespace {

using State = foresight::TruthSensor::State;

/// Age of a live image that is too old to be of use: the machine is too slow for all images. The tracks refuse older ones.
constexpr std::uint64_t kLatestNs = 150 * kMillisecond;

std::string number_of(std::size_t index) { return std::to_string(index + 1); }

std::string topic_of(std::size_t index, const char* object) { return "/truth/" + number_of(index) + "/" + object; }

}  // namespace

SensorObjects::SensorObjects(std::size_t index, const Clock& clock) {
  sensor.announce(topic_of(index, "sensor"), memory::Delivery::latest, clock);
  depth.announce(topic_of(index, "depth"), memory::Delivery::latest, clock);
  color.announce(topic_of(index, "color"), memory::Delivery::latest, clock);
}

SensorWatch::SensorWatch(SensorWatchOptions options, std::unique_ptr<truth::DepthSource> source, const Clock& clock,
                         const Calibrations& calibrations, TruthWriter& writer)
    : options_(std::move(options)),
      name_("sensor " + number_of(options_.index)),
      source_(std::move(source)),
      clock_(clock),
      calibrations_(calibrations),
      writer_(writer),
      objects_(std::make_shared<SensorObjects>(options_.index, clock)) {}

SensorWatch::~SensorWatch() { stop(); }

Result<void> SensorWatch::list(memory::Channels& channels) const {
  for (memory::Channel* object :
       std::initializer_list<memory::Channel*>{&objects_->sensor, &objects_->depth, &objects_->color})
    if (Result<void> listed = channels.add({objects_, object}); !listed) return listed;
  return {};
}

Result<void> SensorWatch::start() {
  return start_thread(thread_, name_, [this] { run(); });
}

void SensorWatch::stop() {
  {
    const std::lock_guard guard(lock_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::shared_ptr<const truth::DepthFrame> SensorWatch::newest() const {
  const std::lock_guard guard(lock_);
  return newest_;
}

void SensorWatch::place(const PlacedSensor& placed) {
  const std::lock_guard guard(lock_);
  wanted_ = placed;
  background_wanted_ = false;
}

Result<std::size_t> SensorWatch::learn_background() {
  const std::lock_guard guard(lock_);
  const auto refused = [this](const char* reason) {
    return Error{name_ + reason + ", so it cannot learn the empty field"};
  };
  if (!watching_) return refused(" sends no images now");
  if (newest_->depth.empty()) return refused(" is an ordinary camera without depths");
  if (!calibrated_) return refused(" is not calibrated");
  background_wanted_ = true;
  return PlacedFinder::kBackgroundImages;
}

void SensorWatch::run() {
  become_background_thread("truth " + number_of(options_.index));
  tell(State::TruthSensor_State_STATE_WAITING, clock_.now_ns());
  while (!stopping_ && read_one()) {
  }
}

bool SensorWatch::read_one() {
  Result<std::optional<truth::DepthFrame>> frame = source_->next();
  if (!frame) {
    lose(frame.error());
    return true;
  }
  if (!*frame) {
    writer_.lost(options_.index);
    tell(State::TruthSensor_State_STATE_ENDED, clock_.now_ns());
    return false;
  }
  look(std::make_shared<const truth::DepthFrame>(std::move(**frame)));
  return true;
}

void SensorWatch::lose(const std::string& problem) {
  if (problem != problem_) report(Level::warning, name_, problem);
  problem_ = problem;
  writer_.lost(options_.index);
  tell(State::TruthSensor_State_STATE_WAITING, clock_.now_ns());
}

void SensorWatch::look(const std::shared_ptr<const truth::DepthFrame>& frame) {
  if (options_.paced && !wait_until(frame->capture_ns)) return;
  {
    const std::lock_guard guard(lock_);
    newest_ = frame;
  }
  if (source_->live() && frame->capture_ns + kLatestNs < clock_.now_ns()) return leave_out();
  shown_ns_ = monotonic_ns();
  const std::uint64_t begun_ns = thread_cpu_ns();
  problem_.clear();
  take_place(*frame);
  begin_background();
  const bool searched = search(*frame);
  pulse_.add(monotonic_ns(), thread_cpu_ns() - begun_ns);
  if (searched) writer_.add(options_.index, seen_);
  show(*frame);
}

bool SensorWatch::search(const truth::DepthFrame& frame) {
  seen_ = {};
  if (!finder_) return false;
  if (background_awaited_ > 0) {
    learn(frame);
    return false;
  }
  auto seen = finder_->find(frame);
  if (!seen) {
    problem_ = seen.error();
    return false;
  }
  seen_ = std::move(*seen);
  seen_.detected_ns = clock_.now_ns();
  return true;
}

/// The image is not searched too, because the search after each change of the background takes 100 ms.
void SensorWatch::learn(const truth::DepthFrame& frame) {
  writer_.lost(options_.index);
  --background_awaited_;
  if (const Result<void> learned = finder_->learn_background(frame); !learned) {
    problem_ = learned.error();
    background_awaited_ = 0;
  }
}

void SensorWatch::leave_out() {
  ++left_out_;
  // a slow machine leaves out an image now and then
  if (monotonic_ns() - shown_ns_ > kSecond) lose("its images come more than 150 ms late and are left out");
}

bool SensorWatch::wait_until(std::uint64_t capture_ns) {
  const std::lock_guard guard(lock_);
  for (std::uint64_t now_ns = clock_.now_ns(); now_ns < capture_ns && !stopping_; now_ns = clock_.now_ns())
    changed_.wait_until(lock_, monotonic_ns() + (capture_ns - now_ns));
  return !stopping_;
}

void SensorWatch::take_place(const truth::DepthFrame& frame) {
  std::optional<PlacedSensor> wanted;
  {
    const std::lock_guard guard(lock_);
    wanted.swap(wanted_);
  }
  if (!wanted && !placed_ && !asked_) {
    asked_ = true;
    auto saved = calibrations_.find(source_->address(), frame.intrinsics);
    if (!saved) {
      refusal_ = saved.error();
      report(Level::warning, name_, refusal_);
    } else if (*saved) {
      wanted = PlacedSensor{.pose = (*saved)->pose,
                            .lens = (*saved)->lens,
                            .error_mean = (*saved)->error_mean,
                            .error_p95 = (*saved)->error_p95};
    }
  }
  if (wanted) use(*wanted);
  if (!finder_) problem_ = refusal_;
}

void SensorWatch::begin_background() {
  const std::lock_guard guard(lock_);
  if (background_wanted_) background_awaited_ = PlacedFinder::kBackgroundImages;
  background_wanted_ = false;
}

void SensorWatch::use(const PlacedSensor& placed) {
  auto finder = options_.finder.at(placed);
  if (!finder) {
    refusal_ = finder.error();
    report(Level::error, name_, refusal_);
    return;
  }
  refusal_.clear();
  finder_ = std::move(*finder);
  background_awaited_ = 0;
  placed_ = placed;
  writer_.place(options_.index, {.pose = placed.pose, .robots = options_.finder.robots});
}

void SensorWatch::show(const truth::DepthFrame& frame) {
  pinhole_ = frame.intrinsics;
  const std::string frame_id = "truth " + number_of(options_.index);
  if (!frame.depth.empty()) {
    auto depth = objects_->depth.draft();
    to_proto(frame, frame_id, *depth);
    objects_->depth.write(std::move(depth), frame.capture_ns);
  }
  auto color = objects_->color.draft();
  if (colour_to_proto(frame, frame_id, *color)) objects_->color.write(std::move(color), frame.capture_ns);
  tell(State::TruthSensor_State_STATE_WATCHING, frame.capture_ns);
}

void SensorWatch::tell(State state, std::uint64_t capture_ns) {
  {
    const std::lock_guard guard(lock_);
    watching_ = state == State::TruthSensor_State_STATE_WATCHING;
    calibrated_ = finder_ != nullptr;
  }
  auto message = objects_->sensor.draft();
  message->set_state(state);
  message->set_address(source_->address());
  message->set_problem(problem_);
  message->set_left_out(left_out_);
  message->set_rate_hz(static_cast<float>(pulse_.rate_hz(monotonic_ns())));
  message->set_detection_ms(static_cast<float>(pulse_.milliseconds()));
  if (pinhole_) to_proto(*pinhole_, *message->mutable_pinhole());
  if (placed_) {
    to_proto(placed_->pose, *message->mutable_place());
    message->mutable_place()->set_error_mean(static_cast<float>(placed_->error_mean));
    message->mutable_place()->set_error_p95(static_cast<float>(placed_->error_p95));
  }
  if (finder_) {
    message->set_background_images(static_cast<std::uint32_t>(finder_->background_images()));
    if (const auto refused = finder_->refused()) to_proto(*refused, *message->mutable_refused_tags());
  }
  message->set_background_awaited(static_cast<std::uint32_t>(background_awaited_));
  if (state == State::TruthSensor_State_STATE_WATCHING) to_proto(seen_, *message);
  objects_->sensor.write(std::move(message), capture_ns);
}

}  // namespace robot::app
