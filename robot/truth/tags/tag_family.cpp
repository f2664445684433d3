#include "robot/truth/tags/tag_family.h"

#include <array>
#include <utility>

namespace robot::truth::tags {
namespace {

constexpr std::array<std::pair<std::string_view, int>, 3> kFamilies{
    {{"tag36h11", 587}, {"tag36h10", 2320}, {"tag25h9", 35}}};

}  // namespace

std::optional<int> tags_in_family(std::string_view family) {
  for (const auto& [name, count] : kFamilies)
    if (name == family) return count;
  return std::nullopt;
}

std::string family_names() { return "tag36h11, tag36h10 or tag25h9"; }

}  // namespace robot::truth::tags
