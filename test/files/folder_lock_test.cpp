#include "talus/files/folder_lock.hpp"

#include <gtest/gtest.h>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

TEST(FolderLock, IsHeldByOneUntilItIsDestroyed) {
  const sample_run::Folder folder{"lock-held"}, other{"lock-other"};
  {
    const auto lock = FolderLock::take(folder.path);
    ASSERT_TRUE(lock);
    EXPECT_FALSE(FolderLock::take(folder.path));
    EXPECT_FALSE(FolderLock::take(folder.path / "../" / folder.path.filename())) << "by whatever name";
    EXPECT_TRUE(FolderLock::take(other.path));
  }
  EXPECT_TRUE(FolderLock::take(folder.path));
}

TEST(FolderLock, OfAnotherProcessPreventsWriting) {
  const sample_run::Folder folder{"lock-taken"};
  const FolderLock lock = lock_output_folder(folder.path);
  try {
    static_cast<void>(lock_output_folder(folder.path));
    FAIL() << "both write there";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.what(), folder.path.string() +
                              ": cannot write results here (another program is writing results into this folder). Wait "
                              "until it has ended, or write elsewhere with -o");
  }
}

// Writing to such a folder reports what is wrong with it.
TEST(FolderLock, HasNoEffectOnFoldersThatCannotBeLocked) {
  const sample_run::Folder folder{"lock-absent"};
  const auto first = FolderLock::take(folder.path / "not there"), second = FolderLock::take(folder.path / "not there");
  EXPECT_TRUE(first && second);
}

}  // namespace
}  // namespace talus
