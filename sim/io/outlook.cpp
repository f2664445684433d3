#include "sim/io/outlook.h"

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/variation.h"

namespace sim::io {

using foresight::Outlook;
using robot::Result;

namespace {

constexpr float kMostWorth = 1;  // [goals]

struct Reach {
  float reach = 60;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("reach", self.reach, "s", 1.f, 600.f);
  }
};

bool is_worth(const Json& json) {
  return json.is_number() && std::abs(json.get<double>()) <= static_cast<double>(kMostWorth);
}

void read_worth(Reader& reader, const Json& json, Outlook& outlook) {
  const auto zones = static_cast<std::size_t>(Outlook::kZones);
  bool good = json.is_array() && json.size() == zones;
  for (std::size_t zone = 0; good && zone < zones; ++zone) {
    const Json& pair = json[zone];
    good = pair.is_array() && pair.size() == 2 && is_worth(pair[0]) && is_worth(pair[1]);
    for (std::size_t touch = 0; good && touch < 2; ++touch) outlook.worth[zone][touch] = pair[touch].get<float>();
  }
  if (!good) reader.refuse("worth must be a list of 8 pairs of numbers -1 .. 1 [goals], got " + shown(json));
}

}  // namespace

Result<Outlook> parse_outlook(std::string_view text, const std::string& called) {
  const Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called);
  Reach reach;
  Outlook outlook;
  reader.read(*json, "", Fields::all, reach, {"name", "about", "worth"});
  if (const Json* worth = reader.find(*json, "worth", Fields::all)) read_worth(reader, *worth, outlook);
  if (!reader.good()) return reader.error();
  outlook.reach = reach.reach;
  return outlook;
}

Result<Outlook> load_outlook(const std::string& rules) {
  const Result<Variation> variation = parse_variation(rules, "rules '" + rules + "'");
  if (!variation) return variation.failure();
  if (is_path(variation->name)) return Outlook{};
  const Result<Source> source = find_source("outlooks", "outlook", variation->name);
  if (!source) return source.failure();
  return parse_outlook(source->text, source->called);
}

std::string print_outlook(const Outlook& outlook, const std::string& name, const std::string& about) {
  Json json = {{"name", name}, {"about", about}, {"reach", entry_of(outlook.reach, "s", "")}, {"worth", Json::array()}};
  for (const auto& pair : outlook.worth) json["worth"].push_back({short_number(pair[0]), short_number(pair[1])});
  return printed(json);
}

}  // namespace sim::io
