// Foreign input of the lab machine: mappings, messages that are mapped or shifted, addresses. The first byte chooses.
#include <cstddef>
#include <cstdint>
#include <string>

#include "proto/foresight/truth.pb.h"
#include "robot/core/json.h"
#include "robot/lab/mapping/mapping.h"
#include "robot/lab/relay/robot_address.h"
#include "robot/memory/schema.h"
#include "robot/memory/time_shift.h"

namespace {

using robot::lab::TopicRule;

/// Takes numbers, texts, lists and messages within messages.
const TopicRule& rule() {
  static const TopicRule rule =
      robot::lab::parse_mapping("map", R"({"robot": "14/2", "topics": {"/a": {"object": "/truth/world",
      "fields": {"ball": {"from": "b", "fields": {"x": "x[1]", "y": {"from": "y", "scale": 2}}},
                 "robots": {"each": "r", "fields": {"team": "t", "fallen": "f", "x": "@time"}}}}}})")
          ->topics.at(0);
  return rule;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0: robot::lab::parse_mapping("map", bytes).operator bool(); break;
    case 1: {
      if (const auto json = robot::parse_json(bytes))
        for (const bool strict : {true, false}) robot::lab::mapped(rule(), *json, 5, strict).operator bool();
      break;
    }
    case 2: {
      robot::memory::TimeShift any({.topic = "/a", .schema = {.name = "a.B", .encoding = "protobuf", .bytes = bytes}},
                                   5);
      any.moved(bytes, 5);
      robot::memory::TimeShift truth(
          {.topic = "/a", .schema = robot::memory::schema_of(*foresight::GroundTruth::descriptor())}, 5);
      truth.moved(bytes, 5);
      break;
    }
    default: robot::lab::web_socket_address(bytes).operator bool();
  }
  return 0;
}
