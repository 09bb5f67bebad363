// A map is synced to disk before it gets its name: a failing disk is noticed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#if defined(TALUS_HAS_GDAL) && defined(__x86_64__)

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <tbb/global_control.h>

#include <array>
#include <cerrno>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.hpp"
#include "talus/core/problems.hpp"
#include "talus/maps/map_files.hpp"

namespace talus {
namespace {

/// Makes fsync() fail in this thread, as on a broken disk.
bool break_disk() {
  std::array<sock_filter, 4> rules{sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0),
                                   sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fsync, 0, 1),
                                   sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EIO),
                                   sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog program{static_cast<unsigned short>(rules.size()), rules.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

TEST(MapSync, LeavesNoMapIfTheDiskFails) {
  const test::Workplace work;
  Maps maps(MapGrid({0, 0}, 1, {}));
  const std::vector<MapVisit> visits{{{0, 0}, {1, 1, 1, 1}, 0, false}};
  const std::span<const MapVisit> list(visits);
  maps.add(1, std::span(&list, 1));
  std::string said = "was written";
  bool is_broken = false;
  std::thread([&] {
    const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
    is_broken = break_disk();
    try {
      (void)write_maps(maps, {}, "", work / "maps");
    } catch (const BadInput& bad) {
      said = bad.what();
    }
  }).join();
  if (!is_broken) GTEST_SKIP() << "this system lets no program forbid itself anything";
  EXPECT_THAT(said, ::testing::HasSubstr(".tif: cannot finish this file (Input/output error)"));
  for (const auto& entry : std::filesystem::directory_iterator(work / "maps")) {
    EXPECT_NE(entry.path().extension(), ".tif") << entry.path();
  }
}

}  // namespace
}  // namespace talus

#endif
