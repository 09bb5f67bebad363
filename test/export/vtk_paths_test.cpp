// paths.vtp, parsed as a reader of VTK's XML files does.

#include "talus/export/vtk_paths.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "support/file_size_limit.hpp"
#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"
#include "talus/rocks/motion.hpp"

namespace talus {
namespace {

using sample_run::path_rows;
using sample_run::paths_head;

struct Vtp {
  std::map<std::string, std::string> piece;        // attributes of <Piece>
  std::map<std::string, std::string> types, data;  // of each array, by its name
  std::map<std::string, int> components;

  template <class Number>
  [[nodiscard]] std::vector<Number> numbers(const std::string& name) const {
    const std::string& bytes = data.at(name);
    std::vector<Number> out(bytes.size() / sizeof(Number));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Number));
    return out;
  }
};

std::map<std::string, std::string> attributes_in(const std::string& element) {
  std::map<std::string, std::string> found;
  static const std::regex attribute("(\\w+)=\"([^\"]*)\"");
  for (std::sregex_iterator at(element.begin(), element.end(), attribute), end; at != end; ++at) {
    found[(*at)[1]] = (*at)[2];
  }
  return found;
}

/// Every element is opened and closed as XML requires.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  static const std::regex tag("<(/?)(\\w+)((?:\\s+\\w+=\"[^\"<>]*\")*)\\s*(/?)>|<\\?xml version=\"1.0\"\\?>");
  std::string rest;
  std::size_t last = 0;
  for (std::sregex_iterator at(xml.begin(), xml.end(), tag), end; at != end; ++at) {
    rest += xml.substr(last, static_cast<std::size_t>(at->position()) - last);
    last = static_cast<std::size_t>(at->position() + at->length());
    if (!(*at)[2].matched) continue;
    if ((*at)[1].length() > 0) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*at)[2]);
      open.pop_back();
    } else if ((*at)[4].length() == 0) {
      open.push_back((*at)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  rest += xml.substr(last);
  EXPECT_EQ(rest.find_first_not_of(" \n_"), std::string::npos) << rest;
}

Vtp read(const std::string& file) {
  Vtp vtp;
  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t begin = file.find(mark) + mark.size(), end = file.rfind("\n</AppendedData>");
  EXPECT_LT(begin, file.size());
  const std::string head = file.substr(0, begin), appended = file.substr(begin, end - begin);
  expect_well_formed(head + file.substr(end));
  EXPECT_EQ(attributes_in(head.substr(head.find("<VTKFile"), 200))["header_type"], "UInt64");
  const std::size_t piece = head.find("<Piece");
  vtp.piece = attributes_in(head.substr(piece, head.find('>', piece) - piece));
  std::size_t expected_offset = 0;
  for (std::size_t at = 0; (at = head.find("<DataArray", at)) != std::string::npos; ++at) {
    auto array = attributes_in(head.substr(at, head.find('>', at) - at));
    const std::size_t offset = std::stoul(array["offset"]);
    EXPECT_EQ(offset, expected_offset);  // consecutive, without overlap
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, appended.data() + offset, sizeof bytes);
    expected_offset = offset + sizeof bytes + bytes;
    const std::string& name = array["Name"];
    vtp.types[name] = array["type"];
    vtp.components[name] = array.contains("NumberOfComponents") ? std::stoi(array["NumberOfComponents"]) : 1;
    vtp.data[name] = appended.substr(offset + sizeof bytes, bytes);
  }
  EXPECT_EQ(appended.size(), expected_offset);
  return vtp;
}

/// A rock launched from (0, 0, 100) with (4, 3, 10) m/s, which impacts after 4 s and slides 8 m in 2 s.
const std::string thrown =
    "5,0,projectile,0,0,0,100,4,3,10,1,2,3,6250,50,0\n"
    "5,1,impact,4,16,12,60,4,3,-30,1,2,3,46250,50,0\n"
    "5,2,sliding,4,16,12,60,4,0,0,0,0,0,800,0,0\n"
    "5,3,ended,6,24,12,60,0,0,0,0,0,0,0,0,0\n";

