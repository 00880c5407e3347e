// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run ends with: one number per row, the same in the log's tables, absent where a run
// does not have it.
#include "runSummary.H"
#include "StringStream.H"
#include "error.H"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

runSummary example()
{
    runSummary s;
    s.balance = {{"injected", 19, 19e-9}, {"deposited", 14, 14e-9}, {"  on screen", 14, 14e-9},
        {"escaped", 5, 5e-9}, {"  through outlet", 5, 5e-9}};
    s.aggregates = {{1, 3}, {5, 2}, {8, 1}, {9, 4}};
    s.parts = {{"gas", 6}, {"tracking", 1}};
    s.seconds = 10;
    s.work.touches = 2;
    s.work.touchSpeed = 0.01 + 0.03;
    s.work.touchSpeedSquare = 0.01*0.01 + 0.03*0.03;
    s.smallestMargin = GREAT;
    s.closes = true;
    return s;
}

// -1: there is no such row
double value(const runSummary& s, const std::string& quantity, const std::string& unit)
{
    double found = -1;
    int n = 0;
    for (const auto& r : s.rows())
        if (r.quantity == quantity)
        {
            ++n;
            found = r.value;
            EXPECT_EQ(r.unit, unit) << quantity;
        }
    EXPECT_LE(n, 1) << quantity;
    return found;
}

std::string text(const runSummary& s)
{
    OStringStream os;
    s.print(os);
    return os.str();
}

}

TEST(runSummary, partsAreNamedByTheWhole)
{
    const runSummary s = example();
    EXPECT_EQ(value(s, "injected", "particles"), 19);
    EXPECT_EQ(value(s, "deposited on screen", "particles"), 14);
    EXPECT_DOUBLE_EQ(value(s, "deposited on screen mass", "kg"), 14e-9);
    EXPECT_EQ(value(s, "escaped through outlet", "particles"), 5);
    EXPECT_EQ(value(s, "balance closes", "-"), 1);
}

TEST(runSummary, speedAtTouch)
{
    EXPECT_DOUBLE_EQ(value(example(), "speed at touch", "m/s"), 0.02);
    EXPECT_NEAR(value(example(), "speed at touch deviation", "m/s"), 0.01, 1e-15);
    EXPECT_EQ(value(runSummary(), "speed at touch", "m/s"), 0);
}

TEST(runSummary, aggregatesInClasses)
{
    const std::string log = text(example());
    for (const char* line :
        {"of 1                                  3              3",
         "of 5 to 8                             3             18",
         "of 9 to 16                            4             36"})
        EXPECT_NE(log.find(line), std::string::npos) << line << " in" << log;
    EXPECT_EQ(log.find("of 2 "), std::string::npos);
    EXPECT_EQ(value(example(), "aggregates of 9", "-"), 4);
}

TEST(runSummary, whatIsLeftOfTheTimeIsOther)
{
    EXPECT_NE(text(example()).find("other                               3.0          30.0%"), std::string::npos) << text(example());
    EXPECT_EQ(value(example(), "time total", "s"), 10);
}

TEST(runSummary, absentWhereThereIsNone)
{
    runSummary s = example();
    EXPECT_EQ(value(s, "momentum imbalance", "-"), -1);
    EXPECT_EQ(value(s, "smallest margin", "-"), -1);
    EXPECT_EQ(value(s, "fewest steps per contact", "-"), -1);
    EXPECT_NE(text(s).find("contact period -,"), std::string::npos);
    s.imbalance = 2e-16;
    s.smallestMargin = 80;
    s.work.minStepsPerContact = 34;
    EXPECT_EQ(value(s, "momentum imbalance", "-"), 2e-16);
    EXPECT_EQ(value(s, "smallest margin", "-"), 80);
    EXPECT_EQ(value(s, "fewest steps per contact", "-"), 34);
}

TEST(runSummary, file)
{
    const runSummary s = example();
    s.write("summary.csv");
    std::ifstream file("summary.csv");
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "quantity,value,unit");
    std::size_t n = 0;
    for (; std::getline(file, line); ++n)
    {
        const auto r = s.rows()[n];
        std::ostringstream expected;
        expected << r.quantity << ',';
        EXPECT_EQ(line.rfind(expected.str(), 0), 0u) << line;
        EXPECT_NEAR(std::stod(line.substr(expected.str().size())), r.value, 1e-9*std::abs(r.value)) << line;
    }
    EXPECT_EQ(n, s.rows().size());

    FatalError.throwExceptions();
    EXPECT_ANY_THROW(s.write("summary.csv/summary.csv"));
}
