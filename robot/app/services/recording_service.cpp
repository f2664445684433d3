#include "robot/app/services/recording_service.h"
#include "robot/core/json_library.h"

namespace robot::app {
namespace {

using net::ClientContext;
using net::ParameterValue;
using nlohmann::json;

std::string text_of(const json& request, const char* key, const std::string& otherwise) {
  const auto found = request.find(key);
  return found != request.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

json session_or_failure(const Result<std::string>& session) {
  if (!session) return net::failure(session.error());
  return {{"ok", true}, {"session", *session}};
}

}  // namespace

void add_recording_service(logging::Recorder& recorder, logging::SessionStore& store, net::Parameters& parameters,
                           net::Services& services) {
  std::vector<std::string> profile_names;
  for (const logging::Profile& profile : logging::profiles()) profile_names.emplace_back(profile.name);
  parameters.declare("recording_profile", profile_names.front(), {.min = {}, .max = {}, .choices = profile_names});

  parameters.declare("recording", false,
                     {.min = {}, .max = {}, .choices = {}, .apply = [&](const ParameterValue& value) -> Result<void> {
                        const bool wanted = std::get<bool>(value);
                        if (wanted == parameters.flag("recording")) return {};
                        const Result<std::string> done =
                            wanted ? recorder.start("", parameters.text("recording_profile")) : recorder.stop();
                        if (!done) return done.failure();
                        return {};
                      }});

  services.add("start_recording", net::Services::For::control, [&](const json& request, const ClientContext&) {
    const Result<std::string> session =
        recorder.start(text_of(request, "name", ""), text_of(request, "profile", parameters.text("recording_profile")));
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
