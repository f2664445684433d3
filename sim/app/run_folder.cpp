#include "sim/app/run_folder.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <system_error>

#include "robot/core/files.h"
#include "sim/match/hash.h"

namespace sim::app {
namespace {

using Json = nlohmann::ordered_json;
using robot::Error;

constexpr std::size_t kMaxBytes = 1 << 20;

std::string hash_of_text(const std::string& text) {
  Hash hash;
  for (const char c : text) hash.add(static_cast<unsigned char>(c));
  return hex(hash.value());
}

Json to_json(const compare::Pair& pair) {
  Json json = Json::array();
  for (const compare::Game& game : pair.games)
    json.push_back({game.gain, game.goals[0], game.goals[1], game.conceded[0], game.conceded[1]});
  return json;
}

compare::Pair pair_of(const Json& json) {
  compare::Pair pair;
  for (const std::size_t place : {std::size_t{0}, std::size_t{1}}) {
    const auto numbers = json.at(place).get<std::vector<int>>();
    pair.games[place] = {
        .gain = numbers.at(0), .goals = {numbers.at(1), numbers.at(2)}, .conceded = {numbers.at(3), numbers.at(4)}};
  }
  return pair;
}

}  // namespace

robot::Result<RunFolder> RunFolder::open(const std::filesystem::path& folder, const std::string& specification,
                                         bool resume) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"run " + folder.string() + ": " + failed.message()};
  const std::filesystem::path file = folder / "run.json";
  const RunFolder run(folder, hash_of_text(specification));
  if (!std::filesystem::exists(file, failed)) {
    if (auto written = robot::replace_file(file, specification + "\n"); !written) return Error{written.error()};
    return run;
  }
  const auto there = robot::read_file(file, kMaxBytes);
  if (!there) return Error{there.error()};
  if (*there != specification + "\n")
    return Error{"run " + folder.string() +
                 ": expected nothing or the same comparison on the same build, got another one; choose another --out"};
  if (!resume) return Error{"run " + folder.string() + ": it is there already; --resume goes on with it"};
  return run;
}

std::filesystem::path RunFolder::path_of(std::int64_t block) const {
  char name[40];
  std::snprintf(name, sizeof name, "block-%08lld.json", static_cast<long long>(block));
  return folder_ / name;
}

std::optional<std::vector<compare::Pair>> RunFolder::read(std::int64_t block) const {
  const auto text = robot::read_file(path_of(block), kMaxBytes);
  if (!text) return {};
  try {
    const Json json = Json::parse(*text);
    if (json.at("run") != run_ || json.at("block") != block || json.at("hash") != hash_of_text(json.at("pairs").dump()))
      return {};
    std::vector<compare::Pair> pairs;
    for (const Json& pair : json.at("pairs")) pairs.push_back(pair_of(pair));
    if (pairs.size() != kPairsPerBlock) return {};
    return pairs;
  } catch (const Json::exception&) {
    return {};
  } catch (const std::out_of_range&) {
    return {};
  }
}

robot::Result<void> RunFolder::write(std::int64_t block, const std::vector<compare::Pair>& pairs) const {
  Json list = Json::array();
  for (const compare::Pair& pair : pairs) list.push_back(to_json(pair));
  const Json json = {{"run", run_}, {"block", block}, {"hash", hash_of_text(list.dump())}, {"pairs", list}};
  return robot::replace_file(path_of(block), json.dump() + "\n");
}

}  // namespace sim::app
