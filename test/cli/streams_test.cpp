// Standard streams that are closed, full or narrow: they do not change the results.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/places.hpp"

namespace talus::test {
namespace {

/// The exit code of a shell command, in which TALUS is replaced by the program.
int code_of(std::string command) {
  const std::string name = "TALUS";
  for (auto at = command.find(name); at != std::string::npos; at = command.find(name))
    command.replace(at, name.size(), talus::places::program);
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(StandardError, ThatIsFullDoesNotChangeTheExitCode) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Workplace place;
  EXPECT_EQ(code_of("TALUS check nofile.toml 2> /dev/full"), 2);
  EXPECT_EQ(code_of("TALUS rnu 2> /dev/full"), 2);
  EXPECT_EQ(code_of("TALUS schema > /dev/full 2> /dev/full"), 2);
}

TEST(StandardError, ThatIsClosedByItsReaderDoesNotEndTheProgram) {
  const Workplace place;
  place.write("slope.toml", "");
  EXPECT_EQ(code_of("{ sleep 0.2; TALUS check nofile.toml 2>&1 >/dev/null; echo $? > " + (place / "code").string() +
                    "; } | true"),
            0);
  EXPECT_EQ(place.read("code"), "2\n");
}

TEST(StandardStreams, ThatAreClosedDoNotChangeTheTables) {
  const Workplace place;
  const auto run_into = [&](const char* folder) {
    return "TALUS run " + tutorial("2d") + " --rocks 2000 --set output.report=false -o " + (place / folder).string();
  };
  ASSERT_EQ(code_of(run_into("whole") + " > /dev/null"), 0);
  EXPECT_EQ(code_of(run_into("closed") + " <&- >&- 2>&-"), 0);
  EXPECT_EQ(differences(files_of(place / "whole"), files_of(place / "closed")), "");
}

TEST(StandardOutput, ThatIsClosedByItsReaderEndsTheProgramBySigpipe) {
  const Workplace place;
  EXPECT_EQ(code_of("{ TALUS schema; echo $? > " + (place / "code").string() + "; } | true"), 0);
  EXPECT_EQ(place.read("code"), "141\n");
}

TEST(FileSizeLimit, EndsEveryCommandWithBadInput) {
  const Workplace place;
  EXPECT_EQ(code_of("ulimit -f 1; TALUS new " + (place / "a.toml").string() + " > /dev/null 2>&1"), 2);
  EXPECT_EQ(code_of("ulimit -f 1; TALUS schema > " + (place / "schema").string() + " 2> /dev/null"), 2);
  EXPECT_FALSE(std::filesystem::exists(place / "a.toml.part"));
}

/// Standard error of a command on a terminal of `columns`.
std::string on_terminal(std::uint16_t columns, const std::string& command, int& code) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return "";
  const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
  ioctl(terminal, TIOCSWINSZ, &size);
  const std::string name = ptsname(terminal);
  const int held = open(name.c_str(), O_RDWR | O_NOCTTY);  // keeps the terminal open after the command has ended
  code = code_of(command + " > /dev/null 2> " + name);
  std::string text(1 << 16, '\0');
  fcntl(terminal, F_SETFL, O_NONBLOCK);
  const ssize_t got = read(terminal, text.data(), text.size());
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  close(held);
  close(terminal);
  return text;
}

TEST(Progress, FitsTheTerminal) {
  const Workplace place;
  for (const std::uint16_t columns : std::initializer_list<std::uint16_t>{40, 56, 200}) {
    int code = -1;
    const std::string text = on_terminal(columns,
                                         "timeout --preserve-status -s INT 1 TALUS run " + tutorial("2d") +
                                             " --rocks 200000000 --threads 1 --checkpoint-every 0 "
                                             "--set output.paths=none -o " +
                                             (place / "out").string(),
                                         code);
    if (code == -1) GTEST_SKIP() << "there are no terminals";
    EXPECT_EQ(code, 3);
    std::size_t longest = 0, begin = 0;
    const std::string renewed = "\r\x1b[K";
    for (auto at = text.find(renewed); at != std::string::npos; at = text.find(renewed, begin)) {
      begin = at + renewed.size();
      const std::size_t end = std::min(text.find('\r', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      if (line.find("stopped after") == std::string::npos && !line.starts_with("warning:"))
        longest = std::max(longest, end - begin);
    }
    EXPECT_GT(longest, 30U) << text;
    EXPECT_LT(longest, columns) << text;
    EXPECT_EQ(text.find("[#") != std::string::npos || text.find("[.") != std::string::npos, columns == 200) << text;
  }
}

}  // namespace
}  // namespace talus::test
