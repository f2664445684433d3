#include "robot/app/asked_moment.h"

#include <cstdint>
#include <utility>

#include "robot/bridge/teams_seen.h"
#include "robot/core/clock.h"
#include "robot/core/encoding.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace robot::app {
namespace {

namespace pb = foresight;
using nlohmann::json;

constexpr std::uint64_t kSameMomentNs = 200 * kMillisecond;
constexpr std::size_t kMostText = 1000;  // [bytes] of a name or a path in a request

template <class Message>
Result<bridge::Remembered<Message>> message_in(const json& object, const std::string& name) {
  const Error wrong{"objects." + name + R"( must be {"capture_ns": "1700…", "data": "base64"})"};
  if (!object.is_object()) return wrong;
  const auto capture_ns = number_in_text<std::uint64_t>(object, "capture_ns");
  const auto data = object.find("data");
  if (!capture_ns || data == object.end() || !data->is_string()) return wrong;
  const auto bytes = from_base64(data->get_ref<const std::string&>());
  if (!bytes) return wrong;
  bridge::Remembered<Message> message{.value = {}, .capture_ns = *capture_ns};
  if (!message.value.ParseFromString(*bytes)) return Error{"objects." + name + ".data is no message of that object"};
  return message;
}

/// Reads the objects that a client sent.
Result<AskedMoment> sent_moment(const memory::Channels& channels, const json& request, std::string robot) {
  AskedMoment moment{.robot = std::move(robot), .objects = {}, .truth = {}, .simulation = {}};
  const auto at_ns = number_in_text<std::uint64_t>(request, "at_ns");
  if (!at_ns) return Error{"'at_ns' must be a time in nanoseconds as a text, because there are 'objects'"};
  const json& objects = request["objects"];
  if (!objects.is_object()) return Error{"'objects' must be an object"};
  moment.objects.now_ns = *at_ns;
  moment.objects.speed = bridge::moment_of(channels, *at_ns).speed;
  Result<void> read;
  bridge::Recollection::visit(moment.objects,
                              [&]<class Message>(const char* name, std::optional<bridge::Remembered<Message>>& object) {
                                const auto found = objects.find(name);
                                if (!read || found == objects.end()) return;
                                auto message = message_in<Message>(*found, name);
                                if (message)
                                  object = *std::move(message);
                                else
                                  read = message.failure();
                              });
  if (!read) return read.failure();
  if (const auto found = objects.find("truth"); found != objects.end()) {
    auto truth = message_in<pb::GroundTruth>(*found, "truth");
    if (!truth) return truth.failure();
    moment.truth = std::move(truth->value);
  }
  if (const auto found = objects.find("simulation"); found != objects.end()) {
    auto simulation = message_in<pb::Simulation>(*found, "simulation");
    if (!simulation) return simulation.failure();
    moment.simulation = std::move(simulation->value);
  }
  return moment;
}

/// Reads the newest decision in memory, and what the robot knew then.
Result<AskedMoment> newest_moment(const memory::Channels& channels, std::string robot) {
  const auto decision = bridge::newest<pb::DecisionTrace>(channels, "/" + robot + "/decision");
  if (!decision) return Error{"robot '" + printable(robot, 40) + "' has not decided anything"};
  // memory keeps only the newest value of each object: that of the game must be of the same moment
  const auto game = bridge::newest<pb::GameState>(channels, "/" + robot + "/game");
  if (game && game->capture_ns > decision->capture_ns + kSameMomentNs)
    return Error{"robot '" + printable(robot, 40) +
                 "' decides nothing now: its newest decision is older than its game"};
  AskedMoment moment{.robot = robot,
                     .objects = bridge::recollect(channels, robot, decision->capture_ns),
                     .truth = {},
                     .simulation = {}};
  if (auto truth = bridge::newest<pb::GroundTruth>(channels, memory::kTruthTopic))
    moment.truth = std::move(truth->value);
  return moment;
}

}  // namespace

Result<std::string> text_in(const json& request, const char* key) {
  const auto found = request.find(key);
  if (found != request.end() && found->is_string() && found->get_ref<const std::string&>().size() <= kMostText)
    return found->get<std::string>();
  return Error{std::string("'") + key + "' must be a text of at most " + std::to_string(kMostText) + " bytes"};
}

Result<AskedMoment> asked_moment(const memory::Channels& channels, const json& request) {
  auto robot = text_in(request, "robot");
  if (!robot) return robot.failure();
  return request.contains("objects") ? sent_moment(channels, request, *std::move(robot))
                                     : newest_moment(channels, *std::move(robot));
}

}  // namespace robot::app
