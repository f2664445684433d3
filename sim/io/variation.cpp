#include "sim/io/variation.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

#include <string_view>

namespace sim::io {

using robot::Error;
using robot::Result;
using robot::split;

namespace {

Json value_of(std::string_view text) {
  if (text == "on") return true;
  if (text == "off") return false;
  Json value = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (value.is_number() || value.is_boolean()) return value;
  return std::string(text);
}

/// "walk.forward" leads to changes["walk"]["forward"]; nullptr when another entry is in the way.
Json* entry_at(Json& changes, std::string_view path) {
  Json* at = &changes;
  for (const std::string_view name : split(path, ".")) {
    if (name.empty() || (!at->is_object() && !at->is_null())) return nullptr;
    at = &(*at)[std::string(name)];
  }
  return at->is_null() ? at : nullptr;
}

}  // namespace

Result<Variation> parse_variation(const std::string& text, const std::string& called) {
  const std::vector<std::string_view> parts = split(text, ",");
  Variation variation{.name = std::string(parts[0]), .number = {}, .changes = Json::object()};
  if (const std::size_t colon = parts[0].rfind(':'); colon != std::string_view::npos) {
    variation.name = parts[0].substr(0, colon);
    variation.number = value_of(parts[0].substr(colon + 1));
  }

  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const bool complete = equals != std::string_view::npos && equals + 1 < parts[i].size();
    Json* entry = complete ? entry_at(variation.changes, parts[i].substr(0, equals)) : nullptr;
    if (!entry)
      return Error{called + ": expected name=value behind a comma, once each, got '" + std::string(parts[i]) + "'"};
    *entry = value_of(parts[i].substr(equals + 1));
  }
  return variation;
}

}  // namespace sim::io
