#include <doctest/doctest.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

#include "LogFiles.h"
#include "SystemPath.h"

// The programs of docs/robot-cpp.md. CMakeLists.txt renames their main functions, and replaces the robot's folder by
// "guide".
int RunGuideRobot();
int RunGuideReader(int, char** arguments);

TEST_CASE("the guide's robot logs to a new file at each start") {
    const auto before = std::filesystem::current_path();
    const Folder folder;
    std::filesystem::current_path(badlog::SystemPath(folder / "."));
    CHECK(RunGuideRobot() == 0);
    CHECK(RunGuideRobot() == 0);
    std::filesystem::current_path(before);
    // The robot never closes its log, like real robots.
    StandardErrorOf([&] { badlog::BadLog::Init(folder / "last.bag").Close(); });
    const auto rows = RowsIn(folder / "guide/robot.bag");
    REQUIRE(rows.size() == 3);
    CHECK(rows[0] == "1.500000,1.5000,false,45.000,arm leaves home");
    CHECK(rows[2] == "1.500000,4.5000,false,45.000,");
    CHECK(Read(folder / "guide/robot_2.bag") == Read(folder / "guide/robot.bag"));
}

TEST_CASE("the guide's reader prints the content of a bag") {
    std::string program = "reader";
    std::string path = BADLOG_ROOT "/core/conformance/cut-row.bag";
    char* arguments[] = {program.data(), path.data()};
    std::ostringstream output;
    auto* const before = std::cout.rdbuf(output.rdbuf());
    CHECK(RunGuideReader(2, arguments) == 0);
    std::cout.rdbuf(before);
    CHECK(output.str().find(" numbers in s\n") != std::string::npos);
    CHECK(output.str().find("A row is cut off after") != std::string::npos);
}
