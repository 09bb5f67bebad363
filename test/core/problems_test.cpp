#include "talus/core/problems.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace talus::problems_test {
namespace {

Problem whole_problem() {
  return {.severity = Severity::error,
          .file = "tutorial.toml",
          .line = 31,
          .where = "material \"Type One\"",
          .what = "normal_restitution mean is 1.3",
          .why = "a rebound cannot gain energy; expected 0 to 1",
          .hint = "Did you mean 0.13?"};
}

Problem saying(std::string what, Severity severity = Severity::error) {
  Problem problem;
  problem.severity = severity;
  problem.what = std::move(what);
  return problem;
}

TEST(ProblemText, HasAllPartsInTheOrderFileLineWhereWhatWhyHint) {
  EXPECT_EQ(whole_problem().text(),
            "tutorial.toml:31: material \"Type One\": normal_restitution mean is 1.3 (a rebound cannot gain energy; "
            "expected 0 to 1). Did you mean 0.13?");
}

TEST(ProblemText, HasNoKind) {
  Problem of_kind = whole_problem();
  of_kind.kind = ProblemKind::mostly_on_ground;
  EXPECT_EQ(of_kind.text(), whole_problem().text());
  EXPECT_EQ(word(of_kind.kind), "mostly_on_ground");
  EXPECT_EQ(word(whole_problem().kind), "");
}

TEST(ProblemText, OmitsUnknownParts) {
  EXPECT_EQ(saying("the disk is full").text(), "the disk is full");
  Problem without_line = whole_problem();
  without_line.line = 0;
  without_line.why.clear();
  without_line.hint.clear();
  EXPECT_EQ(without_line.text(), "tutorial.toml: material \"Type One\": normal_restitution mean is 1.3");
  Problem without_file = whole_problem();
  without_file.file.clear();
  EXPECT_EQ(without_file.text().find("31"), std::string::npos) << "a line number without a file is useless";
}

TEST(ProblemText, MarksAWarning) {
  Problem warning = saying("two triangles were dropped", Severity::warning);
  warning.file = "bowl.obj";
  EXPECT_EQ(warning.text(), "bowl.obj: warning: two triangles were dropped");
}

TEST(ProblemList, KeepsTheOrderWithOnePerLine) {
  Problems first, second;
  first.add(saying("one"));
  second.add(saying("two"));
  second.add(saying("three"));
  first.append(second);
  ASSERT_EQ(first.list().size(), 3u);
  EXPECT_EQ(first.text(), "one\ntwo\nthree");
  EXPECT_EQ(Problems().text(), "");
}

TEST(ProblemList, AWarningIsNotAnError) {
  Problems problems;
  EXPECT_FALSE(problems.has_errors());
  problems.add(saying("odd", Severity::warning));
  EXPECT_FALSE(problems.has_errors());
  problems.add(saying("wrong"));
  EXPECT_TRUE(problems.has_errors());
}

TEST(ProblemList, IsSortedByTheLinesOfAFile) {
  Problems problems;
  const auto add = [&](const char* file, int line, const char* what) {
    problems.add({.file = file, .line = line, .what = what});
  };
  add("--set x=1", 0, "an option");
  add("a.toml", 9, "late");
  add("b.csv", 1, "another file");
  add("a.toml", 4, "early");
  add("a.toml", 9, "also late");
  std::string text;
  const Problems sorted = problems.in_order_of("a.toml");
  for (const Problem& problem : sorted.list()) text += problem.what + "; ";
  EXPECT_EQ(text, "early; late; also late; an option; another file; ");
}

TEST(BadInputException, HasEveryProblem) {
  Problems problems;
  problems.add(saying("one"));
  problems.add(saying("two"));
  try {
    throw BadInput(problems);
  } catch (const BadInput& caught) {
    EXPECT_STREQ(caught.what(), "one\ntwo");
    EXPECT_EQ(caught.problems().list().size(), 2u);
  }
  const BadInput single(whole_problem());
  EXPECT_EQ(single.what(), whole_problem().text());
  EXPECT_EQ(single.problems().list().size(), 1u);
}

}  // namespace
}  // namespace talus::problems_test
