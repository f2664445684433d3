#include "robot/app/services/step_service.h"

#include <optional>
#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr const char* kStepService = "message_beside";

json no_step(const std::string& sentence) { return net::failure(std::string(kStepService) + ": " + sentence); }

/// Returns the capture time [ns] of the next message, or nothing at the stream's end.
std::optional<std::uint64_t> next_time(logging::InProvider& stream) {
  while (true) {
    const auto record = stream.read();
    if (!record) continue;  // damaged records are skipped; the parser has reported them
    if (!*record) return std::nullopt;
    return (*record)->capture_ns;
  }
}

Result<std::uint64_t> time_after(logging::InProvider& stream, std::uint64_t from_ns, std::int64_t steps) {
  if (const Result<void> sought = stream.seek(from_ns); !sought) return sought.failure();
  std::uint64_t at_ns = from_ns;
  while (steps > 0) {
    const auto next_ns = next_time(stream);
    if (!next_ns) break;
    if (*next_ns <= at_ns) continue;
    at_ns = *next_ns;
    --steps;
  }
  return at_ns;
}

Result<std::uint64_t> time_before(logging::InProvider& stream, std::uint64_t from_ns, std::int64_t steps) {
  std::uint64_t at_ns = from_ns;
  for (; steps > 0 && at_ns > 0; --steps) {
    if (const Result<void> sought = stream.seek(at_ns - 1); !sought) return sought.failure();
    const auto found_ns = next_time(stream);
    if (!found_ns || *found_ns >= at_ns) break;  // the first of the stream
    at_ns = *found_ns;
  }
  return at_ns;
}

json answer(const json& request, const logging::StreamOf& open) {
  const auto topic = request.find("topic");
  if (topic == request.end() || !topic->is_string()) return no_step("'topic' must be a text");
  const auto from_ns = number_in_text<std::uint64_t>(request, "from_ns");
  if (!from_ns) return no_step("'from_ns' must be a text with a whole number");
  const auto named = request.find("by");
  constexpr std::int64_t none = kLongestStep + 1;
  const std::int64_t by = named == request.end() ? none : whole_number(*named).value_or(none);
  if (by < -kLongestStep || by > kLongestStep)
    return no_step("'by' must be a whole number from " + std::to_string(-kLongestStep) + " to " +
                   std::to_string(kLongestStep));
  const auto stream = open(topic->get<std::string>());
  if (!stream) return no_step("topic '" + topic->get<std::string>() + "' is not played");
  if (const auto opened = stream->open(); !opened) return no_step(opened.error());
  const Result<std::uint64_t> at_ns = by < 0 ? time_before(*stream, *from_ns, -by) : time_after(*stream, *from_ns, by);
  if (!at_ns) return no_step(at_ns.error());
  return {{"ok", true}, {"at_ns", std::to_string(*at_ns)}};
}

}  // namespace

void add_step_service(net::Services& services, logging::StreamOf open) {
  services.add(
      kStepService, net::Services::For::control,
      [open = std::move(open)](const json& request, const net::ClientContext&) { return answer(request, open); });
}

}  // namespace robot::app
