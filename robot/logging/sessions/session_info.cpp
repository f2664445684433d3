#include "robot/logging/sessions/session_info.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace robot::logging {
namespace {

constexpr const char* kSessionMetadata = "foresight.session";

/// The facts of a JSON object, one after the other. Remembers the first one that is missing or of the wrong type.
class Taker {
 public:
  explicit Taker(const nlohmann::json& json) : json_(json) {}

  void take(const char* key, std::string& value) {
    const auto found = json_.find(key);
    if (found == json_.end() || !found->is_string()) return refuse(key);
    value = found->get<std::string>();
  }

  void take(const char* key, bool& value) {
    const auto found = json_.find(key);
    if (found == json_.end() || !found->is_boolean()) return refuse(key);
    value = found->get<bool>();
  }

  /// Accepts 14.0 for 14, because other programs write whole numbers so.
  void take(const char* key, int& value) {
    const auto found = json_.find(key);
    const double number = found != json_.end() && found->is_number() ? found->get<double>() : std::nan("");
    if (!(number == std::floor(number) && std::abs(number) <= std::numeric_limits<int>::max())) return refuse(key);
    value = static_cast<int>(number);
  }

  void take(const char* key, std::vector<std::string>& value) {
    const auto found = json_.find(key);
    const auto is_text = [](const nlohmann::json& one) { return one.is_string(); };
    if (found == json_.end() || !found->is_array() || !std::ranges::all_of(*found, is_text)) return refuse(key);
    value = found->get<std::vector<std::string>>();
  }

  /// Takes a number of 64 bits, which is written as text.
  void take(const char* key, std::uint64_t& value) {
    std::string text;
    take(key, text);
    if (!text.empty()) value = std::strtoull(text.c_str(), nullptr, 10);
  }

  void take(const char* key, std::int64_t& value) {
    std::string text;
    take(key, text);
    if (!text.empty()) value = std::strtoll(text.c_str(), nullptr, 10);
  }

  bool has(const char* key) const { return json_.contains(key); }
  const std::string& wrong() const { return wrong_; }

 private:
  void refuse(const char* key) {
    if (wrong_.empty()) wrong_ = key;
  }

  const nlohmann::json& json_;
  std::string wrong_;
};

}  // namespace

std::string to_json(const SessionInfo& info) {
  nlohmann::json json{{"name", info.name},
                      {"robot", info.robot},
                      {"team", info.team},
                      {"player", info.player},
                      {"build", info.build},
                      {"profile", info.profile},
                      {"start_ns", std::to_string(info.start_ns)},
                      {"number", std::to_string(info.number)},
                      {"boot", info.boot},
                      {"kept", info.kept},
                      {"complete", info.complete}};
  if (!info.about.empty()) json["about"] = info.about;
  if (!info.rules.empty()) json["rules"] = info.rules;
  if (!info.only.empty()) json["only"] = info.only;
  if (info.behind_ns != 0) json["behind_ns"] = std::to_string(info.behind_ns);
  if (info.account) {
    json["messages"] = std::to_string(info.account->messages);
    json["dropped"] = std::to_string(info.account->dropped);
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<SessionInfo> parse_session_info(std::string_view text) {
  SessionInfo info;
  if (const Result<void> taken = take_session_info(text, info); !taken) return taken.failure();
  return info;
}

Result<void> take_session_info(std::string_view text, SessionInfo& info) {
  const Result<nlohmann::json> parsed = parse_json(text);
  if (!parsed) {
    // a person's wish to keep the session is in no other file, so it is taken from a damaged text too
    info.kept = info.kept || text.find("\"kept\": true") != text.npos;
    return parsed.failure("session.json");
  }
  if (!parsed->is_object()) return Error{"session.json: expected a JSON object"};
  Taker taker(*parsed);
  taker.take("name", info.name);
  taker.take("robot", info.robot);
  taker.take("team", info.team);
  taker.take("player", info.player);
  taker.take("build", info.build);
  taker.take("profile", info.profile);
  taker.take("start_ns", info.start_ns);
  // sessions of earlier versions and of other programs have none of these
  if (taker.has("about")) taker.take("about", info.about);
  if (taker.has("rules")) taker.take("rules", info.rules);
  if (taker.has("only")) taker.take("only", info.only);
  if (taker.has("behind_ns")) taker.take("behind_ns", info.behind_ns);
  if (taker.has("number")) taker.take("number", info.number);
  if (taker.has("boot")) taker.take("boot", info.boot);
  if (taker.has("messages") && taker.has("dropped")) {
    info.account.emplace();
    taker.take("messages", info.account->messages);
    taker.take("dropped", info.account->dropped);
  }
  taker.take("kept", info.kept);
  taker.take("complete", info.complete);
  if (!taker.wrong().empty()) return Error{"session.json: '" + taker.wrong() + "' is missing or of the wrong type"};
  return {};
}

MetadataByName metadata_of(const SessionInfo& info) {
  MetadataByName metadata{{kSessionMetadata,
                           {{"name", info.name},
                            {"robot", info.robot},
                            {"team", std::to_string(info.team)},
                            {"player", std::to_string(info.player)},
                            {"build", info.build},
                            {"profile", info.profile},
                            {"start_ns", std::to_string(info.start_ns)}}}};
  if (!info.about.empty()) metadata[kSessionMetadata]["about"] = info.about;
  if (!info.rules.empty()) metadata[kSessionMetadata]["rules"] = info.rules;
  if (!info.only.empty()) metadata[kSessionMetadata]["only"] = joined(info.only, ",");
  if (info.behind_ns != 0) metadata[kSessionMetadata]["behind_ns"] = std::to_string(info.behind_ns);
  if (info.number > 0) metadata[kSessionMetadata]["number"] = std::to_string(info.number);
  if (!info.boot.empty()) metadata[kSessionMetadata]["boot"] = info.boot;
  return metadata;
}

std::optional<SessionInfo> session_info_in(const std::vector<mcap::Metadata>& metadata) {
  const auto found = std::ranges::find(metadata, kSessionMetadata, &mcap::Metadata::name);
  if (found == metadata.end()) return {};
  SessionInfo info;
  for (const auto& [key, value] : found->entries) {
    if (key == "name") info.name = value;
    if (key == "about") info.about = value;
    if (key == "robot") info.robot = value;
    if (key == "team") info.team = std::atoi(value.c_str());
    if (key == "player") info.player = std::atoi(value.c_str());
    if (key == "build") info.build = value;
    if (key == "profile") info.profile = value;
    if (key == "rules") info.rules = value;
    if (key == "only")
      for (const std::string_view object : split(value, ",")) info.only.emplace_back(object);
    if (key == "start_ns") info.start_ns = std::strtoull(value.c_str(), nullptr, 10);
    if (key == "behind_ns") info.behind_ns = std::strtoll(value.c_str(), nullptr, 10);
    if (key == "number") info.number = std::strtoull(value.c_str(), nullptr, 10);
    if (key == "boot") info.boot = value;
  }
  return info;
}

}  // namespace robot::logging
