#include "robot/truth/tags/tag_plan.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/truth/tags/tag_family.h"

namespace robot::truth::tags {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostPlanBytes = 1 << 20;

/// The reader of a plan. It keeps the first fault; after one its values are of no use.
class PlanReader {
 public:
  Result<TagPlan> read(const Json& json) {
    const bool whole = has_only(json, "tag plan", {"family", "teams", "tags"});
    if (whole && json.contains("family")) read_family(json["family"]);
    if (whole) read_teams(json.value("teams", Json()));
    if (whole) read_tags(json.value("tags", Json()));
    if (!fault_.empty()) return Error{fault_};
    return std::move(plan_);
  }

 private:
  void refuse(const std::string& place, const std::string& expected, const std::string& got) {
    if (fault_.empty()) fault_ = formatted("%s: expected %s, got %s", place.c_str(), expected.c_str(), got.c_str());
  }

  bool has_only(const Json& object, const std::string& place, const std::vector<std::string_view>& keys) {
    if (!object.is_object()) refuse(place, "an object", shown(object));
    if (!object.is_object()) return false;
    for (const auto& entry : object.items())
      if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
        refuse(place, "one of the keys " + names_of(keys), "'" + printable(entry.key(), 40) + "'");
    return fault_.empty();
  }

  static std::string names_of(const std::vector<std::string_view>& keys) {
    return joined(std::vector<std::string>(keys.begin(), keys.end()), ", ");
  }

  void read_family(const Json& family) {
    plan_.family = family.is_string() ? family.get<std::string>() : "";
    if (!tags_in_family(plan_.family)) refuse("tag plan: family", family_names(), shown(family));
  }

  void read_teams(const Json& teams) {
    if (!teams.is_array() || teams.empty()) return refuse("tag plan: teams", "a list of team numbers", shown(teams));
    for (const Json& team : teams) teams_.push_back(whole("tag plan: teams", team, 0, 255));
  }

  void read_tags(const Json& tags) {
    if (!tags.is_array() || tags.empty()) return refuse("tag plan: tags", "a list of tags", shown(tags));
    for (std::size_t i = 0; i < tags.size() && fault_.empty(); ++i)
      read_tag(tags[i], formatted("tag plan: entry %zu of tags", i + 1));
  }

  void read_tag(const Json& tag, const std::string& entry) {
    if (!has_only(tag, entry, {"id", "team", "player", "edge", "height", "forward", "left", "turn_deg"})) return;
    const int last_id = tags_in_family(plan_.family).value_or(1) - 1;
    const int id = whole(entry + ": id", tag.value("id", Json()), 0, last_id);
    const std::string place = formatted("tag plan: tag %d", id);
    TaggedRobot robot;
    robot.team = static_cast<std::uint32_t>(whole(place + ": team", tag.value("team", Json()), 0, 255));
    robot.player = static_cast<std::uint32_t>(whole(place + ": player", tag.value("player", Json()), 1, 20));
    robot.mounting = mounting_of(tag, place);
    if (std::find(teams_.begin(), teams_.end(), static_cast<int>(robot.team)) == teams_.end())
      refuse(place + ": team", "one of the plan's teams", formatted("%u", robot.team));
    if (!plan_.tags.emplace(id, robot).second) refuse(place, "each id once", "it twice");
  }

  Mounting mounting_of(const Json& tag, const std::string& place) {
    Mounting mounting;
    mounting.edge = number(tag, "edge", place, 0.03, 0.5, "m", std::nullopt);
    mounting.height = number(tag, "height", place, 0.05, 1.5, "m", std::nullopt);
    mounting.forward = number(tag, "forward", place, -0.5, 0.5, "m", 0);
    mounting.left = number(tag, "left", place, -0.5, 0.5, "m", 0);
    mounting.turn = number(tag, "turn_deg", place, -360, 360, "degrees", 0) * std::numbers::pi / 180;
    return mounting;
  }

  int whole(const std::string& place, const Json& value, int least, int most) {
    const std::optional<std::int64_t> number = whole_number(value);
    if (number && *number >= least && *number <= most) return static_cast<int>(*number);
    refuse(place, formatted("a whole number %d .. %d", least, most), shown(value));
    return least;
  }

  double number(const Json& object, const char* key, const std::string& place, double least, double most,
                const char* unit, std::optional<double> absent) {
    const auto found = object.find(key);
    if (found == object.end() && absent) return *absent;
    const Json value = found == object.end() ? Json() : *found;
    if (value.is_number() && value.get<double>() >= least && value.get<double>() <= most) return value.get<double>();
    refuse(place + ": " + key, formatted("%g .. %g %s", least, most, unit), shown(value));
    return least;
  }

  TagPlan plan_;
  std::vector<int> teams_;
  std::string fault_;
};

}  // namespace

Result<TagPlan> parse_tag_plan(std::string_view text) {
  const Result<Json> json = parse_json(text);
  if (!json) return json.failure("tag plan");
  return PlanReader().read(*json);
}

Result<TagPlan> read_tag_plan(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file, kMostPlanBytes);
  if (!text) return text.failure();
  Result<TagPlan> plan = parse_tag_plan(*text);
  if (!plan) return plan.failure(file.string());
  return plan;
}

}  // namespace robot::truth::tags
