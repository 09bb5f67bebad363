// Files that are written piece by piece over several runs.

#include "talus/archive/table_files.hpp"

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using test::Workplace;

TEST(OutputFile, ResumesAPart) {
  const Workplace work;
  work.write("table.csv.part", "0123456789 and more that was not kept");
  {
    OutputFile file(work / "table.csv", 10);
    EXPECT_EQ(file.position(), 10U);
    file.write("abc");
    file.sync();
    EXPECT_EQ(work.read("table.csv.part"), "0123456789abc");
    file.commit();
  }
  EXPECT_EQ(work.read("table.csv"), "0123456789abc");
  EXPECT_FALSE(std::filesystem::exists(work / "table.csv.part"));
}

TEST(OutputFile, ResumesAFinishedFileWithoutAPart) {
  const Workplace work;
  work.write("table.csv", "0123456789");
  OutputFile(work / "table.csv", 4).commit();
  EXPECT_EQ(work.read("table.csv"), "0123");
}

TEST(OutputFile, KeepsItsPartOnlyIfAsked) {
  const Workplace work;
  { OutputFile(work / "a").write("a"); }
  EXPECT_FALSE(std::filesystem::exists(work / "a.part"));
  {
    OutputFile file(work / "b");
    file.write("b");
    file.keep_part();
  }
  EXPECT_EQ(work.read("b.part"), "b");
  { OutputFile(work / "b", 1).write("c"); }
  EXPECT_EQ(work.read("b.part"), "bc");
}

std::string message(const auto& work_that_fails) {
  try {
    work_that_fails();
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "nothing was refused";
}

TEST(OutputFile, DoesNotResumeAShorterFile) {
  const Workplace work;
  work.write("short.csv.part", "0123");
  EXPECT_EQ(message([&] { OutputFile(work / "short.csv", 5); }),
            (work / "short.csv.part").string() + ": cannot continue this file (it has 4 bytes, expected at least 5)");
  EXPECT_EQ(work.read("short.csv.part"), "0123");
  EXPECT_EQ(message([&] { OutputFile(work / "none.csv", 0); }),
            (work / "none.csv").string() +
                ": cannot continue this file (No such file or directory). Choose another folder with -o");
}

TEST(TableMark, FindsItsTableAsAPartOrFinished) {
  const Workplace work;
  const std::string rows(100'000, 'r');
  work.write("t.csv", rows + "later");
  const TableMark mark = mark_of(work / "t.csv", "t.csv", rows.size());
  EXPECT_EQ(find_marked(work / "", mark), work / "t.csv");
  work.write("t.csv.part", rows);
  EXPECT_EQ(find_marked(work / "", mark), work / "t.csv.part");
  std::string other = rows;
  other[rows.size() - 1] = 'x';
  work.write("t.csv.part", other);
  EXPECT_EQ(message([&] { (void)find_marked(work / "", mark); }),
            (work / "t.csv.part").string() +
                ": this table is not the one that the state was saved with (its rows up to the saved place differ). "
                "It was changed or removed; run these rocks again");
}

TEST(TableMark, IsRestoredAndRefusesOtherFolders) {
  ByteWriter out;
  TableMark{"t.csv", 17, {1, 2}}.save(out);
  ByteReader in(out.bytes());
  EXPECT_EQ(TableMark::read(in), (TableMark{"t.csv", 17, {1, 2}}));
  for (const char* name : {"", "../t.csv", "/etc/passwd", "a/b", ".", ".."}) {
    ByteWriter bad;
    TableMark{name, 17, {1, 2}}.save(bad);
    ByteReader reader(bad.bytes());
    EXPECT_THROW((void)TableMark::read(reader), BadBytes) << name;
  }
}

TEST(TableFiles, ResumeAtTheirMarks) {
  const Workplace work;
  std::vector<TableMark> marks;
  const auto add_rock = [](TableFiles& files, std::uint64_t rock) {
    RockRecord record;
    record.rock = rock;
    for (Observer* table : files.observers()) {
      const auto part = table->new_part();
      part->see(record, RockLog(true));
      table->commit(*part);
    }
  };
  TableContext context;
  context.seeders = {"crest"};
  {
    TableFiles files(work / "", context, TableRocks(10, {.paths = 0}));
    files.begin();
    add_rock(files, 0);
    marks = files.sync();
    files.keep_parts();
    add_rock(files, 7);  // after the mark: dropped
  }
  TableFiles files(work / "", context, TableRocks(10, {.paths = 0}));
  files.resume(marks);
  add_rock(files, 1);
  files.finish();
  std::istringstream lines(work.read("endpoints.csv"));
  std::string header, first, second, more;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(header.substr(0, 12), "rock,seeder,");
  EXPECT_EQ(first.substr(0, 8), "0,crest,");
  EXPECT_EQ(second.substr(0, 8), "1,crest,");
  EXPECT_FALSE(std::getline(lines, more));
}

}  // namespace
}  // namespace talus
