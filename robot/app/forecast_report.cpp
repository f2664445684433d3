#include "robot/app/forecast_report.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "proto/foresight/game.pb.h"
#include "robot/foresight/knowledge.h"
#include "robot/foresight/scorer.h"
#include "robot/logging/file_provider.h"

namespace robot::app {
namespace {

/// All messages of `topic`, by their capture times.
template <class Message>
std::vector<foreseeing::Remembered<Message>> read_all(const logging::Session& session, const std::string& topic) {
  std::vector<foreseeing::Remembered<Message>> all;
  const auto file = std::ranges::find(session.streams, topic, &logging::StreamFile::topic);
  if (file == session.streams.end()) return all;
  const auto stream = logging::provider_of(session, *file);
  if (!stream->open()) return all;
  while (true) {
    const Result<std::optional<logging::Record>> record = stream->read();
    if (!record) continue;  // a damage is told by the table of streams
    if (!*record) break;
    foreseeing::Remembered<Message> message{.value = {}, .capture_ns = (*record)->capture_ns};
    if (message.value.ParseFromString((*record)->bytes)) all.push_back(std::move(message));
  }
  std::ranges::stable_sort(all, {}, &foreseeing::Remembered<Message>::capture_ns);
  return all;
}

}  // namespace

std::map<std::string, foresight::ForecastScore> score_forecasts(const logging::Session& session) {
  constexpr std::string_view kForecast = "/forecast";
  std::map<std::string, foresight::ForecastScore> scores;
  for (const logging::StreamFile& file : session.streams) {
    if (!file.topic.ends_with(kForecast)) continue;
    const std::string robot = file.topic.substr(1, file.topic.size() - 1 - kForecast.size());
    const auto forecasts = read_all<foresight::Forecast>(session, file.topic);
    const auto games = read_all<foresight::GameState>(session, "/" + robot + "/game");
    if (forecasts.empty() || games.empty()) continue;
    foreseeing::Scorer scorer;
    auto next = forecasts.begin();
    for (const auto& game : games) {
      for (; next != forecasts.end() && next->capture_ns < game.capture_ns; ++next)
        scorer.foretell(next->value, next->capture_ns);
      scorer.see(game.value, game.capture_ns);
    }
    scores[robot] = scorer.score();
  }
  return scores;
}

}  // namespace robot::app
