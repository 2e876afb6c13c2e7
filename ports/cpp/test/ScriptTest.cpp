#include <doctest/doctest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "LogFiles.h"

using badlog::BadLog;
using badlog::DataInferMode;

namespace {

const double NUMBERS[] = {
    0, -0.0, 1, -1, 12.3456789, 99999.5, 99999.4, 100000, 1e-4, 9.9999e-5, 2.00005, 1e10, -1e300, 5e-324, 0.02, 13,
    std::numeric_limits<double>::max(), std::nan(""), HUGE_VAL, -HUGE_VAL, 0.1 + 0.2, 1.0 / 3, 12.125,
};

double NumberOf(int loop, int offset) {
    return NUMBERS[static_cast<size_t>(loop + offset) % std::size(NUMBERS)];
}

/** Java's Math.round. */
int64_t JavaRound(double value) {
    if (std::isnan(value)) return 0;
    const double rounded = std::floor(value + 0.5);
    if (rounded >= 9223372036854775808.0) return std::numeric_limits<int64_t>::max();
    return rounded <= -9223372036854775808.0 ? std::numeric_limits<int64_t>::min() : static_cast<int64_t>(rounded);
}

}  // namespace

// The same calls as in jvm-robot's RecordedScript.java; the original badlog made the recording.
TEST_CASE("a recorded script of calls writes the same bytes as with the original and in Java") {
    const Folder folder;
    int loop = 0;
    const auto log = BadLog::Init(folder / "script.bag", {/*flushesEachRow=*/false});
    BadLog::CreateValue("Match Number", "8");
    BadLog::CreateValue("Drivetrain/P", "0.25");
    BadLog::CreateValue("Quote", "the \"best\" robot, \\o/");
    BadLog::CreateValue("Empty", "");
    BadLog::CreateValue("Control", "\b\f\n\r\t\x01\x7f\u0085\u00a0\u2028\u20ac\u00fc");
    BadLog::CreateTopic(
        "Drivetrain/Left/Output", "V", [&] { return NumberOf(loop, 0); }, {"join:Drivetrain/Output", "hide"});
    BadLog::CreateTopic(
        "Drivetrain/Right/Output", "V", [&] { return NumberOf(loop, 11); }, {"join:Drivetrain/Output", "hide"});
    BadLog::CreateTopic("Count", BadLog::UNITLESS, [&] { return loop; });
    BadLog::CreateTopic(
        "Block", "A",
        [&] {
            double sum = 0;
            for (int i = 0; i < 5; i++) sum += NumberOf(loop, i);
            return sum;
        },
        {"delta", "area"});
    BadLog::CreateTopicStr("State", "ul", [&] { return loop % 3 == 0 ? "idle" : "moving, fast"; }, {"log"});
    BadLog::CreateTopicStr("Nothing", "ul", [] { return ""; });
    BadLog::CreateTopicSubscriber("Default", "°", DataInferMode::DEFAULT);
    BadLog::CreateTopicSubscriber("Last", "Ω", DataInferMode::LAST, {"integrate"});
    BadLog::CreateTopicSubscriber("Text", "ul", DataInferMode::LAST);
    log.FinishInitialization();
    for (; loop < 200; loop++) {
        if (loop == 121) {
            log.SetDoubleToStringFunction([](double value) { return "<" + std::to_string(JavaRound(value)) + ">"; });
        }
        if (loop % 2 == 1) BadLog::Publish("Default", NumberOf(loop, 7));
        if (loop % 5 == 2) {
            BadLog::Publish("Last", -1);
            BadLog::Publish("Last", NumberOf(loop, 3));
        }
        if (loop % 7 == 3) BadLog::Publish("Text", "at " + std::to_string(loop) + ", ready");
        log.UpdateTopics();
        if (loop % 4 != 3) log.Log();
    }
    log.Flush();
    const bool isSame = Read(folder / "script.bag") == Read(BADLOG_ROOT "/jvm-robot/src/test/resources/recorded-script.bag");
    CHECK(isSame);
    log.Close();
}
