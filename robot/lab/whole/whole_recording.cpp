#include "robot/lab/whole/whole_recording.h"

#include <algorithm>
#include <utility>

#include "robot/lab/whole/message_reader.h"

namespace robot::lab {
namespace {

/// The fields of one topic, decoded together.
struct Decoded {
  std::string topic;
  std::unique_ptr<MessageReader> reader;
  std::vector<std::pair<FieldPath, std::size_t>> fields;  // with the index of the summary
};

Result<std::unique_ptr<MessageReader>> reader_of(const body::Replay& replay, const std::string& topic) {
  const auto stream = replay.stream_of(topic);
  if (!stream) return Error{"topic '" + topic + "' is not played"};
  const auto info = stream->open();
  if (!info) return info.failure();
  return MessageReader::open(*info);
}

/// Returns the topics of `fields` with their decoders. The summaries of fields that cannot be read get a problem.
std::vector<Decoded> decoders_of(const body::Replay& replay, const std::vector<WholeField>& fields,
                                 std::vector<WholeRecording::Summary>& summaries) {
  std::vector<Decoded> topics;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    auto path = parse_field_path(fields[i].path);
    if (!path) {
      summaries[i].problem = path.error();
      continue;
    }
    auto topic = std::ranges::find(topics, fields[i].topic, &Decoded::topic);
    if (topic == topics.end()) {
      auto reader = reader_of(replay, fields[i].topic);
      if (!reader) {
        summaries[i].problem = reader.error();
        continue;
      }
      topics.push_back({.topic = fields[i].topic, .reader = std::move(*reader), .fields = {}});
      topic = topics.end() - 1;
    }
    topic->fields.emplace_back(std::move(*path), i);
  }
  return topics;
}

}  // namespace

Result<WholeField> WholeRecording::field(const std::string& text) const {
  WholeField field{.text = text, .topic = "", .path = ""};
  for (const std::string& topic : replay_.topics())
    if (topic.size() > field.topic.size() && text.starts_with(topic + ".")) field.topic = topic;
  if (field.topic.empty())
    return Error{"expected a field of a topic that is played, got '" + text.substr(0, 200) + "'"};
  field.path = text.substr(field.topic.size() + 1);
  if (auto path = parse_field_path(field.path); !path) return path.failure();
  return field;
}

std::optional<std::vector<WholeRecording::Summary>> WholeRecording::read(const std::vector<WholeField>& fields,
                                                                         const Grid& empty, std::uint64_t to_ns,
                                                                         const std::function<bool()>& cancelled) const {
  std::vector<Summary> summaries(fields.size());
  for (Summary& summary : summaries) summary.grid = empty;
  const std::vector<Decoded> decoded = decoders_of(replay_, fields, summaries);
  std::vector<std::string> topics;
  for (const Decoded& one : decoded) topics.push_back(one.topic);
  int read = 0;
  bool ended = false;
  const std::uint64_t damages = replay_.read(topics, empty.from_ns(), to_ns, [&](const body::Replay::Message& message) {
    if (++read % kCheckedEvery == 0 && cancelled()) ended = true;
    const Decoded& topic = decoded[message.topic];
    if (topic.reader->read(message.bytes))
      for (const auto& [path, summary] : topic.fields)
        summaries[summary].grid->add(message.capture_ns, topic.reader->number(path));
    return !ended;
  });
  if (ended) return std::nullopt;
  for (Summary& summary : summaries) summary.damages = damages;
  return summaries;
}

std::optional<std::vector<WholeRecording::Summary>> WholeRecording::summaries(const std::vector<WholeField>& fields,
                                                                              std::uint64_t from_ns,
                                                                              std::uint64_t to_ns, std::size_t most,
                                                                              const std::function<bool()>& cancelled) {
  from_ns = std::clamp(from_ns, start_ns(), end_ns());
  to_ns = std::clamp(to_ns, from_ns, end_ns());
  if (step_of(from_ns, to_ns, most) < step_of(start_ns(), end_ns(), kKept))
    return read(fields, Grid(from_ns, to_ns, most), to_ns, cancelled);

  // kept summaries, and one reading for those that are missing
  std::vector<std::shared_ptr<const Summary>> whole;
  std::vector<WholeField> missing;
  for (const WholeField& field : fields) {
    whole.push_back(kept(field.text));
    if (!whole.back()) missing.push_back(field);
  }
  if (!missing.empty()) {
    auto made = read(missing, Grid(start_ns(), end_ns(), kKept), end_ns(), cancelled);
    if (!made) return std::nullopt;
    auto next = made->begin();
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (!whole[i]) keep(fields[i].text, whole[i] = std::make_shared<const Summary>(std::move(*next++)));
  }
  std::vector<Summary> answers;
  for (const auto& one : whole)
    answers.push_back(
        {.grid = one->grid->part(from_ns, to_ns, most), .problem = one->problem, .damages = one->damages});
  return answers;
}

std::shared_ptr<const WholeRecording::Summary> WholeRecording::kept(const std::string& text) {
  const std::lock_guard guard(lock_);
  const auto found = std::ranges::find(kept_, text, &Kept::text);
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().summary;
}

void WholeRecording::keep(const std::string& text, std::shared_ptr<const Summary> summary) {
  const std::lock_guard guard(lock_);
  kept_.push_front({.text = text, .summary = std::move(summary)});
  if (kept_.size() > kMostKept) kept_.pop_back();
}

Result<Runs> WholeRecording::runs(const std::string& topic, const std::vector<std::string>& paths,
                                  const std::function<bool()>& cancelled) const {
  std::vector<FieldPath> fields;
  for (const std::string& text : paths) {
    auto path = parse_field_path(text);
    if (!path) return path.failure();
    fields.push_back(std::move(*path));
  }
  const auto reader = reader_of(replay_, topic);
  if (!reader) return reader.failure();
  Runs runs;
  int read = 0;
  bool ended = false;
  std::vector<std::string> words(fields.size());
  replay_.read({topic}, start_ns(), end_ns(), [&](const body::Replay::Message& message) {
    if (++read % kCheckedEvery == 0 && cancelled()) ended = true;
    if (!(*reader)->read(message.bytes)) return !ended;
    for (std::size_t i = 0; i < fields.size(); ++i) words[i] = (*reader)->word(fields[i]);
    runs.add(message.capture_ns, words);
    return !ended && !runs.full();
  });
  if (ended) return Error{"the reading of " + topic + " was cancelled"};
  return runs;
}

std::shared_ptr<const RecordedEvents> WholeRecording::events(const std::function<bool()>& cancelled) {
  {
    const std::lock_guard guard(lock_);
    if (events_) return events_;
  }
  auto events = events_of(replay_, cancelled);
  if (!events) return nullptr;
  const std::lock_guard guard(lock_);
  return events_ = std::make_shared<const RecordedEvents>(std::move(*events));
}

}  // namespace robot::lab