TEST(VtkPaths, HaveEveryPathAsALineWithItsArcs) {
  const sample_run::Folder folder("vtk");
  folder.write("paths.csv", paths_head + path_rows(0) + thrown + path_rows(9));
  write_vtk_paths(folder.path);
  const Vtp vtp = read(folder.read("paths.vtp"));
  const auto points = static_cast<std::size_t>(std::stoul(vtp.piece.at("NumberOfPoints")));
  EXPECT_EQ(vtp.piece.at("NumberOfLines"), "3");
  EXPECT_EQ(vtp.numbers<std::int64_t>("rock"), (std::vector<std::int64_t>{0, 5, 9}));

  const auto offsets = vtp.numbers<std::int64_t>("offsets"), connectivity = vtp.numbers<std::int64_t>("connectivity");
  ASSERT_EQ(offsets.size(), 3U);
  EXPECT_EQ(static_cast<std::size_t>(offsets[2]), points);
  ASSERT_EQ(connectivity.size(), points);
  for (std::size_t k = 0; k < points; ++k) EXPECT_EQ(connectivity[k], static_cast<std::int64_t>(k));

  const auto time = vtp.numbers<double>("time_s"), energy = vtp.numbers<double>("ke_total_J"),
             place = vtp.numbers<double>("Points");
  const auto velocity = vtp.numbers<float>("velocity_m_s");
  const auto state = vtp.numbers<std::uint8_t>("state");
  ASSERT_EQ(time.size(), points);
  ASSERT_EQ(energy.size(), points);
  ASSERT_EQ(state.size(), points);
  ASSERT_EQ(place.size(), 3 * points);
  ASSERT_EQ(velocity.size(), 3 * points);
  EXPECT_EQ(vtp.components.at("Points"), 3);
  EXPECT_EQ(vtp.components.at("velocity_m_s"), 3);

  // The launched rock falls with 10 m/s2: 4 s sqrt(10/(8 0.05)) = 20 pieces, and three more rows.
  const auto first = static_cast<std::size_t>(offsets[0]), end = static_cast<std::size_t>(offsets[1]);
  ASSERT_EQ(end - first, 20U + 3U);
  for (std::size_t k = first; k < first + 20; ++k) {
    const double t = 0.2 * static_cast<double>(k - first);
    EXPECT_NEAR(time[k], t, 1e-12);
    EXPECT_NEAR(place[3 * k], 4 * t, 1e-9);
    EXPECT_NEAR(place[3 * k + 1], 3 * t, 1e-9);
    EXPECT_NEAR(place[3 * k + 2], 100 + 10 * t - 5 * t * t, 1e-9);
    EXPECT_NEAR(static_cast<double>(velocity[3 * k + 2]), 10 - 10 * t, 1e-5);
    EXPECT_NEAR(energy[k], 50 * (25 + (10 - 10 * t) * (10 - 10 * t)) + 50, 1e-6);  // of 100 kg
    EXPECT_EQ(state[k], static_cast<std::uint8_t>(PathState::projectile));
  }
  EXPECT_EQ(state[end - 3], static_cast<std::uint8_t>(PathState::impact));
  EXPECT_EQ(state[end - 2], static_cast<std::uint8_t>(PathState::sliding));
  EXPECT_EQ(state[end - 1], static_cast<std::uint8_t>(PathState::ended));
  EXPECT_EQ(time[end - 1], 6);
  EXPECT_EQ(place[3 * (end - 1)], 24);
}

TEST(VtkPaths, HaveNoLineWithoutAPath) {
  const sample_run::Folder folder("vtk");
  folder.write("paths.csv", paths_head);
  write_vtk_paths(folder.path);
  const Vtp vtp = read(folder.read("paths.vtp"));
  EXPECT_EQ(vtp.piece.at("NumberOfPoints"), "0");
  EXPECT_EQ(vtp.piece.at("NumberOfLines"), "0");
}

// More than is buffered before it is written.
TEST(VtkPaths, AreCompleteForManyRocks) {
  const sample_run::Folder folder("vtk");
  std::string text = paths_head;
  constexpr std::uint64_t rocks = 20'000;
  for (std::uint64_t rock = 0; rock < rocks; ++rock) text += path_rows(rock);
  folder.write("paths.csv", text);
  write_vtk_paths(folder.path);
  const Vtp vtp = read(folder.read("paths.vtp"));
  const auto rock = vtp.numbers<std::int64_t>("rock"), offsets = vtp.numbers<std::int64_t>("offsets");
  const auto state = vtp.numbers<std::uint8_t>("state");
  ASSERT_EQ(rock.size(), rocks);
  for (std::size_t k = 0; k < rocks; ++k) {
    EXPECT_EQ(rock[k], static_cast<std::int64_t>(k));
    EXPECT_EQ(state[static_cast<std::size_t>(offsets[k]) - 1], static_cast<std::uint8_t>(PathState::ended));
  }
}

TEST(VtkPaths, ReportWhereTheyCannotBeWritten) {
  const sample_run::Folder folder("vtk");
  folder.write("paths.csv", paths_head + path_rows(0));
  std::filesystem::create_directories(folder.path / "paths.vtp.part/in the way");
  try {
    write_vtk_paths(folder.path);
    ADD_FAILURE() << "was written";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.what(), (folder.path / "paths.vtp").string() +
                              ": cannot create this file (Is a directory). Choose another folder with -o");
  }
}

TEST(VtkPaths, LeaveNoPartOnAFullDisk) {
  const sample_run::Folder folder("vtk");
  std::string text = paths_head;
  for (std::uint64_t rock = 0; rock < 5000; ++rock) text += path_rows(rock);
  folder.write("paths.csv", text);
  try {
    const testing_tools::FileSizeLimit limit(65536);
    write_vtk_paths(folder.path);
    ADD_FAILURE() << "was written";
  } catch (const BadInput& bad) {
    EXPECT_EQ(std::string(bad.what()).find((folder.path / "paths.vtp").string() + ": cannot write to this file ("), 0U)
        << bad.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path / "paths.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "paths.vtp.part"));
}

}  // namespace
}  // namespace talus
