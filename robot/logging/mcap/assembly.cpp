#include "robot/logging/mcap/assembly.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "robot/logging/mcap/index.h"
#include "robot/logging/mcap/summary.h"

namespace robot::logging {

namespace {

/// A chosen chunk and its file.
struct Chosen {
  std::uint32_t file;
  ChunkInfo chunk;
};

/// The FNV-1a hash. It distinguishes contents, but gives no protection against forgery.
std::uint64_t hash(std::string_view bytes, std::uint64_t before = 0xcbf2'9ce4'8422'2325) {
  for (const char byte : bytes) before = (before ^ static_cast<std::uint8_t>(byte)) * 0x0000'0100'0000'01b3;
  return before;
}

bool is_chosen(const ChunkInfo& chunk, const AssemblyOptions& options) {
  const mcap::ChunkIndex& place = chunk.index;
  if (options.from_ns && place.end_ns < *options.from_ns) return false;
  if (options.to_ns && place.start_ns > *options.to_ns) return false;
  if (!options.until_ns) return true;
  // leave out a chunk whose index is still being written: it would look different a moment later
  return place.end_ns <= *options.until_ns && !place.message_indexes.empty();
}

/// Returns whether a chunk may hold messages of the wanted channel.
bool holds_topic(const ChunkInfo& chunk, const McapIndex& index, const AssemblyOptions& options) {
  if (!options.topic || chunk.index.message_indexes.empty()) return true;
  return std::ranges::any_of(chunk.index.message_indexes, [&](const auto& of_channel) {
    const auto channel = index.channels.find(of_channel.first);
    return channel != index.channels.end() && channel->second.topic == *options.topic;
  });
}

}  // namespace

/// The builder of an assembly, in four steps: files, head, chunks, end.
class AssemblyBuilder {
 public:
  explicit AssemblyBuilder(const AssemblyOptions& options) : options_(options) {}

  Result<void> add_file(std::shared_ptr<const ByteSource> source) {
    Result<McapIndex> index = read_index(*source);
    if (!index) return index.failure();
    if (index->unchunked_messages > 0)
      return Error{source->name() + ": cannot be assembled: expected all messages in chunks, got " +
                   std::to_string(index->unchunked_messages) + " outside"};
    // a missing end is no damage in a file that is still being written
    const bool live = options_.until_ns && !index->complete;
    if (!live && !index->damage.empty()) assembly_.damage_ += (assembly_.damage_.empty() ? "" : "; ") + index->damage;
    if (header_.library.empty()) header_.library = index->header.library;

    if (Result<void> added = add_channels(*index, source->name()); !added) return added;
    for (mcap::Metadata& metadata : index->metadata) metadata_.emplace(metadata.name, std::move(metadata));
    const auto file = static_cast<std::uint32_t>(assembly_.files_.size());
    for (ChunkInfo& chunk : index->chunks) {
      if (!is_chosen(chunk, options_) || !holds_topic(chunk, *index, options_)) continue;
      auto counts = count_messages(*source, chunk);
      if (!counts) return counts.failure(source->name());
      chunk.messages = std::move(*counts);
      chosen_.push_back({file, std::move(chunk)});
    }
    assembly_.files_.push_back(std::move(source));
    return {};
  }

  Result<Assembly> build() && {
    add_head();
    std::sort(chosen_.begin(), chosen_.end(), [](const Chosen& left, const Chosen& right) {
      return std::tie(left.chunk.index.start_ns, left.file, left.chunk.index.offset) <
             std::tie(right.chunk.index.start_ns, right.file, right.chunk.index.offset);
    });
    for (Chosen& chosen : chosen_)
      if (const Result<void> added = add_chunk(chosen); !added) return added.failure();
    add_end();
    return std::move(assembly_);
  }

 private:
  /// Enters channels under their own ids, because the chunks refer to them. Each schema gets a new id, once.
  Result<void> add_channels(McapIndex& index, const std::string& file) {
    for (auto& [id, channel] : index.channels) {
      if (const auto [other, is_new] = channel_files_.emplace(id, file); !is_new)
        return Error{other->second + " and " + file + ": cannot be assembled: both use channel id " +
                     std::to_string(id)};
      const auto schema = index.schemas.find(channel.schema_id);
      if (schema == index.schemas.end() && channel.schema_id != 0)
        return Error{file + ": the schema of channel " + channel.topic + " is missing"};
      if (schema != index.schemas.end()) channel.schema_id = schema_id(schema->second);
      mcap::append(groups_.channels, channel);
    }
    return {};
  }

  std::uint16_t schema_id(mcap::Schema schema) {
    // there are no more schemas than channels, so 16 bits suffice for the ids of both
    const auto next = static_cast<std::uint16_t>(schema_ids_.size() + 1);
    const auto [known, is_new] = schema_ids_.emplace(std::tuple(schema.name, schema.encoding, schema.data), next);
    schema.id = known->second;
    if (is_new) mcap::append(groups_.schemas, schema);
    return schema.id;
  }

