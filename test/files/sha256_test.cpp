// Against the examples of FIPS 180 and NIST, and as an engineer checks a file.

#include "talus/files/sha256.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program.hpp"
#include "support/input_folder.hpp"

namespace talus {
namespace {

class Sha256 : public testing_tools::InputFolder {};

TEST_F(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(Sha256, OfAFileIsThatOfItsBytes) {
  const std::string bytes(3'000'000, '\x7f');  // more than one piece
  write("dem.tif", bytes);
  write("empty", "");
  EXPECT_EQ(sha256_of_file(path("dem.tif")), sha256_of(bytes));
  EXPECT_EQ(sha256_of_file(path("empty")), sha256_of(""));
  EXPECT_EQ(test::says("sha256sum " + path("dem.tif").string() + " | cut -c-64").text, sha256_of(bytes) + "\n");
}

TEST_F(Sha256, NeedsAnOrdinaryFile) {
  EXPECT_EQ(sha256_of_file(path("")), std::nullopt);
  EXPECT_EQ(sha256_of_file(path("not-there")), std::nullopt);
  EXPECT_EQ(sha256_of_file("/dev/zero"), std::nullopt);
}

}  // namespace
}  // namespace talus
