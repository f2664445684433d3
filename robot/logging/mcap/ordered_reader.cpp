#include "robot/logging/mcap/ordered_reader.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "robot/logging/mcap/piece.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kEver = std::numeric_limits<std::uint64_t>::max();

/// Returns the greatest number of pieces that overlap at one time.
std::size_t most_at_once(const std::vector<const ChunkInfo*>& pieces) {
  std::vector<std::uint64_t> starts, ends;
  for (const ChunkInfo* piece : pieces) {
    starts.push_back(piece->index.start_ns);
    ends.push_back(std::max(piece->index.start_ns, piece->index.end_ns));
  }
  std::ranges::sort(starts);
  std::ranges::sort(ends);
  std::size_t most = 1, ended = 0;
  for (std::size_t begun = 0; begun < starts.size(); ++begun) {
    while (ends[ended] < starts[begun]) ++ended;
    most = std::max(most, begun + 1 - ended);
  }
  return most;
}

McapMessage owned(const mcap::Message& message) {
  return {message.channel_id, {message.sequence, message.log_time, message.publish_time, std::string(message.data)}};
}

}  // namespace

OrderedReader::OrderedReader(std::shared_ptr<const McapFile> file, std::optional<std::set<std::uint16_t>> channels,
                             const std::atomic<bool>* cancelled, std::uint64_t open_bytes)
    : file_(std::move(file)), cancelled_(cancelled), open_bytes_(open_bytes) {
  if (channels) channels_ = std::move(*channels);
  if (!channels)
    for (const auto& [id, channel] : file_->index().channels) channels_.insert(id);
  list_pieces();
}

/// Returns whether a piece may have messages of a wanted channel for which `which` returns true.
template <class Which>
bool OrderedReader::has_any(const ChunkInfo& piece, Which&& which) const {
  if (piece.messages.empty() && piece.index.message_indexes.empty()) return std::ranges::any_of(channels_, which);
  const auto wanted = [&](const auto& of_channel) {
    return channels_.contains(of_channel.first) && which(of_channel.first);
  };
  return std::ranges::any_of(piece.messages, wanted) || std::ranges::any_of(piece.index.message_indexes, wanted);
}

void OrderedReader::list_pieces() {
  for (const auto* pieces : {&file_->index().chunks, &file_->index().runs})
    for (const ChunkInfo& piece : *pieces) {
      if (!has_any(piece, [](std::uint16_t) { return true; })) continue;
      pieces_.push_back(&piece);
      largest_bytes_ = std::max(largest_bytes_, std::min(piece.index.unpacked_bytes, mcap::kMaxRecordBytes));
    }
  std::ranges::stable_sort(pieces_, {}, [](const ChunkInfo* piece) { return piece->index.start_ns; });
  most_open_ = most_at_once(pieces_);
}

OrderedReader::Place OrderedReader::place_of(std::size_t piece, const Entry& entry) const {
  return {entry.time_ns, pieces_[piece]->index.offset, entry.offset};
}

mcap::Message OrderedReader::message_at(const Open& open, const Entry& entry) {
  std::size_t at = entry.at;
  const auto record = mcap::take_record(open.records, at);
  // load() has decoded the same bytes
  return *mcap::decode<mcap::Message>(record->content, record->offset);
}

void OrderedReader::note(std::size_t piece, const std::string& sentence) {
  if (!damaged_.insert(piece).second) return;
  damages_.insert(damages_.begin(), file_->source().name() + ": " + sentence);
}

/// Reads the wanted messages of a piece from `from` on. Returns nothing, and notes it, if the piece is damaged.
std::optional<OrderedReader::Open> OrderedReader::load(std::size_t piece, const Place& from) {
  Result<std::string> records = read_records(file_->source(), *pieces_[piece]);
  if (!records) {
    note(piece, records.error());
    return {};
  }
  Open open{.piece = piece, .records = std::move(*records), .entries = {}};
  const mcap::ChunkContents contents = mcap::survey_records(open.records, logging::place_of(*pieces_[piece]));
  if (!contents.damage.empty()) note(piece, contents.damage);
  for (const auto& [channel, index] : contents.indexes) {
    if (!channels_.contains(channel)) continue;
    for (const auto& [time_ns, offset] : index.entries) {
      const Entry entry{time_ns, static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(offset)};
      if (!(place_of(piece, entry) < from)) open.entries.push_back(entry);
    }
  }
  std::ranges::sort(open.entries, {}, [](const Entry& entry) { return std::tuple(entry.time_ns, entry.offset); });
  return open;
}

/// Opens the rest of a piece from `from` on. If it does not fit, only the part that comes next.
void OrderedReader::open(std::size_t piece, const Place& from) {
  std::optional<Open> open = load(piece, from);
  if (!open || open->entries.empty()) return;
  if (!opened_.empty() && held_bytes_ + open->size_bytes() > open_bytes_ + largest_bytes_) cut(*open);
  held_bytes_ += open->size_bytes();
  const Place first = place_of(piece, open->entries.front());
  opened_.emplace(first, std::move(*open));
}

