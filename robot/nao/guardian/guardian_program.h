// The guardian as a process: one thread between LoLA and the runtime that blocks on neither.
#pragma once

#include <poll.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/nao/guardian/guardian.h"
#include "robot/nao/guardian/lola_connection.h"
#include "robot/nao/guardian/runtime_link.h"
#include "robot/nao/lola/actuators.h"

namespace robot::nao {

struct GuardianOptions {
  std::filesystem::path lola = kLolaPath;
  std::filesystem::path link;  // default_link()
};

/// The loop of the guardian's process. It answers every frame of LoLA with the guardian's decision, sends reports to
/// the runtime, and reconnects to LoLA after a loss.
class GuardianProgram {
 public:
  /// Opens the link. Returns an Error if another guardian runs.
  static Result<GuardianProgram> open(GuardianOptions options);

  /// Runs until `end_file` is readable and the robot sits. Without LoLA it ends as soon as `end_file` is readable.
  void run(int end_file);

 private:
  GuardianProgram(GuardianOptions options, RuntimeLink link) : options_(std::move(options)), link_(std::move(link)) {}

  void wait(int end_file);
  void find_lola();
  void lose_lola(const std::string& why);
  void serve_lola();
  Result<void> answer(std::string_view frame);
  void tell(const std::string& unreadable, const Actuators& answer);
  void tell_problem();
  void remember(const RuntimeLink::Heard& heard);

  const GuardianOptions options_;
  RuntimeLink link_;
  Guardian guardian_;
  std::optional<LolaConnection> lola_;
  ActuatorFrame frame_;
  Sensors sensors_;
  Report report_;
  RuntimeLink::Heard heard_;  // since the last frame
  std::vector<pollfd> files_;

  bool ends_ = false;
  bool silent_ = true;  // no frame since LoLA was connected
  std::uint64_t next_try_ns_ = 0, connected_ns_ = 0, frame_ns_ = 0, told_ns_ = 0;
  std::uint64_t frames_ = 0;
  std::string problem_;
  Reason said_ = Reason::waits_for_button;
  Throttle unreadable_;
};

}  // namespace robot::nao
