// The manual page and the completions of shells, which the program writes from its declaration of commands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "cli/program.hpp"

namespace talus {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(TalusManual, HasEveryCommandAndItsOptions) {
  const Said page = talus_says("manual");
  EXPECT_EQ(page.exit_code, 0);
  const std::string help = talus_says("--help").text;
  std::istringstream lines(help.substr(help.find("Subcommands:\n")));
  int commands = 0;
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && line.starts_with("  ");) {
    std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (name.empty()) continue;  // a description goes on
    ++commands;
    if (const auto dash = name.find('-'); dash != std::string::npos) name.insert(dash, "\\");
    EXPECT_THAT(page.text, HasSubstr("\n.SS talus " + name));
  }
  EXPECT_GE(commands, 15);
  EXPECT_THAT(page.text, HasSubstr(".SS talus run [OPTIONS] PROJECT.toml\nRun a project, and write tables and a "
                                   "report.\n"));
  EXPECT_THAT(page.text, HasSubstr(".TP\n\\fB\\-\\-checkpoint\\-every\\fP \\fISECONDS\\fP\nTime between checkpoints, "
                                   "from which \\-\\-resume continues; 0: no checkpoints (from 0 to 1e+09; default: "
                                   "20).\n"));
  EXPECT_THAT(page.text, HasSubstr("\\fB\\-\\-rock\\fP \\fIN\\fP\nNumber of the rock, as in endpoints.csv "
                                   "(zero\\-based) (required).\n"));
  EXPECT_THAT(page.text, HasSubstr("\\fB\\-\\-ditch\\fP \\fIX\\fP"));  // of a group of options
  EXPECT_THAT(page.text, HasSubstr(".TP\n.B 3\nstopped by a signal (results so far kept).\n"));
}

TEST(TalusManual, IsValidForTroff) {
  if (says("command -v groff").exit_code != 0) GTEST_SKIP() << "groff is not installed";
  EXPECT_EQ(talus_says("manual | groff -man -Tascii -ww -z").text, "");
}

/// What bash offers for the last of `words`, in a folder with the files a.toml and b.csv and the folder c.
std::string completed(const std::string& words) {
  const Workplace place;
  (void)place.write("a.toml", "");
  (void)place.write("b.csv", "");
  std::filesystem::create_directory(place / "c");
  const std::string script =
      place.write("script", "cd '" + (place / "").string() + "'; rm script\n" + "source <(" + places::program +
                                " completion bash)\nCOMP_WORDS=(" + words +
                                ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_talus\necho \"${COMPREPLY[*]}\"\n");
  return says("bash '" + script + "'").text;
}

TEST(TalusCompletion, OffersCommandsOptionsAndValuesInBash) {
  EXPECT_EQ(completed("talus ru"), "run\n");
  EXPECT_EQ(completed("talus run --thr"), "--threads\n");
  EXPECT_EQ(completed("talus run ''"), "c a.toml\n");
  EXPECT_EQ(completed("talus run a.toml -o ''"), "c\n");
  EXPECT_EQ(completed("talus run a.toml --output = ''"), "c\n");
  EXPECT_EQ(completed("talus run a.toml --threads ''"), "\n");
  EXPECT_EQ(completed("talus line c --line ''"), "c a.toml b.csv\n");
  EXPECT_EQ(completed("talus report c --paper ''"), "A4 A3\n");
  EXPECT_EQ(completed("talus report c --units ''"), "metric us\n");
  EXPECT_EQ(completed("talus completion f"), "fish\n");
}

TEST(TalusCompletion, IsValidForEachShellThatIsInstalled) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Said script = talus_says("completion " + shell);
    EXPECT_EQ(script.exit_code, 0);
    EXPECT_THAT(script.text, HasSubstr("checkpoint-every"));
    if (says("command -v " + shell).exit_code != 0) continue;
    const Workplace place;
    EXPECT_EQ(says(shell + " -n '" + place.write("script", script.text) + "'").text, "");
  }
}

TEST(TalusCompletion, RefusesAnUnknownShell) {
  const Said said = talus_says("completion tcsh");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, "shell: tcsh not in {bash,zsh,fish}\nSee `talus completion --help`.\n");
}

}  // namespace
}  // namespace talus
