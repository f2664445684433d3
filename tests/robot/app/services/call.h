// Calls of services in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "robot/core/json_library.h"
#include "robot/net/foxglove/services.h"

namespace tests {

/// Calls the service of that name, as a client that may control. If there is none, the test fails.
inline nlohmann::json call(const robot::net::Services& services, const std::string& name,
                           const nlohmann::json& request = nlohmann::json::object()) {
  for (const auto& service : services.list())
    if (service.name == name)
      return nlohmann::json::parse(services.call(service.id, request.dump(), {.may_control = true}));
  ADD_FAILURE() << "there is no service " << name;
  return {};
}

}  // namespace tests
