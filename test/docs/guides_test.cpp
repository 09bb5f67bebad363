// The files and commands of the pages in docs/guides, executed in order, give the output on the page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/mpirun.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "docs/guide_page.hpp"
#include "support/places.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const fs::path guides = talus::places::in_source("/docs/guides");

std::vector<std::string> guide_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(guides)) {
    if (entry.path().extension() == ".md") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

/// A temporary folder with a copy of the examples, and with `talus` in the PATH of its shell.
class GuideFolder {
 public:
  GuideFolder() {
    fs::create_directories(folder_ / "programs");
    fs::create_directories(folder_ / "work");
    fs::create_symlink(talus::places::program, folder_ / "programs/talus");
    fs::copy(talus::places::in_source("/examples"), folder_ / "work/examples", fs::copy_options::recursive);
  }

  void write(const ShownFile& file) const { (void)folder_.write("work/" + file.name, file.text); }

  [[nodiscard]] Said run(const Command& command) const {
    std::string script = "cd '" + (folder_ / "work").string() + "'\nexport LC_ALL=C PATH='" +
                         (folder_ / "programs").string() + "':\"$PATH\"\n";
    // mpirun as root, on fewer cores than ranks, and without a network
    script +=
        "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl=self,vader "
        "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none "
        "OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_mpi_yield_when_idle=1\n";
    for (const std::string& setting : environment_of_mpi()) script += "export " + setting + "\n";
    (void)folder_.write("script", script + command.text());
    return says("sh '" + (folder_ / "script").string() + "'");
  }

 private:
  Workplace folder_;
};

/// The requirement of a page that this build or machine does not meet; empty if none.
std::string missing_requirement(const std::string& page) {
  const auto needs = [&](const char* what) { return page.find(std::string("; needs ") + what) != std::string::npos; };
#ifndef TALUS_HAS_GDAL
  if (needs("GDAL")) return "built without GDAL";
#endif
#ifdef TALUS_HAS_MPI
  if (needs("MPI") && !has_mpirun()) return "no mpirun";
#else
  if (needs("MPI")) return "built without MPI";
#endif
  (void)needs;
  return {};
}

class Guide : public ::testing::TestWithParam<std::string> {};

TEST_P(Guide, IsNotStale) {
  const fs::path file = guides / (GetParam() + ".md");
  const std::string text = bytes_of(file);
  if (const std::string what = missing_requirement(text); !what.empty()) GTEST_SKIP() << what;
  GuidePage page = read_guide(text);
  const GuideFolder folder;
  int commands = 0;
  for (auto& part : page.parts) {
    if (const auto* shown = std::get_if<ShownFile>(&part)) folder.write(*shown);
    auto* console = std::get_if<Console>(&part);
    if (console == nullptr) continue;
    for (Command& command : console->commands) {
      const Said said = folder.run(command);
      EXPECT_EQ(said.exit_code, 0) << command.text() << said.text;
      command.output = as_shown(said.text);
      ++commands;
    }
  }
  EXPECT_GT(commands, 0);
  if (std::getenv("TALUS_RENEW_REFERENCE") != nullptr) std::ofstream(file) << page.text();
  EXPECT_EQ(page.text(), bytes_of(file)) << file
                                         << " does not show the current output of its commands; run this test with "
                                            "TALUS_RENEW_REFERENCE=1, and read the page again";
  EXPECT_THAT(unsupported_numbers(page), IsEmpty())
      << "numbers in the text of " << file << " that are in none of its files, commands and outputs";
}

INSTANTIATE_TEST_SUITE_P(Page, Guide, ::testing::ValuesIn(guide_names()), [](const auto& guide) {
  std::string name = guide.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

const std::string small_page =
    "# A\n\nSave `a.toml`:\n\n```toml a.toml\nx = 12.6\n```\n\n```console\n$ cat \\\n  a.toml\nx = 12.6\n$ "
    "true\n```\nEnd.\n";

TEST(GuidePage, IsReadAsFilesAndCommands) {
  const GuidePage page = read_guide(small_page);
  ASSERT_EQ(page.parts.size(), 5U);
  EXPECT_EQ(std::get<ShownFile>(page.parts[1]).text, "x = 12.6\n");
  const auto& commands = std::get<Console>(page.parts[3]).commands;
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_EQ(commands[0].text(), "cat \\\n  a.toml\n");
  EXPECT_EQ(commands[0].output, "x = 12.6\n");
  EXPECT_EQ(commands[1].output, "");
  EXPECT_EQ(page.text(), small_page);
}

TEST(GuidePage, RefusesBlocksThatCannotBeChecked) {
  const auto refusal = [](const std::string& text) {
    try {
      (void)read_guide(text);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(refusal("A\n```sh\nmake\n```\n"), "line 2: a block without a file name: sh");
  EXPECT_EQ(refusal("A\n```toml a.toml\n```\n"), "line 2: the paragraph before the block does not name `a.toml`");
  EXPECT_EQ(refusal("```console\nmake\n```\n"), "line 1: a console begins with \"$ \", not with: make");
  EXPECT_EQ(refusal("```console\n$ make\n"), "line 1: the block has no end");
}

TEST(GuidePage, ShowsNoTimings) {
  EXPECT_EQ(as_shown("A: 50 rocks in 0.01 s (25416 rocks/s on 2 threads)\n"),
            "A: 50 rocks in ... s (... rocks/s on ... threads)\n");
  EXPECT_EQ(as_shown("A: 50 rocks in 2 s (25 rocks/s on 1 thread of 2 ranks)\n"),
            "A: 50 rocks in ... s (... rocks/s on ... threads of 2 ranks)\n");
  EXPECT_EQ(as_shown("9216 of 20000 rocks (46 %), 921 rocks/s, 0:11 left\nA\n"), "A\n") << "on a slow machine";
}

TEST(GuidePage, ReportsUnsupportedNumbers) {
  const auto unknown = [](const std::string& line) {
    return unsupported_numbers(read_guide("`a`\n```csv a\n-12.64,0.173,1500\n```\n" + line + "\n"));
  };
  EXPECT_THAT(unknown("12.6 or 13 m, 17 %, 1,500 kJ, in 3D, p95 and the 95th; [8](9.md)"),
              ElementsAre(HasSubstr("8 in")));
  EXPECT_THAT(unknown("12 m, 12.7 m, 18 %, 1501"), ::testing::SizeIs(4));
}

}  // namespace
}  // namespace talus::test
