// Values in error sentences.
#pragma once

#include <cstdio>
#include <string>

#include "robot/core/json_library.h"

namespace robot::foreseeing {

/// Returns the value as JSON, cut to 60 bytes.
inline std::string shown(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 60) + "…";
  return text;
}

/// Returns a number such as "0.75" or "1e+09".
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace robot::foreseeing
