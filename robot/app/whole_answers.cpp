#include "robot/app/whole_answers.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "robot/core/json_library.h"

namespace robot::app {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMostIntervals = 4096, kUsualIntervals = 800;
constexpr std::size_t kMostFields = 16;  // of one request: as many as a plot shows

net::HttpResponse answer(const std::string& text) { return net::text_response(200, "application/json", text); }
std::string text(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }
net::HttpResponse cancelled() { return net::error_response(503, "whole: the client has left"); }

/// Returns the whole number of a parameter, or `otherwise` if it is missing.
Result<std::uint64_t> number(const net::Target& target, const char* name, std::uint64_t otherwise) {
  const std::string given = target.parameter(name);
  if (given.empty()) return otherwise;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  if (error == std::errc() && end == given.data() + given.size()) return value;
  return Error{"whole: expected a whole number for '" + std::string(name) + "', got '" + given.substr(0, 40) + "'"};
}

/// Returns the fields of a request, which stand between spaces.
Result<std::vector<std::string>> fields_of(const net::Target& target, const char* example) {
  std::istringstream words(target.parameter("fields"));
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(word);
  if (!fields.empty() && fields.size() <= kMostFields) return fields;
  return Error{"whole: expected 1 to " + std::to_string(kMostFields) + " fields such as fields=" + example + ", got " +
               std::to_string(fields.size())};
}

/// Twelve digits suffice for a plot, and are shorter than those of a double.
void append(std::string& list, double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.12g", value);
  list += digits;
}

template <class Value>
std::string list_of(const lab::Grid& grid, Value&& value) {
  std::string list = "[";
  for (const lab::Interval& interval : grid.intervals()) {
    if (list.size() > 1) list += ',';
    if (interval.count == 0)
      list += "null";
    else
      append(list, value(interval));
  }
  return list + "]";
}

std::string described(const lab::WholeField& field, const lab::WholeRecording::Summary& summary) {
  const std::string head = "{\"field\":" + text(field.text);
  if (!summary.problem.empty()) return head + ",\"problem\":" + text(summary.problem) + "}";
  const auto list = [&](auto&& value) { return list_of(*summary.grid, value); };
  return head + ",\"least\":" + list([](const lab::Interval& of) { return of.least; }) +
         ",\"most\":" + list([](const lab::Interval& of) { return of.most; }) +
         ",\"mean\":" + list([](const lab::Interval& of) { return of.mean(); }) + "}";
}

net::HttpResponse numbers(lab::WholeRecording& recording, const net::Target& target, const net::ClientLeft& left) {
  const auto names = fields_of(target, "/14/2/ball.x");
  if (!names) return net::error_response(400, names.error());
  const auto from_ns = number(target, "from", recording.start_ns()), to_ns = number(target, "to", recording.end_ns()),
             intervals = number(target, "intervals", kUsualIntervals);
  for (const auto* value : {&from_ns, &to_ns, &intervals})
    if (!*value) return net::error_response(400, value->error());
  if (*from_ns > *to_ns)
    return net::error_response(
        400, "whole: expected 'from' before 'to', got " + std::to_string(*from_ns) + " and " + std::to_string(*to_ns));
  if (*intervals < 1 || *intervals > kMostIntervals)
    return net::error_response(400, "whole: expected 1 to " + std::to_string(kMostIntervals) + " intervals, got " +
                                        std::to_string(*intervals));
  std::vector<lab::WholeField> fields;
  for (const std::string& name : *names) {
    auto field = recording.field(name);
    if (!field) return net::error_response(400, "whole: " + field.error());
    fields.push_back(std::move(*field));
  }
  const auto summaries = recording.summaries(fields, *from_ns, *to_ns, *intervals, left);
  if (!summaries) return cancelled();
  const lab::Grid& grid = *summaries->front().grid;  // all are alike
  std::uint64_t damages = 0;
  std::string list;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    list += (i > 0 ? "," : "") + described(fields[i], (*summaries)[i]);
    damages = std::max(damages, (*summaries)[i].damages);
  }
  return answer("{\"from\":\"" + std::to_string(grid.from_ns()) + "\",\"step_ns\":" + std::to_string(grid.step_ns()) +
                ",\"damages\":" + std::to_string(damages) + ",\"fields\":[" + list + "]}");
}

net::HttpResponse runs(const lab::WholeRecording& recording, const net::Target& target, const net::ClientLeft& left) {
  const std::string topic = target.parameter("topic");
  if (topic.empty()) return net::error_response(400, "whole: expected a topic such as topic=/14/2/decision, got none");
  const auto fields = fields_of(target, "skill");
  if (!fields) return net::error_response(400, fields.error());
  const auto runs = recording.runs(topic, *fields, left);
  if (left()) return cancelled();
  if (!runs) return net::error_response(400, "whole: " + runs.error());
  const std::uint64_t from_ns = runs->runs().empty() ? recording.start_ns() : runs->runs().front().from_ns;
  json list = json::array();
  for (const lab::Run& run : runs->runs()) {
    json one = {run.from_ns - from_ns, run.to_ns - run.from_ns};
    for (const std::uint32_t word : run.words) one.push_back(word);
    list.push_back(std::move(one));
  }
  return answer(text({{"from", std::to_string(from_ns)},
                      {"words", runs->words()},
                      {"full", runs->full()},
                      {"runs", std::move(list)}}));
}

net::HttpResponse events(lab::WholeRecording& recording, const net::ClientLeft& left) {
  const auto events = recording.events(left);
  if (!events) return cancelled();
  json list = json::array();
  for (const auto& [at_ns, kind, text, robot] : events->events)
    list.push_back({{"at", std::to_string(at_ns)}, {"kind", kind}, {"text", text}, {"robot", robot}});
  return answer(text({{"events", std::move(list)}, {"full", events->full}, {"damages", events->damages}}));
}

}  // namespace

net::HttpResponse whole_answer(lab::WholeRecording& recording, const net::Target& target, const net::ClientLeft& left) {
  const std::string_view what = std::string_view(target.path).substr(net::kWhole.size());
  if (what == "events") return events(recording, left);
  if (what == "numbers") return numbers(recording, target, left);
  if (what == "runs") return runs(recording, target, left);
  return net::error_response(404,
                             "whole: expected events, numbers or runs, got '" + std::string(what.substr(0, 40)) + "'");
}

}  // namespace robot::app