/// Keeps only the messages that come next, up to a share of the memory, but at least one.
void OrderedReader::cut(Open& open) const {
  const std::uint64_t share = (open_bytes_ + largest_bytes_) / most_open_;
  std::string kept;
  std::size_t count = 0;
  for (Entry& entry : open.entries) {
    std::size_t end = entry.at;
    const auto record = mcap::take_record(open.records, end);
    if (count > 0 && kept.size() + record->content.size() > share) break;
    const std::string_view bytes = std::string_view(open.records).substr(entry.at, end - entry.at);
    entry.at = static_cast<std::uint32_t>(kept.size());
    kept += bytes;
    ++count;
  }
  open.has_more = count < open.entries.size();
  open.entries.resize(count);
  open.entries.shrink_to_fit();
  open.records = std::move(kept);
}

/// Opens the pieces that may hold the next message.
void OrderedReader::open_due() {
  while (next_piece_ < pieces_.size() && !ended()) {
    const ChunkInfo& piece = *pieces_[next_piece_];
    if (!opened_.empty() && piece.index.start_ns > opened_.begin()->first.time_ns) return;
    if (piece.index.end_ns >= from_.time_ns) open(next_piece_, from_);
    ++next_piece_;
  }
}

/// Takes the first of the opened messages.
McapMessage OrderedReader::take_first() {
  auto node = opened_.extract(opened_.begin());
  Open& open = node.mapped();
  McapMessage message = owned(message_at(open, open.entries[open.next]));
  if (++open.next < open.entries.size()) {
    node.key() = place_of(open.piece, open.entries[open.next]);
    opened_.insert(std::move(node));
    return message;
  }
  held_bytes_ -= open.size_bytes();
  Place rest = place_of(open.piece, open.entries.back());
  ++rest.offset;
  if (open.has_more) this->open(open.piece, rest);
  return message;
}

Result<std::optional<McapMessage>> OrderedReader::next() {
  if (ended()) return std::optional<McapMessage>();
  open_due();
  if (!damages_.empty()) {
    Error error{std::move(damages_.back())};
    damages_.pop_back();
    return error;
  }
  if (opened_.empty() || ended()) return std::optional<McapMessage>();
  return std::optional<McapMessage>(take_first());
}

void OrderedReader::seek(std::uint64_t capture_ns) {
  opened_.clear();
  held_bytes_ = 0;
  next_piece_ = 0;
  from_ = {.time_ns = capture_ns};
}

std::vector<McapMessage> OrderedReader::move_to(std::uint64_t capture_ns) {
  std::vector<McapMessage> newest = newest_until(capture_ns);
  seek(capture_ns);
  from_.piece_offset = from_.offset = kEver;  // after all messages of that time
  return newest;
}

/// The newest message of each channel up to now, while chunks are searched.
struct OrderedReader::Newest {
  std::map<std::uint16_t, Place> places;  // by channel
  std::map<Place, McapMessage> messages;

  bool wants(std::uint16_t channel, const Place& place) const {
    const auto known = places.find(channel);
    return known == places.end() || known->second < place;
  }

  void see(const Place& place, const mcap::Message& message) {
    if (!wants(message.channel_id, place)) return;
    if (const auto known = places.find(message.channel_id); known != places.end()) messages.erase(known->second);
    places[message.channel_id] = place;
    messages.emplace(place, owned(message));
  }
};

std::vector<McapMessage> OrderedReader::newest_until(std::uint64_t capture_ns) {
  // the last place that a piece may have a message at; the pieces with the latest first
  std::vector<std::pair<Place, std::size_t>> candidates;
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const mcap::ChunkIndex& place = pieces_[piece]->index;
    if (place.start_ns <= capture_ns)
      candidates.push_back({{std::min(place.end_ns, capture_ns), place.offset, kEver}, piece});
  }
  std::ranges::sort(candidates, std::greater());

  Newest newest;
  for (const auto& candidate : candidates) {
    if (ended()) return {};
    const Place& last = candidate.first;
    const std::size_t piece = candidate.second;
    if (!has_any(*pieces_[piece], [&](std::uint16_t channel) { return newest.wants(channel, last); })) continue;
    const std::optional<Open> open = load(piece, {});
    if (!open) continue;
    // from the end: the first message of each channel is its newest
    std::set<std::uint16_t> seen;
    for (std::size_t i = open->entries.size(); i-- > 0 && seen.size() < channels_.size();) {
      const Entry& entry = open->entries[i];
      if (entry.time_ns > capture_ns) continue;
      const mcap::Message message = message_at(*open, entry);
      if (seen.insert(message.channel_id).second) newest.see(place_of(piece, entry), message);
    }
  }
  std::vector<McapMessage> messages;
  for (auto& [place, message] : newest.messages) messages.push_back(std::move(message));
  return messages;
}

}  // namespace robot::logging
