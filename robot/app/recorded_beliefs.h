// The knowledge of a robot at any moment of a recorded session.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "robot/bridge/from_messages.h"
#include "robot/logging/sessions/session.h"

namespace robot::app {

/// The recorded objects of one robot, read into memory. Used by one thread.
class RecordedBeliefs {
 public:
  /// `robot` is "<team>/<player>".
  RecordedBeliefs(const logging::Session& session, const std::string& robot);
  RecordedBeliefs(const RecordedBeliefs&) = delete;
  RecordedBeliefs& operator=(const RecordedBeliefs&) = delete;

  /// Returns the name of an object that was not recorded and that every decision needs, or nullptr.
  const char* missing() const;

  /// Returns the newest objects at `now_ns` [ns since the epoch]. Called with times that do not decrease.
  const bridge::Recollection& at(std::uint64_t now_ns);

 private:
  bridge::Recollection now_;
  std::vector<std::function<void(std::uint64_t)>> movers_;  // one for each object of `now_`
  std::set<std::string> missing_;
};

}  // namespace robot::app
