#include <gtest/gtest.h>

#include <cstdlib>

#include "talus/campaign/ranks.hpp"

namespace talus::launch_test {
namespace {

/// Sets the environment variables of launchers, for one test.
class Launched : public testing::Test {
 protected:
  void SetUp() override { forget(); }
  void TearDown() override { forget(); }
  static void forget() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK",
                             "SLURM_STEP_NUM_TASKS"}) {
      unsetenv(name);
    }
  }
  static void set(const char* name, const char* value) { setenv(name, value, 1); }
};

TEST_F(Launched, WithoutALauncherIsAlone) {
  set("SLURM_STEP_NUM_TASKS", "8");  // also set in a job's script
  EXPECT_FALSE(find_launch());
  EXPECT_EQ(join_ranks(), nullptr);
}

TEST_F(Launched, ByOpenMpi) {
  set("PMIX_RANK", "3");
  set("OMPI_COMM_WORLD_RANK", "3");
  set("OMPI_COMM_WORLD_SIZE", "8");
  const auto launch = find_launch();
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->rank, 3);
  EXPECT_EQ(launch->size, 8);
}

TEST_F(Launched, BySlurmWithPmix) {
  set("PMIX_RANK", "0");
  EXPECT_FALSE(find_launch()->size);
  set("SLURM_STEP_NUM_TASKS", "16");
  EXPECT_EQ(find_launch()->size, 16);
}

TEST_F(Launched, AsTheOnlyOneIsAlone) {
  set("PMI_RANK", "0");
  set("PMI_SIZE", "1");
  EXPECT_EQ(find_launch()->size, 1);
  EXPECT_EQ(join_ranks(), nullptr);
}

TEST_F(Launched, WithAnInvalidNumberIsAlone) {
  set("PMI_RANK", "first");
  EXPECT_FALSE(find_launch());
}

}  // namespace
}  // namespace talus::launch_test
