#include "robot/app/truth/calibration_service.h"

#include <string>
#include <utility>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/truth/calibration/calibration_json.h"

namespace robot::app {
namespace {

using nlohmann::json;
using Watches = std::vector<std::unique_ptr<SensorWatch>>;

/// Returns the watch of the sensor that a request names, or an Error.
Result<SensorWatch*> watch_of(const json& request, const Watches& watches) {
  const auto named = request.find("sensor");
  const auto number = named == request.end() ? std::nullopt : whole_number(*named);
  if (number && *number >= 1 && *number <= static_cast<std::int64_t>(watches.size()))
    return watches[static_cast<std::size_t>(*number - 1)].get();
  return Error{"'sensor' must be a whole number from 1 to " + std::to_string(watches.size())};
}

Result<json> landmarks_answer(const json& request, const std::vector<truth::Landmark>& landmarks,
                              const Watches& watches, const Calibrations& calibrations) {
  const auto watch = watch_of(request, watches);
  if (!watch) return watch.failure();
  std::vector<truth::Click> clicks;
  if (const auto frame = (*watch)->newest()) {
    const auto saved = calibrations.find((*watch)->address(), frame->intrinsics);
    if (saved && *saved)
      for (const truth::ClickResidual& one : (*saved)->clicks) clicks.push_back(one.click);
  }
  json answer = truth::to_json(clicks);
  answer["landmarks"] = truth::to_json(landmarks);
  answer["file"] = calibrations.path().filename().string();
  return answer;
}

Result<json> calibrate_answer(const json& request, const CalibratedField& on, const Watches& watches,
                              Calibrations& calibrations) {
  const auto watch = watch_of(request, watches);
  if (!watch) return watch.failure();
  const auto clicks = truth::clicks_of(request);
  if (!clicks) return clicks.failure();
  const auto wish = request.find("save");
  if (wish != request.end() && !wish->is_boolean()) return Error{"'save' must be true or false"};
  const auto frame = (*watch)->newest();
  if (!frame) return Error{(*watch)->address() + " has not sent an image yet"};

  const Result<truth::Calibration> calibration = calibrate_by(*clicks, *frame, on);
  json answer = truth::to_json(calibration);
  answer["saved"] = "";
  if (wish == request.end() || !wish->get<bool>() || !calibration || !calibration->refused.empty()) return answer;
  if (const auto saved = calibrations.save((*watch)->address(), frame->intrinsics, *calibration); !saved)
    return saved.failure();
  (*watch)->place(placed_by(*calibration));
  answer["saved"] = calibrations.path().filename().string();
  return answer;
}

Result<json> background_answer(const json& request, const Watches& watches) {
  const auto watch = watch_of(request, watches);
  if (!watch) return watch.failure();
  const auto images = (*watch)->learn_background();
  if (!images) return images.failure();
  return json{{"images", *images}};
}

/// Returns the answer of a service with that name.
json worded(const char* name, Result<json> answer) {
  if (!answer) return net::failure(std::string(name) + ": " + answer.error());
  (*answer)["ok"] = true;
  return std::move(*answer);
}

}  // namespace

void add_calibration_services(net::Services& services, const CalibratedField& on, const Watches& watches,
                              Calibrations& calibrations) {
  const auto landmarks = std::make_shared<const std::vector<truth::Landmark>>(truth::landmarks_of(on.field));
  constexpr const char *kLandmarks = "/truth/landmarks", *kCalibrate = "/truth/calibrate",
                       *kBackground = "/truth/background";
  services.add(kLandmarks, net::Services::For::questions,
               [&watches, &calibrations, landmarks](const json& request, const net::ClientContext&) {
                 return worded(kLandmarks, landmarks_answer(request, *landmarks, watches, calibrations));
               });
  services.add(kCalibrate, net::Services::For::questions,
               [&watches, &calibrations, on](const json& request, const net::ClientContext&) {
                 return worded(kCalibrate, calibrate_answer(request, on, watches, calibrations));
               });
  services.add(kBackground, net::Services::For::questions, [&watches](const json& request, const net::ClientContext&) {
    return worded(kBackground, background_answer(request, watches));
  });
}

}  // namespace robot::app
