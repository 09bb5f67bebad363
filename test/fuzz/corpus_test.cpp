// Every input that a fuzz target has kept, read again: it is read or refused, and takes no more memory than a small
// file may.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/targets.hpp"
#include "support/places.hpp"

namespace talus::fuzz {

static void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(talus::places::in_source("/fuzz/corpus"));

std::vector<fs::path> inputs_of(const Target& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(corpus / target.name)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// The most memory that this process has had at once [MiB].
long peak_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

class Corpus : public ::testing::TestWithParam<Target> {
 protected:
  Corpus() { fs::create_directories(folder_); }
  ~Corpus() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path folder_ =
      fs::path{::testing::TempDir()} / ("talus_corpus_" + std::string(GetParam().name) + std::to_string(::getpid()));
};

TEST_P(Corpus, IsReadOrRefusedInLittleMemory) {
  constexpr long most_MiB = 300;
  const long before = peak_MiB();
  std::size_t read = 0, refused = 0;
  for (const fs::path& file : inputs_of(GetParam())) {
    SCOPED_TRACE(file.filename().string());
    Verdict verdict{};
    EXPECT_NO_THROW(verdict = GetParam().read(content(file), folder_));
    ++(verdict == Verdict::read ? read : refused);
    ASSERT_LT(peak_MiB() - before, most_MiB);
  }
  // A corpus of which nothing is read says little.
  EXPECT_GT(read, 0U);
  EXPECT_GT(refused, 0U);
}

TEST_P(Corpus, PiecesOfItAreReadOrRefused) {
  for (const fs::path& file : inputs_of(GetParam())) {
    SCOPED_TRACE(file.filename().string());
    const std::string whole = content(file);
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - whole.size() / 8}) {
      EXPECT_NO_THROW((void)GetParam().read(std::string_view(whole).substr(0, length), folder_));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, ::testing::ValuesIn(targets),
                         [](const auto& about) { return std::string(about.param.name); });

}  // namespace
}  // namespace talus::fuzz
