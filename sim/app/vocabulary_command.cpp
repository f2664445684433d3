// foresight-sim skills, foresight-sim features: the words of a strategy.
#include <cstdio>
#include <vector>

#include "robot/core/json_library.h"
#include "sim/app/commands.h"
#include "sim/io/vocabulary.h"

namespace sim::app {
namespace {

/// Lists all words of one kind, or describes one. `Word` is agent::Skill or agent::Feature.
template <class Word>
class VocabularyCommand final : public Command {
 public:
  using Find = robot::Result<Word> (*)(std::string_view);

  VocabularyCommand(CLI::App& app, const char* kind, const char* about, const char* footer, int count, Find find)
      : Command(app.add_subcommand(kind, about)), footer_(footer), count_(count), find_(find) {
    options().add_option("name", name_, "describe only this one");
    options().add_flag("--json", json_, "report as JSON");
    options().footer(footer);
  }

  int run() override {
    std::vector<Word> words;
    if (name_.empty()) {
      for (int i = 0; i < count_; ++i) words.push_back(static_cast<Word>(i));
    } else {
      const auto found = find_(name_);
      if (!found) return fail(found.error());
      words.push_back(*found);
    }
    print(words);
    return kDone;
  }

 private:
  void print(const std::vector<Word>& words) const {
    io::Json list = io::Json::array();
    std::string text;
    for (const Word word : words) list.push_back(io::json_of(word)), text += io::text_of(word);
    if (json_)
      std::printf("%s\n", list.dump(2).c_str());
    else
      std::printf("%s\n%s\n", text.c_str(), footer_);
  }

  const char* const footer_;
  const int count_;
  const Find find_;
  std::string name_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> skills_command(CLI::App& app) {
  return std::make_unique<VocabularyCommand<agent::Skill>>(
      app, "skills", "list the skills that a leaf of a strategy can name, with their arguments",
      "An argument that a leaf does not give has its default. To add a skill: sim/agent/README.md.",
      agent::skill_count(), io::skill_named);
}

std::unique_ptr<Command> features_command(CLI::App& app) {
  return std::make_unique<VocabularyCommand<agent::Feature>>(
      app, "features", "list the features that a condition of a strategy can compare",
      "* is unknown while the ball is. Every comparison with an unknown value is false.", agent::feature_count(),
      io::feature_named);
}

}  // namespace sim::app
