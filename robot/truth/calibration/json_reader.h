// The members of JSON objects from outside, each checked.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "robot/core/result.h"

namespace robot::truth {

/// A reader that keeps the first problem and returns harmless values after it. `where` opens the sentence of an Error.
class JsonReader {
 public:
  explicit JsonReader(std::string where) : where_(std::move(where)) {}

  bool good() const { return problem_.empty(); }
  Error error() const { return {where_ + ": " + problem_}; }
  /// Records a problem, unless there is one already.
  void refuse(const std::string& problem);

  double number(const nlohmann::json& object, const char* key, double least, double most);
  int whole(const nlohmann::json& object, const char* key, int least, int most);
  bool truth(const nlohmann::json& object, const char* key);
  /// Returns a text of at most 200 bytes.
  std::string text(const nlohmann::json& object, const char* key);
  /// Returns exactly `count` numbers from -most to most.
  std::vector<double> numbers(const nlohmann::json& object, const char* key, std::size_t count, double most);
  /// Return the object, or the list of at most `most` entries, or an empty one.
  const nlohmann::json& object(const nlohmann::json& object, const char* key);
  const nlohmann::json& list(const nlohmann::json& object, const char* key, std::size_t most);

 private:
  const nlohmann::json& member(const nlohmann::json& object, const char* key);

  std::string where_, problem_;
};

}  // namespace robot::truth
