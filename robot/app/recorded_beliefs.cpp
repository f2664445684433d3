#include "robot/app/recorded_beliefs.h"

#include <memory>
#include <optional>
#include <utility>

#include "robot/logging/sessions/read_all.h"

namespace robot::app {
namespace {

/// The messages of one object, read in the order of their times.
template <class Message>
class Cursor {
 public:
  Cursor(const logging::Session& session, const std::string& topic)
      : all_(logging::read_in_order<Message>(session, topic)) {}

  /// Puts the newest message at `now_ns` into `newest`. Called with times that do not decrease.
  void move_to(std::uint64_t now_ns, std::optional<bridge::Remembered<Message>>& newest) {
    const std::size_t before = next_;
    while (next_ < all_.size() && all_[next_].capture_ns <= now_ns) ++next_;
    if (next_ > before) newest = {.value = all_[next_ - 1].value, .capture_ns = all_[next_ - 1].capture_ns};
  }
  bool empty() const { return all_.empty(); }

 private:
  std::vector<logging::Recorded<Message>> all_;
  std::size_t next_ = 0;
};

}  // namespace

RecordedBeliefs::RecordedBeliefs(const logging::Session& session, const std::string& robot) {
  bridge::Recollection::visit(
      now_, [&]<class Message>(const char* name, std::optional<bridge::Remembered<Message>>& newest) {
        auto cursor = std::make_shared<Cursor<Message>>(session, "/" + robot + "/" + name);
        if (cursor->empty()) missing_.insert(name);
        movers_.push_back([cursor, &newest](std::uint64_t now_ns) { cursor->move_to(now_ns, newest); });
      });
}

const char* RecordedBeliefs::missing() const {
  return missing_.contains("pose") ? "pose" : missing_.contains("game") ? "game" : nullptr;
}

const bridge::Recollection& RecordedBeliefs::at(std::uint64_t now_ns) {
  now_.now_ns = now_ns;
  for (const auto& move : movers_) move(now_ns);
  return now_;
}

}  // namespace robot::app
