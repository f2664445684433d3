// foresight-lab fit: models of the simulator, fitted to recordings of a team's robots beside ground truth.
#include <cstdio>

#include "robot/app/fit/evidence_options.h"
#include "robot/app/fit/fits.h"
#include "robot/app/lab/commands.h"
#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace robot::app {
namespace {

namespace fs = std::filesystem;

constexpr int kDiffers = 1;  // exit status of --check

class FitCommand final : public Command {
 public:
  explicit FitCommand(CLI::App& app)
      : Command(app.add_subcommand("fit", "fit models to recordings of robots beside ground truth")) {
    recordings_.declare(options(), "folders of sessions, or .mcap files; with /truth/world or beside it");
    options().add_option("--only", only_, "fit these alone: " + joined(names_of_fits(), ", "));
    options()
        .add_option("--models", base_, "models that keep what is not fitted, or that are checked: a name or a file")
        ->capture_default_str();
    options().add_option("--out", out_, "file for the fitted models, for foresight-sim --models");
    options().add_option("--html", html_, "file for an HTML page");
    options().add_option("--csv", csv_, "folder for the observations behind each fit, as CSV");
    options().add_flag("--json", json_, "report as JSON");
    options().add_flag(
        "--check", check_,
        "fit nothing: simulate what was recorded with --models, and compare; exit status 1 if they differ");
  }

  int run() override {
    const auto evidence = recordings_.gather();
    if (!evidence) return fail(evidence.error());
    if (check_) return check_models(*evidence);
    const auto fits = fit_all(*evidence, only_, base_);
    if (!fits) return fail(fits.error());
    if (const auto written = write(*fits); !written) return fail(written.error());
    if (json_)
      std::printf("%s\n", to_json(*fits).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    else
      std::fputs(to_text(*fits).c_str(), stdout);
    return fits->empty() ? fail("fit: the recordings carry no model; nothing was written") : kDone;
  }

 private:
  int check_models(const fit::Evidence& evidence) const {
    if (!out_.empty() || !csv_.empty() || !only_.empty())
      return fail("--check goes with neither --out nor --csv nor --only");
    const auto report = check(evidence, base_);
    if (!report) return fail(report.error());
    if (!html_.empty())
      if (const auto written = replace_file(html_, page_of_check(*report, base_)); !written)
        return fail(written.error());
    nlohmann::ordered_json scores;
    for (const auto& [name, value] : report->scores) scores[name] = value;
    if (json_) {
      scores["results"] = nlohmann::ordered_json::array();
      for (const fit::Results& results : report->results)
        for (const auto& row : results.rows) scores["results"].push_back(row);
      scores["notes"] = report->notes, scores["left_out"] = evidence.left_out;
      std::printf("%s\n", scores.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    } else {
      std::fputs(to_text(*report).c_str(), stdout);
      for (const std::string& sentence : evidence.left_out) std::printf("left out  %s\n", sentence.c_str());
    }
    if (scores.value("statistics", 0.) == 0) return fail("fit --check: the recordings show no situation to simulate");
    return scores.value("outside", 0.) > 0 ? kDiffers : kDone;
  }

  /// Writes the files that were asked for. Without a fit there is nothing to write.
  Result<void> write(const Fits& fits) const {
    if (fits.empty()) return {};
    if (!out_.empty()) {
      const auto models = fitted_models(fits, base_, out_.stem().string());
      if (!models) return models.failure();
      if (Result<void> written = replace_file(out_, *models); !written) return written;
    }
    if (!html_.empty())
      if (Result<void> written = replace_file(html_, page_of(fits)); !written) return written;
    if (csv_.empty()) return {};
    std::error_code failed;
    fs::create_directories(csv_, failed);
    for (const auto& [name, table] : fits.tables())
      if (Result<void> written = replace_file(csv_ / (name + ".csv"), to_csv(table)); !written) return written;
    return {};
  }

  EvidenceOptions recordings_;
  std::vector<std::string> only_;
  std::string base_ = "match";
  fs::path out_, html_, csv_;
  bool json_ = false, check_ = false;
};

}  // namespace

std::unique_ptr<Command> fit_command(CLI::App& app) { return std::make_unique<FitCommand>(app); }

}  // namespace robot::app
