#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "LogFiles.h"

// The robot of docs/robot-cpp.md, whose main CMakeLists.txt renames, and whose folder it replaces by "guide".
int RunGuideRobot();

TEST_CASE("the guide's robot logs, each start into a file of its own") {
    const auto before = std::filesystem::current_path();
    const Folder folder;
    std::filesystem::current_path(folder / ".");
    CHECK(RunGuideRobot() == 0);
    CHECK(RunGuideRobot() == 0);
    std::filesystem::current_path(before);
    const auto rows = RowsIn(folder / "guide/robot.bag");
    REQUIRE(rows.size() == 3);
    CHECK(rows[0] == "1.500000,1.5000,false,45.000,arm leaves home");
    CHECK(rows[2] == "1.500000,4.5000,false,45.000,");
    CHECK(Read(folder / "guide/robot_2.bag") == Read(folder / "guide/robot.bag"));
}
