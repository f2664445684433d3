#include "robot/body/nao/nao_body.h"

#include <chrono>
#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "robot/nao/guardian/lola_connection.h"
#include "robot/nao/guardian/socket_owner.h"
#include "robot/nao/motion/messages.h"

namespace robot::body {
namespace {

constexpr const char* kSource = "nao";
constexpr int kPatience_ms = 100;
constexpr int kFirstWord_ms = 2000;
constexpr std::uint64_t kTryAgain_ns = kSecond;
constexpr std::uint64_t kBody_ns = kSecond, kBattery_ns = kSecond, kSonar_ns = kSecond / 10;  // between two versions
constexpr std::uint64_t kNear_ns = 50 * kMillisecond;  // largest distance in time between an image and its joints
constexpr std::size_t kSamples = 64;                   // 0.75 s of them

std::uint64_t distance(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

}  // namespace

std::string NaoBody::taken_by_others(const NaoOptions& options) {
  Result<nao::GuardianClient> guardian = nao::GuardianClient::open(options.link);
  if (!guardian) {
    const std::string owner = nao::who_is_connected_to(nao::kLolaPath);
    return owner.empty() ? "" : "LoLA at " + std::string(nao::kLolaPath) + " belongs to " + owner;
  }
  const auto report = guardian->next(kFirstWord_ms);
  return report && *report && (*report)->lola_is_taken ? (*report)->problem.data() : "";
}

NaoBody::NaoBody(NaoOptions options, memory::Memory& memory, const SessionClock& clock)
    : options_(std::move(options)),
      memory_(memory),
      clock_(clock),
      kinematics_(options_.calibration),
      motion_(kinematics_, options_.walk) {}

Result<void> NaoBody::start() {
  return start_thread(thread_, "nao", [this] { run(); });
}

NaoBody::~NaoBody() {
  ends_ = true;
  if (thread_.joinable()) thread_.join();
}

void NaoBody::run() {
  name_thread("nao");
  while (!ends_)
    if (const Result<void> done = attempt("a cycle", [this] { cycle(); }); !done)
      report(Level::error, kSource, done.error());
  if (guardian_) static_cast<void>(guardian_->ask(nao::Request::What::goodbye));
}

/// Takes the guardian's reports and answers the newest one.
void NaoBody::cycle() {
  if (!guardian_ && !find_guardian()) return;
  Result<std::optional<nao::Report>> report = guardian_->next(kPatience_ms);
  // every report goes into memory; only the newest one is answered
  std::optional<nao::Report> newest;
  while (report && *report) {
    newest = **report;
    take(*newest);
    report = guardian_->next(0);
  }
  if (!report) {
    guardian_.reset();
    return write_body(nullptr, report.error());
  }
  if (!newest) return;
  const std::uint64_t capture_ns = newest->capture_ns + clock_.epoch_offset_ns();
  // if this fails, the guardian is gone, and the next report returns that error
  if (newest->has_sensors) static_cast<void>(guardian_->give(order_after(*newest, capture_ns)));
  write_body(&*newest, "");
}

bool NaoBody::find_guardian() {
  if (monotonic_ns() < next_try_ns_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kPatience_ms));
    return false;
  }
  next_try_ns_ = monotonic_ns() + kTryAgain_ns;
  Result<nao::GuardianClient> guardian = nao::GuardianClient::open(options_.link);
  if (!guardian) {
    write_body(nullptr, guardian.error());
    return false;
  }
  guardian_.emplace(std::move(*guardian));
  return true;
}

void NaoBody::take(const nao::Report& report) {
  if (!report.has_sensors) return;
  const std::uint64_t capture_ns = report.capture_ns + clock_.epoch_offset_ns();
  write_sensors(report, capture_ns);
  const std::lock_guard guard(lock_);
  samples_.push_back({.capture_ns = capture_ns, .position = report.sensors.position, .angles = report.sensors.angles});
  if (samples_.size() > kSamples) samples_.pop_front();
}

void NaoBody::write_sensors(const nao::Report& report, std::uint64_t capture_ns) {
  const auto write = [&](auto& object) {
    auto draft = object.draft();
    nao::fill(report, *draft);
    object.write(std::move(draft), capture_ns);
  };
  write(memory_.joints);
  write(memory_.inertial);
  write(memory_.fsr);
  write(memory_.touch);
  if (capture_ns - sonar_ns_ >= kSonar_ns) {
    sonar_ns_ = capture_ns;
    write(memory_.sonar);
  }
  if (capture_ns - battery_ns_ >= kBattery_ns) {
    battery_ns_ = capture_ns;
    write(memory_.battery);
  }
  auto status = memory_.motion_status.draft();
  motion_.fill_status(report, *status);
  memory_.motion_status.write(std::move(status), capture_ns);
  if (!motion_.has_odometry()) return;
  auto odometry = memory_.odometry.draft();
  motion_.fill_odometry(*odometry);
  memory_.odometry.write(std::move(odometry), capture_ns);
}

void NaoBody::change_walk(const nao::walk::Parameters& parameters) {
  const std::lock_guard guard(lock_);
  changed_walk_ = parameters;
}

nao::Order NaoBody::order_after(const nao::Report& report, std::uint64_t capture_ns) {
  {
    const std::lock_guard guard(lock_);
    if (changed_walk_) motion_.change_walk(*std::exchange(changed_walk_, std::nullopt));
  }
  const auto command = memory_.motion_command.read();
  const auto game = memory_.game.read();
  const std::uint64_t said_ns = command ? command->capture_ns() : 0;
  return motion_.next(report, command ? &command->value() : nullptr, capture_ns > said_ns ? capture_ns - said_ns : 0,
                      game ? &game->value() : nullptr);
}

/// Writes the object `body`. `report` is null without a guardian; `problem` is the reason.
void NaoBody::write_body(const nao::Report* report, const std::string& problem) {
  foresight::Body body;
  if (report) nao::fill(*report, body);
  if (!report) body.set_reason(problem);
  body.set_refused(motion_.refused());
  const std::uint64_t now_ns = clock_.now_ns();
  const bool changed = body.SerializeAsString() != body_.SerializeAsString();
  if (!changed && now_ns - body_ns_ < kBody_ns) return;
  if (body.reason() != body_.reason()) say(body.reason());
  if (body.refused() != body_.refused()) say(body.refused());
  body_ = body;
  body_ns_ = now_ns;
  memory_.body.write(body, now_ns);
}

void NaoBody::say(const std::string& sentence) {
  if (!sentence.empty()) report(Level::warning, kSource, sentence);
}

std::optional<nao::Transform> NaoBody::robot_from_camera(nao::Camera camera, std::uint64_t capture_ns) const {
  std::optional<JointSample> nearest;
  {
    const std::lock_guard guard(lock_);
    for (const JointSample& sample : samples_)
      if (!nearest || distance(sample.capture_ns, capture_ns) < distance(nearest->capture_ns, capture_ns))
        nearest = sample;
  }
  if (!nearest || distance(nearest->capture_ns, capture_ns) > kNear_ns) return std::nullopt;
  return kinematics_.robot_from_hip(nearest->position, nearest->angles[0], nearest->angles[1]) *
         kinematics_.hip_from_camera(nearest->position, camera);
}

Result<void> sit_and_soft(const std::filesystem::path& link) {
  Result<nao::GuardianClient> guardian = nao::GuardianClient::open(link);
  if (!guardian) return guardian.failure();
  return guardian->ask(nao::Request::What::sit_and_soft);
}

}  // namespace robot::body
