#include "robot/logging/sessions/downloads.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/core/folder.h"

namespace robot::logging {
namespace {

std::string text(const std::optional<std::uint64_t>& time_ns) { return time_ns ? std::to_string(*time_ns) : "-"; }

}  // namespace

Result<std::shared_ptr<const Assembly>> Downloads::open(const Session& session,
                                                        const std::optional<std::string>& stream,
                                                        const AssemblyOptions& options, const Extend& extend) {
  std::string what = std::string(extend ? "extended " : "") + session.folder.string() + ' ' + text(options.from_ns) +
                     ' ' + text(options.to_ns) + ' ' + text(options.until_ns);
  std::vector<std::filesystem::path> files;
  for (const StreamFile& file : session.streams) {
    if (stream && file.file != *stream) continue;
    what += ' ' + file.file + ' ' + std::to_string(file.size_bytes);
    // a file without a complete head cannot be part of an assembly yet
    if (file.topic.empty()) continue;
    const std::filesystem::path path = session.folder / file.file;
    // links and pipes are not served
    if (is_plain_file(path)) files.push_back(path);
  }
  if (files.empty())
    return Error{"session " + session.id() + ": there is no stream" + (stream ? " '" + *stream + "'" : "")};
  if (auto known = kept(what)) return known;

  std::vector<std::shared_ptr<const ByteSource>> sources;
  for (const auto& file : files) {
    Result<std::shared_ptr<const FileSource>> source = FileSource::open(file, Links::refuse);
    if (!source) return source.failure();
    sources.push_back(std::move(*source));
  }
  Result<Assembly> assembled = assemble(sources, options);
  if (!assembled) return assembled.failure();
  auto assembly = std::make_shared<const Assembly>(std::move(*assembled));
  if (extend) {
    const auto more = extend(assembly);
    if (!more) return more.failure();
    sources.push_back(*more);
    assembled = assemble(std::move(sources), options);
    if (!assembled) return assembled.failure();
    assembly = std::make_shared<const Assembly>(std::move(*assembled));
  }
  const std::lock_guard guard(lock_);
  kept_.push_front({std::move(what), assembly});
  if (kept_.size() > kKept) kept_.pop_back();
  return assembly;
}

std::shared_ptr<const Assembly> Downloads::kept(const std::string& what) {
  const std::lock_guard guard(lock_);
  const auto found = std::ranges::find(kept_, what, &Kept::what);
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().assembly;
}

}  // namespace robot::logging
