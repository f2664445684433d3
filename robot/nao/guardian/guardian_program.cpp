#include "robot/nao/guardian/guardian_program.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/nao/guardian/socket_owner.h"

namespace robot::nao {
namespace {

constexpr const char* kSource = "guardian";
constexpr std::uint64_t kTryAgain_ns = kSecond;     // between attempts to connect to LoLA
constexpr std::uint64_t kTellProblem_ns = kSecond;  // between reports without LoLA
constexpr std::uint64_t kSilence_ns = kSecond;      // longest time without frames before reconnecting
constexpr int kPatience_ms = 100;

template <std::size_t Size>
void copy_text(const std::string& text, std::array<char, Size>& to) {
  to.fill('\0');
  std::memcpy(to.data(), text.data(), std::min(text.size(), Size - 1));
}

}  // namespace

Result<GuardianProgram> GuardianProgram::open(GuardianOptions options) {
  Result<RuntimeLink> link = RuntimeLink::open(options.link);
  if (!link) return link.failure();
  return GuardianProgram(std::move(options), std::move(*link));
}

void GuardianProgram::run(int end_file) {
  while (!ends_ || (lola_ && !guardian_.soft())) {
    const Result<void> served = attempt("a cycle", [&] {
      if (!lola_ && monotonic_ns() >= next_try_ns_) find_lola();
      wait(end_file);
      // messages between two frames apply from the next frame on
      remember(link_.hear());
      if (lola_) serve_lola();
      if (!lola_ && monotonic_ns() - told_ns_ >= kTellProblem_ns) tell_problem();
    });
    if (!served) unreadable_.report(Level::error, kSource, served.error());
  }
}

/// Waits until any file is readable, or a timeout.
void GuardianProgram::wait(int end_file) {
  files_.clear();
  link_.add_to(files_);
  if (!ends_) files_.push_back({.fd = end_file, .events = POLLIN, .revents = 0});
  if (lola_) files_.push_back({.fd = lola_->file(), .events = POLLIN, .revents = 0});
  ::poll(files_.data(), files_.size(), kPatience_ms);
  for (const pollfd& file : files_)
    if (file.fd == end_file && file.revents != 0) ends_ = true;
}

void GuardianProgram::remember(const RuntimeLink::Heard& heard) {
  heard_.asked_soft = heard_.asked_soft || heard.asked_soft;
  heard_.runtime_left = heard_.runtime_left || heard.runtime_left;
  heard_.runtime_crashed = heard_.runtime_crashed || heard.runtime_crashed;
  if (heard.runtime_left || heard.runtime_crashed) heard_.order.reset();
  if (heard.order) heard_.order = heard.order;
}

void GuardianProgram::find_lola() {
  next_try_ns_ = monotonic_ns() + kTryAgain_ns;
  Result<LolaConnection> connection = LolaConnection::open(options_.lola);
  if (!connection) return lose_lola(connection.error());
  lola_.emplace(std::move(*connection));
  connected_ns_ = frame_ns_ = monotonic_ns();
  silent_ = true;
}

/// Drops the connection to LoLA. Reports the problem, and the program that has LoLA, if the sentence is a new one.
void GuardianProgram::lose_lola(const std::string& why) {
  if (lola_) guardian_.lose_lola();
  lola_.reset();
  next_try_ns_ = monotonic_ns() + kTryAgain_ns;
  const std::string owner = who_is_connected_to(options_.lola);
  report_.lola_is_taken = !owner.empty();
  const std::string problem = owner.empty() ? why
                                            : "LoLA at " + options_.lola.string() + " belongs to " + owner +
                                                  ", it serves one program at a time";
  if (problem == problem_) return;
  problem_ = problem;
  report(Level::warning, kSource, problem_);
  tell_problem();
}

void GuardianProgram::serve_lola() {
  if (Result<void> taken = lola_->take_in(); !taken) return lose_lola(taken.error());
  while (true) {
    const Result<std::string_view> frame = lola_->frame();
    if (!frame) return lose_lola(frame.error());
    if (frame->empty()) break;
    frame_ns_ = monotonic_ns();
    if (Result<void> answered = answer(*frame); !answered) return lose_lola(answered.error());
  }
  if (monotonic_ns() - frame_ns_ >= kSilence_ns) lose_lola("LoLA sends no frames");
}

Result<void> GuardianProgram::answer(std::string_view frame) {
  const Result<void> read = lola_->read(frame, sensors_);
  if (!read) unreadable_.report(Level::warning, kSource, read.error());
  if (read && std::exchange(silent_, false)) {
    report(Level::info, kSource,
           "LoLA is there: body " + lola_->identity().body_id + ", head " + lola_->identity().head_id);
    problem_.clear();
    report_.lola_is_taken = false;
  }
  const RuntimeLink::Heard heard = std::exchange(heard_, {});
  const Actuators& actuators = guardian_.step({.now_ns = frame_ns_,
                                               .sensors = read ? &sensors_ : nullptr,
                                               .order = heard.order ? &*heard.order : nullptr,
                                               .asked_soft = heard.asked_soft,
                                               .runtime_left = heard.runtime_left,
                                               .runtime_crashed = heard.runtime_crashed,
                                               .stop = ends_});
  if (Result<void> answered = lola_->answer(frame_.compose(actuators)); !answered) return answered;
  ++frames_;
  tell(read ? "" : read.error(), actuators);
  if (std::exchange(said_, guardian_.reason()) != guardian_.reason())
    report(Level::info, kSource,
           std::string(name_of(guardian_.mode())) + ", " + name_of(guardian_.doing()) +
               (said_ == Reason::none ? "" : std::string(": ") + sentence_of(said_)));
  return {};
}

void GuardianProgram::tell(const std::string& unreadable, const Actuators& answer) {
  report_.mode = guardian_.mode();
  report_.doing = guardian_.doing();
  report_.reason = guardian_.reason();
  report_.has_lola = true;
  report_.has_sensors = unreadable.empty();
  report_.limited = guardian_.limited();
  const auto fell = guardian_.fell();
  report_.lies_known = fell.has_value();
  if (fell) {
    report_.lies_roll = (*fell)[0];
    report_.lies_pitch = (*fell)[1];
  }
  report_.remaining = guardian_.remaining();
  report_.capture_ns = frame_ns_;
  report_.frames = frames_;
  report_.sensors = sensors_;
  report_.commanded = answer.position;
  report_.commanded_stiffness = answer.stiffness;
  copy_text(lola_->identity().body_id, report_.body_id);
  copy_text(lola_->identity().body_version, report_.body_version);
  copy_text(lola_->identity().head_id, report_.head_id);
  copy_text(lola_->identity().head_version, report_.head_version);
  copy_text(unreadable, report_.problem);
  link_.tell(report_);
}

void GuardianProgram::tell_problem() {
  told_ns_ = monotonic_ns();
  report_.has_lola = lola_.has_value();
  report_.has_sensors = false;
  copy_text(problem_, report_.problem);
  link_.tell(report_);
}

}  // namespace robot::nao
