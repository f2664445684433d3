// foresight-lab redecide: recorded beliefs through another tree.
#include <cstdio>

#include "robot/app/lab/commands.h"
#include "robot/app/redecide.h"
#include "robot/app/redecided_session.h"
#include "robot/core/files.h"

namespace robot::app {
namespace {

constexpr std::size_t kMostFile = 1'000'000;  // [bytes] of expectations
constexpr int kBroken = 1;                    // exit status

class RedecideCommand final : public Command {
 public:
  explicit RedecideCommand(CLI::App& app)
      : Command(app.add_subcommand("redecide", "what another tree would have decided from the recorded beliefs")) {
    options().add_option("session", session_, "folder of the session, or an .mcap file")->required();
    options().add_option("--strategy", redecide_.strategy, "the other tree, by name or file")->required();
    options().add_option("--robot", redecide_.robot, "<team>/<player>; default: the first with recorded decisions");
    options().add_option("--rules", redecide_.rules,
                         "rules of a year; default: those of the recorded simulation, else spl2025");
    options().add_option("--models", redecide_.models, "abilities of the own body")->capture_default_str();
    options().add_option("--csv", csv_, "file: both decisions of each moment");
    options().add_option("--session", copy_,
                         "folder: a copy of the session with the new decisions beside the recorded ones");
    options().add_option("--expect", expect_,
                         "file: lines like 'at 12.5 s: kick or dribble' and '12 .. 14 s: not search_ball'");
    options().footer("Exit status: 0, 1 when an expectation is broken, 2 bad usage or input.");
  }

  int run() override {
    std::vector<Expectation> expectations;
    if (!expect_.empty()) {
      const auto text = read_file(expect_, kMostFile);
      if (!text) return fail(text.error());
      auto parsed = parse_expectations(*text);
      if (!parsed) return fail(expect_ + ", " + parsed.error());
      expectations = *std::move(parsed);
    }
    const auto session = logging::open_session(session_);
    if (!session) return fail(session.error());
    const auto decisions = redecide(*session, redecide_);
    if (!decisions) return fail(decisions.error());
    if (!csv_.empty())
      if (const auto written = replace_file(csv_, to_csv(*decisions)); !written) return fail(written.error());
    if (!copy_.empty())
      if (const auto written = write_redecided(*session, *decisions, copy_); !written) return fail(written.error());
    std::fputs(to_text(*decisions).c_str(), stdout);
    const std::vector<std::string> sentences = broken(expectations, *decisions);
    if (!expectations.empty())
      std::printf("%zu of %zu expectations hold\n", expectations.size() - sentences.size(), expectations.size());
    for (const std::string& sentence : sentences) std::printf("  broken: %s\n", sentence.c_str());
    return sentences.empty() ? kDone : kBroken;
  }

 private:
  RedecideOptions redecide_;
  std::string session_, csv_, copy_, expect_;
};

}  // namespace

std::unique_ptr<Command> redecide_command(CLI::App& app) { return std::make_unique<RedecideCommand>(app); }

}  // namespace robot::app
