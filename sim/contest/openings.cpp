#include "sim/contest/openings.h"

#include <algorithm>
#include <filesystem>

#include "robot/core/folder.h"
#include "sim/io/situation.h"
#include "sim/io/source.h"
#include "sim/match/hash.h"
#include "sim/match/step.h"

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;

/// Returns the situation files in a folder, sorted by name, or `from` itself if it is no folder.
Result<std::vector<std::string>> names_below(const std::string& from) {
  std::error_code failed;
  if (!std::filesystem::is_directory(from, failed)) return std::vector<std::string>{from};
  const auto files = robot::list_folder(from);
  if (!files) return files.failure();
  std::vector<std::string> names;
  for (const robot::FolderEntry& file : *files)
    if (file.name.ends_with(".json")) names.push_back((std::filesystem::path(from) / file.name).string());
  if (names.empty())
    return Error{"folder '" + from + "': expected situations, files that end in .json, there are none"};
  return names;
}

}  // namespace

Result<Openings> Openings::read(const std::string& from, bool fuzz, const Params& params) {
  Openings openings;
  openings.fuzz_ = fuzz;
  if (from.empty()) return openings;
  const auto names = names_below(from);
  if (!names) return names.failure();
  for (const std::string& name : *names) {
    auto source = io::find_source("situations", "situation", name);
    if (!source) return source.failure();
    auto state = io::parse_situation(source->text, source->called, params);
    if (!state) return state.failure();
    // a description that was valid is valid when it is turned
    const State turned = io::parse_situation(source->text, source->called, params, nullptr, true).value();
    openings.descriptions_.push_back({std::move(source->text), std::move(source->called), *state, turned});
  }
  return openings;
}

State Openings::begin(const Params& params, std::uint64_t seed) const {
  referee::Events events;
  return begin(params, seed, events);
}

State Openings::begin(const Params& params, std::uint64_t seed, referee::Events& events) const {
  return begin(params, {.seed = seed, .moment = seed}, events);
}

State Openings::begin(const Params& params, const Start& start, referee::Events& events) const {
  events.count = 0;
  if (descriptions_.empty()) return sim::begin(params, {.seed = start.seed}, events);
  const Description& description = descriptions_[start.moment % descriptions_.size()];
  State state = start.turned ? description.turned : description.state;
  if (fuzz_) {
    // a description that was valid without fuzz is valid with it
    const RandomKey luck{state.world.key.seed + start.seed};
    state = io::parse_situation(description.text, description.called, params, &luck, start.turned).value();
  }
  state.world.key.seed += start.seed;
  return state;
}

std::uint64_t Openings::content() const {
  Hash hash;
  for (const Description& description : descriptions_)
    for (const char c : description.text) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

}  // namespace sim::contest