  void add_head() {
    std::string head(mcap::kMagic);
    mcap::append(head, header_);
    for (const auto& [name, metadata] : metadata_) {
      const std::uint64_t offset = head.size();
      mcap::append(head, metadata);
      mcap::append(groups_.metadata_indexes, mcap::MetadataIndex{offset, head.size() - offset, name});
    }
    add_made(head + groups_.schemas + groups_.channels);
  }

  Result<void> add_chunk(Chosen& chosen) {
    mcap::ChunkIndex& place = chosen.chunk.index;
    std::vector<mcap::MessageIndex> made_indexes;
    if (place.message_indexes.empty()) {
      auto made = index_messages(*assembly_.files_[chosen.file], place);
      if (!made) return made.failure(assembly_.files_[chosen.file]->name());
      made_indexes = std::move(*made);
    }

    const std::uint64_t offset = assembly_.size_;
    add_extent(chosen.file, place.offset, place.record_bytes + place.message_index_bytes);
    for (auto& [channel, index_offset] : place.message_indexes) index_offset = index_offset - place.offset + offset;
    for (const mcap::MessageIndex& index : made_indexes) {
      std::string made;
      mcap::append(made, index);
      place.message_indexes.emplace_back(index.channel_id, assembly_.size_);
      place.message_index_bytes += made.size();
      add_made(made);
    }
    place.offset = offset;
    mcap::append(groups_.chunk_indexes, place);
    return {};
  }

  void add_end() {
    std::vector<ChunkInfo> chunks;
    chunks.reserve(chosen_.size());
    for (Chosen& chosen : chosen_) chunks.push_back(std::move(chosen.chunk));
    mcap::Statistics statistics = statistics_of(chunks);
    statistics.schemas = static_cast<std::uint16_t>(schema_ids_.size());
    statistics.channels = static_cast<std::uint32_t>(channel_files_.size());
    statistics.metadata = static_cast<std::uint32_t>(metadata_.size());
    mcap::append(groups_.statistics, statistics);
    // without a checksum of all data, because it would require reading all of them
    add_made(mcap::encode_end(groups_, assembly_.size_, /*data_crc=*/0));
    assembly_.statistics_ = std::move(statistics);
    assembly_.etag_ = etag();
  }

  /// Hashes head and end. They hold each chunk's times, place and sizes, the statistics, and the schemas and channels.
  std::string etag() const {
    std::uint64_t value = hash(assembly_.made_);
    for (const auto& file : assembly_.files_) value = hash("/", hash(file->name(), value));
    char text[40];
    std::snprintf(text, sizeof text, "%llx-%016llx", static_cast<unsigned long long>(assembly_.size_),
                  static_cast<unsigned long long>(value));
    return text;
  }

  void add_made(const std::string& bytes) {
    const std::uint64_t offset = assembly_.made_.size();
    assembly_.made_ += bytes;
    add_extent(Assembly::kMade, offset, bytes.size());
  }

  void add_extent(std::uint32_t file, std::uint64_t offset, std::uint64_t length) {
    assembly_.extents_.push_back({assembly_.size_, offset, file});
    assembly_.size_ += length;
  }

  AssemblyOptions options_;
  Assembly assembly_;
  mcap::Header header_;
  std::map<std::string, mcap::Metadata> metadata_;
  std::map<std::uint16_t, std::string> channel_files_;  // channel id → name of the file that uses it
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schema_ids_;
  std::vector<Chosen> chosen_;
  mcap::SummaryGroups groups_;
};

Result<Assembly> assemble(std::vector<std::shared_ptr<const ByteSource>> files, const AssemblyOptions& options) {
  AssemblyBuilder builder(options);
  for (auto& file : files)
    if (const Result<void> added = builder.add_file(std::move(file)); !added) return added.failure();
  return std::move(builder).build();
}

Result<void> Assembly::read(std::uint64_t offset, std::span<char> into) const {
  if (offset > size_ || into.size() > size_ - offset)
    return Error{name_ + ": expected " + std::to_string(into.size()) + " bytes at byte " + std::to_string(offset) +
                 ", it ends at byte " + std::to_string(size_)};
  const auto after = [](std::uint64_t at, const Extent& extent) { return at < extent.begin; };
  auto next = std::upper_bound(extents_.begin(), extents_.end(), offset, after);
  while (!into.empty()) {
    // the extent before `next` contains `offset`
    const Extent& extent = *std::prev(next);
    const std::uint64_t end = next == extents_.end() ? size_ : next->begin;
    const auto piece = into.first(static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), end - offset)));
    const std::uint64_t from = extent.offset + (offset - extent.begin);
    if (extent.file == kMade) {
      std::copy_n(made_.data() + from, piece.size(), piece.data());
    } else if (Result<void> done = files_[extent.file]->read(from, piece); !done) {
      return done;
    }
    into = into.subspan(piece.size());
    offset += piece.size();
    if (next != extents_.end()) ++next;
  }
  return {};
}

}  // namespace robot::logging
