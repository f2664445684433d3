#include "sim/contest/openings.h"

#include <algorithm>
#include <filesystem>

#include "sim/io/situation.h"
#include "sim/io/source.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;

/// Returns the descriptions below a folder, by name, or the name itself if it is not a folder.
Result<std::vector<std::string>> names_below(const std::string& from) {
  std::error_code failed;
  if (!std::filesystem::is_directory(from, failed)) return std::vector<std::string>{from};
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(from, failed))
    if (entry.path().extension() == ".json") names.push_back(entry.path().string());
  if (failed) return Error{"folder '" + from + "': " + failed.message()};
  if (names.empty())
    return Error{"folder '" + from + "': expected situations, files that end in .json, there are none"};
  std::ranges::sort(names);
  return names;
}

}  // namespace

Result<Openings> Openings::read(const std::string& from, bool fuzz, const Params& params) {
  Openings openings;
  openings.fuzz_ = fuzz;
  if (from.empty()) return openings;
  const auto names = names_below(from);
  if (!names) return Error{names.error()};
  for (const std::string& name : *names) {
    auto source = io::find_source("situations", "situation", name);
    if (!source) return Error{source.error()};
    auto state = io::parse_situation(source->text, source->called, params);
    if (!state) return Error{state.error()};
    openings.starts_.push_back({std::move(source->text), std::move(source->called), *state});
  }
  return openings;
}

State Openings::begin(const Params& params, std::uint64_t seed) const {
  referee::Events events;
  return begin(params, seed, events);
}

State Openings::begin(const Params& params, std::uint64_t seed, referee::Events& events) const {
  events.count = 0;
  if (starts_.empty()) return sim::begin(params, {.seed = seed}, events);
  const Start& moment = starts_[seed % starts_.size()];
  State state = moment.state;
  if (fuzz_) {
    // a description that could be read once can be read with fuzz
    const RandomKey luck{state.world.key.seed + seed};
    state = io::parse_situation(moment.text, moment.called, params, &luck).value();
  }
  state.world.key.seed += seed;
  return state;
}

std::uint64_t Openings::content() const {
  Hash hash;
  for (const Start& moment : starts_)
    for (const char c : moment.text) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

}  // namespace sim::contest
