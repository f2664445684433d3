#include "sim/io/source.h"

#include <algorithm>

#include "robot/core/files.h"
#include "sim/io/embedded.h"
#include "sim/io/words.h"

namespace sim::io {

using robot::Error;
using robot::Result;

std::vector<std::string_view> names_of(std::string_view kind) {
  std::vector<std::string_view> names;
  for (const Embedded& file : embedded_files())
    if (file.kind == kind) names.push_back(file.name);
  return names;
}

bool is_embedded(std::string_view kind, std::string_view name) {
  return std::ranges::any_of(embedded_files(),
                             [&](const Embedded& file) { return file.kind == kind && file.name == name; });
}

bool is_path(std::string_view name) { return name.find('/') != name.npos || name.ends_with(".json"); }

Error unknown_name(std::string_view noun, std::string_view name, const std::vector<std::string_view>& known) {
  return {"no " + std::string(noun) + " '" + std::string(name) + "'" + hint(name, known)};
}

Result<Source> find_source(std::string_view kind, std::string_view noun, const std::string& name) {
  Source source{.text = {}, .called = std::string(noun) + " '" + name + "'"};
  if (is_path(name)) {
    Result<std::string> text = robot::read_file(name, kMaxFileBytes);
    if (!text) return text.failure(source.called);
    source.text = std::move(*text);
    return source;
  }
  for (const Embedded& file : embedded_files())
    if (file.kind == kind && file.name == name) {
      source.text = file.text;
      return source;
    }
  return unknown_name(noun, name, names_of(kind));
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string all;
  for (const std::string_view name : names) all.append(all.empty() ? "" : ", ").append(name);
  return all;
}

}  // namespace sim::io
