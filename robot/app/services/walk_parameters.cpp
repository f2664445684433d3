#include "robot/app/services/walk_parameters.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/foresight/live_parameters.pb.h"
#include "robot/memory/schema.h"
#include "robot/nao/walk/named_parameters.h"

namespace robot::app {
namespace {

using foresight::LiveParameter;
using foresight::LiveParameters;
using nao::walk::kNamedParameters;
using nao::walk::NamedParameter;

constexpr std::string_view kPrefix = "walk.";

std::string sentence(std::string_view words) {
  std::string made = std::string(words) + ".";
  made.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(made.front())));
  return made;
}

LiveParameters announcement(const nao::walk::Parameters& settings) {
  LiveParameters all;
  for (const NamedParameter& named : kNamedParameters) {
    const double present = settings.*named.place;
    const auto [low, high] = nao::walk::range_of(named.place);
    LiveParameter& one = *all.add_parameter();
    one.set_name(std::string(named.name));
    one.set_type(LiveParameter::TYPE_NUMBER);
    one.set_number(present);
    one.set_initial_number(present);
    one.set_min(low);
    one.set_max(high);
    if (named.unit != "0..1") one.set_unit(std::string(named.unit));
    one.set_description(sentence(named.meaning));
  }
  return all;
}

nao::walk::Parameters values_in(const net::Parameters& table) {
  nao::walk::Parameters values;
  for (const NamedParameter& named : kNamedParameters)
    values.*named.place = table.number(std::string(kPrefix).append(named.name));
  return values;
}

}  // namespace

Result<void> add_walk_parameters(net::Parameters& table, const nao::walk::Parameters& settings,
                                 const std::string& robot, memory::Channels& channels, const Clock& clock,
                                 std::function<void(const nao::walk::Parameters&)> change) {
  const auto channel = std::make_shared<memory::RawChannel>(
      memory::ChannelInfo{.topic = "/" + robot + "/live_parameters/walk",
                          .schema = memory::schema_of(*LiveParameters::descriptor())},
      clock);
  if (Result<void> added = channels.add(channel); !added) return added;
  if (Result<void> written = channel->write_bytes(announcement(settings).SerializeAsString(), clock.now_ns()); !written)
    return written;
  table.listen([&table, change = std::move(change)](const std::vector<std::string>& names) {
    if (std::ranges::any_of(names, [](const std::string& name) { return name.starts_with(kPrefix); }))
      change(values_in(table));
  });
  return {};
}

}  // namespace robot::app
