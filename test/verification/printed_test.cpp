#include "talus/verification/printed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "talus/core/problems.hpp"
#include "talus/verification/tolerance.hpp"

namespace talus::verification {
namespace {

TEST(Printed, TheUnitIsThatOfTheLastDigit) {
  EXPECT_DOUBLE_EQ(printed("-0.0260")->unit, 1e-4);
  EXPECT_DOUBLE_EQ(printed("-0.0260")->value, -0.026);
  EXPECT_DOUBLE_EQ(printed("283638")->unit, 1);
  EXPECT_DOUBLE_EQ(printed("3.97E-05")->unit, 1e-7);
  EXPECT_DOUBLE_EQ(printed("1.5e+3")->unit, 100);
}

TEST(Printed, OtherTextIsNotANumber) {
  EXPECT_FALSE(printed(""));
  EXPECT_FALSE(printed("-"));
  EXPECT_FALSE(printed("Impact"));
  EXPECT_FALSE(printed("1.5 m"));
  EXPECT_FALSE(printed("nan"));
}

TEST(PublishedTable, NumbersWithoutTrailingZerosHaveTheUnitOfTheirColumn) {
  const PublishedTable table("id,x_m,vz_m_s,ke\n0,0.5,0,1125\n1,2.71376,-14.4731,105860\n2,15.4901,0.013235,0\n",
                             "t.csv");
  EXPECT_DOUBLE_EQ(table.number(0, 0)->unit, 1e-4);  // 0.5000
  EXPECT_DOUBLE_EQ(table.number(1, 0)->unit, 1e-5);
  EXPECT_DOUBLE_EQ(table.number(0, 1)->unit, 1e-4);  // not 1: the column has decimals
  EXPECT_DOUBLE_EQ(table.number(2, 1)->unit, 1e-6);
  EXPECT_DOUBLE_EQ(table.number(2, 2)->unit, 1);
}

TEST(PublishedTable, FindsRowsAndColumnsByName) {
  const PublishedTable table("statistic,one,two\nmean,1.5,\ncount,50,-\n", "t.csv");
  EXPECT_EQ(table.column("two"), 1u);
  EXPECT_EQ(table.column("three"), std::nullopt);
  EXPECT_EQ(table.row("count"), 1u);
  EXPECT_EQ(table.row("sum"), std::nullopt);
  EXPECT_FALSE(table.number(0, 1));
  EXPECT_FALSE(table.number(1, 1));
  EXPECT_EQ(table.text(1, 1), "-");
}

TEST(PublishedTable, RefusesARowThatIsTooShort) {
  try {
    PublishedTable("id,x,y\n0,1,2\n1,1\n", "case/t.csv");
    FAIL() << "accepted";
  } catch (const BadInput& bad) {
    EXPECT_STREQ(bad.what(), "case/t.csv:3: the row has 2 values (the first line names 3 columns)");
  }
}

TEST(PublishedTable, RefusesATableWithoutRows) {
  EXPECT_THROW(PublishedTable("", "t.csv"), BadInput);
  EXPECT_THROW(PublishedTable("id,x\n", "t.csv"), BadInput);
}

TEST(Tolerance, TheWidestLimitApplies) {
  const Printed number = *printed("20.50");
  EXPECT_DOUBLE_EQ((Tolerance{.units = 1}.allowed(number, 0)), 0.01);
  EXPECT_DOUBLE_EQ((Tolerance{.units = 1, .relative = 0.01}.allowed(number, 0)), 0.205);
  EXPECT_DOUBLE_EQ((Tolerance{.units = 1, .absolute = 2}.allowed(number, 0)), 2);
  EXPECT_DOUBLE_EQ((Tolerance{.of_scale = 0.01}.allowed(number, 300)), 3);
  EXPECT_DOUBLE_EQ((Tolerance{}.allowed(number, 300)), 0);
}

TEST(Tolerance, IsDescribedInWords) {
  EXPECT_EQ((Tolerance{.units = 1, .relative = 0.0001}.text()), "1 unit of the last printed digit or 0.01 %");
  EXPECT_EQ((Tolerance{.absolute = 0.002}.text()), "0.002");
  EXPECT_EQ((Tolerance{.of_scale = 0.01}.text()), "1 % of the largest number of its kind");
  EXPECT_EQ(Tolerance{}.text(), "equal");
}

}  // namespace
}  // namespace talus::verification
