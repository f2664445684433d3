#include "robot/app/services/recording_service.h"

#include <algorithm>
#include <string_view>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/source.h"

namespace robot::app {
namespace {

using net::ClientContext;
using net::ParameterValue;
using nlohmann::json;

std::string text_of(const json& request, const char* key, const std::string& otherwise) {
  const auto found = request.find(key);
  return found != request.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

constexpr const char* kObjects = "recording_objects";

/// Returns the names in "ball, pose".
std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (const std::string_view name : split(text, ","))
    if (!trimmed(name).empty()) names.emplace_back(trimmed(name));
  return names;
}

Result<void> check_objects(const logging::Recorder& recorder, const std::vector<std::string>& only) {
  const std::vector<std::string> all = recorder.object_names();
  const std::vector<std::string_view> known(all.begin(), all.end());
  for (const std::string& name : only)
    if (std::ranges::find(known, name) == known.end())
      return sim::io::unknown_name("object", std::string_view(name).substr(0, 100), known);
  return {};
}

/// Returns the objects that `request` names in "only", a list or a text, else those of the parameter.
Result<std::vector<std::string>> objects_of(const json& request, const logging::Recorder& recorder,
                                            const net::Parameters& parameters) {
  const auto only = request.find("only");
  if (only == request.end()) return recorded_objects(parameters);
  std::vector<std::string> names;
  if (only->is_string())
    names = names_in(only->get<std::string>());
  else if (only->is_array() && std::ranges::all_of(*only, [](const json& name) { return name.is_string(); }))
    names = only->get<std::vector<std::string>>();
  else
    return Error{"'only' must be a list of names of objects, such as [\"ball\", \"pose\"]"};
  if (const Result<void> known = check_objects(recorder, names); !known) return known.failure();
  return names;
}

json session_or_failure(const Result<std::string>& session) {
  if (!session) return net::failure(session.error());
  return {{"ok", true}, {"session", *session}};
}

}  // namespace

std::vector<std::string> recorded_objects(const net::Parameters& parameters) {
  return names_in(parameters.text(kObjects));
}

void add_recording_service(logging::Recorder& recorder, logging::SessionStore& store, net::Parameters& parameters,
                           net::Services& services) {
  std::vector<std::string> profile_names;
  for (const logging::Profile& profile : logging::profiles()) profile_names.emplace_back(profile.name);
  parameters.declare("recording_profile", profile_names.front(), {.min = {}, .max = {}, .choices = profile_names});

  parameters.declare(kObjects, std::string(),
                     {.min = {}, .max = {}, .choices = {}, .apply = [&](const ParameterValue& value) {
                        return check_objects(recorder, names_in(std::get<std::string>(value)));
                      }});

  parameters.declare("recording", false,
                     {.min = {}, .max = {}, .choices = {}, .apply = [&](const ParameterValue& value) -> Result<void> {
                        const bool wanted = std::get<bool>(value);
                        if (wanted == parameters.flag("recording")) return {};
                        const Result<std::string> done =
                            wanted
                                ? recorder.start("", parameters.text("recording_profile"), recorded_objects(parameters))
                                : recorder.stop();
                        if (!done) return done.failure();
                        return {};
                      }});

  services.add("start_recording", net::Services::For::control, [&](const json& request, const ClientContext&) {
    const Result<std::vector<std::string>> only = objects_of(request, recorder, parameters);
    if (!only) return net::failure("start_recording: " + only.error());
    const Result<std::string> session = recorder.start(
        text_of(request, "name", ""), text_of(request, "profile", parameters.text("recording_profile")), *only);
    if (session) parameters.update("recording", true);
    return session_or_failure(session);
  });
  services.add("stop_recording", net::Services::For::control, [&](const json&, const ClientContext&) {
    const Result<std::string> session = recorder.stop();
    if (session) parameters.update("recording", false);
    return session_or_failure(session);
  });
  services.add("keep_session", net::Services::For::control, [&](const json& request, const ClientContext&) {
    const auto keep = request.find("keep");
    if (keep == request.end() || !keep->is_boolean())
      return net::failure("keep_session: expected {\"session\": …, \"keep\": true or false}");
    const Result<void> kept = store.keep(text_of(request, "session", ""), keep->get<bool>());
    return kept ? json{{"ok", true}} : net::failure(kept.error());
  });
}

}  // namespace robot::app
