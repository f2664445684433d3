#include "sim/contest/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "robot/core/files.h"
#include "robot/core/folder.h"
#include "robot/core/json_library.h"
#include "sim/match/hash.h"

namespace sim::contest {
namespace {

using Json = nlohmann::ordered_json;
using robot::Error;

constexpr std::size_t kMaxBytes = 1 << 20;

Json to_json(const compare::Pair& pair) {
  Json json = Json::array();
  for (const compare::GameResult& game : pair.games)
    json.push_back({game.gain, game.goals[0], game.goals[1], game.conceded[0], game.conceded[1]});
  json.push_back(pair.same);
  json.push_back(pair.hash);
  return json;
}

compare::Pair pair_of(const Json& json) {
  compare::Pair pair;
  for (const std::size_t place : {std::size_t{0}, std::size_t{1}}) {
    const auto numbers = json.at(place).get<std::vector<int>>();
    pair.games[place] = {
        .gain = numbers.at(0), .goals = {numbers.at(1), numbers.at(2)}, .conceded = {numbers.at(3), numbers.at(4)}};
  }
  pair.same = json.at(2).get<bool>();
  pair.hash = json.at(3).get<std::uint64_t>();
  return pair;
}

/// Returns the format that a specification names, or 1, the format without a name.
int format_of(const std::string& specification) {
  const Json json = Json::parse(specification, nullptr, false);
  if (!json.is_object() || !json.contains("format") || !json["format"].is_number_integer()) return 1;
  return json["format"].get<int>();
}

}  // namespace

robot::Result<RunFolder> RunFolder::open(const std::filesystem::path& folder, const std::string& specification,
                                         Use use) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"run " + folder.string() + ": " + failed.message()};
  const std::filesystem::path file = folder / "run.json";
  RunFolder run(folder, hex(hash_of_text(specification)));
  if (auto locked = run.lock(use); !locked) return locked.failure();
  if (!std::filesystem::exists(file, failed)) {
    if (auto written = robot::replace_file(file, specification + "\n"); !written) return written.failure();
    return run;
  }
  const auto there = robot::read_file(file, kMaxBytes);
  if (!there) return there.failure();
  if (const int written = format_of(*there), expected = format_of(specification); written != expected)
    return Error{"run " + folder.string() + ": expected format " + std::to_string(expected) + ", got format " +
                 std::to_string(written) + " of another version of this program; choose another --out"};
  if (*there != specification + "\n")
    return Error{"run " + folder.string() +
                 ": expected nothing or the same comparison on the same build, got another one; choose another --out"};
  if (use == Use::begin) return Error{"run " + folder.string() + ": it exists already; --resume continues it"};
  return run;
}

/// Locks the folder until this object is destroyed or its process ends.
robot::Result<void> RunFolder::lock(Use use) {
  const std::filesystem::path path = folder_ / "lock";
  lock_ = robot::FileDescriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!lock_) return robot::file_error("cannot write", path, errno);
  if (flock(lock_.get(), (use == Use::share ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0) return {};
  if (errno != EWOULDBLOCK) return robot::file_error("cannot lock", path, errno);
  return Error{"run " + folder_.string() + ": another process is working on it"};
}

std::filesystem::path RunFolder::path_of(std::int64_t block) const {
  char name[40];
  std::snprintf(name, sizeof name, "block-%08lld.json", static_cast<long long>(block));
  return folder_ / name;
}

robot::Result<std::vector<compare::Pair>> RunFolder::read(std::int64_t block) const {
  const std::filesystem::path path = path_of(block);
  const auto text = robot::read_file(path, kMaxBytes);
  if (!text) return text.failure();
  const auto refused = [&](const char* why) { return Error{"block " + path.string() + ": " + why}; };
  try {
    const Json json = Json::parse(*text);
    if (json.at("run") != run_) return refused("belongs to another run, or to another build of it");
    if (json.at("block") != block) return refused("is another block than its name says");
    if (json.at("hash") != hex(hash_of_text(json.at("pairs").dump()))) return refused("its pairs do not have its hash");
    std::vector<compare::Pair> pairs;
    for (const Json& pair : json.at("pairs")) pairs.push_back(pair_of(pair));
    if (pairs.size() != kPairsPerBlock) return refused("holds another number of pairs than a block has");
    return pairs;
  } catch (const Json::exception&) {
    return refused("is damaged");
  } catch (const std::out_of_range&) {
    return refused("is damaged");
  }
}

bool RunFolder::has(std::int64_t block) const {
  std::error_code failed;
  return std::filesystem::exists(path_of(block), failed);
}

std::int64_t RunFolder::blocks() const {
  std::int64_t count = 0;
  const auto files = robot::list_folder(folder_);
  if (!files) return 0;
  for (const robot::FolderEntry& file : *files) {
    long long block = 0;
    int used = 0;
    const std::string& name = file.name;
    if (std::sscanf(name.c_str(), "block-%lld.json%n", &block, &used) == 1 && used == static_cast<int>(name.size()))
      count = std::max<std::int64_t>(count, block + 1);
  }
  return count;
}

robot::Result<void> RunFolder::write_result(const std::string& json) const {
  return robot::replace_file(folder_ / "result.json", json);
}

robot::Result<void> RunFolder::write(std::int64_t block, const std::vector<compare::Pair>& pairs) const {
  Json list = Json::array();
  for (const compare::Pair& pair : pairs) list.push_back(to_json(pair));
  const Json json = {{"run", run_}, {"block", block}, {"hash", hex(hash_of_text(list.dump()))}, {"pairs", list}};
  return robot::replace_file(path_of(block), json.dump() + "\n");
}

}  // namespace sim::contest
