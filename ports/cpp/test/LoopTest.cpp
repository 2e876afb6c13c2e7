#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "LogFiles.h"

using badlog::BadLog;
using badlog::DataInferMode;
using badlog::LogState;

namespace {

using Lines = std::vector<std::string>;

bool Contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("each kind of topic is written as in Java") {
    badlog::Publisher publisher;
    badlog::Events events;
    const auto bag = Logged(
        [&] {
            BadLog::CreateValue("Robot", "R2");
            BadLog::CreateTopic("Time", "s", [] { return 100.02; }, {"xaxis", "hide"});
            BadLog::CreateTopic("Twin", "s", [] { return 100.02; });
            BadLog::CreateTopicLong("Long", "ul", [] { return int64_t{1234567890123}; });
            BadLog::CreateTopicBoolean("Boolean", "ul", [] { return true; });
            BadLog::CreateTopicStr("Text", "ul", [] { return " say \"hi\",\nÉté 🤖"; });
            publisher = BadLog::CreatePublisher("Published", "A", DataInferMode::LAST, {"join:X"});
            events = BadLog::CreateEvents("Events");
        },
        [&](BadLog& log) {
            events.Event("early");
            Row(log);
            publisher.Publish(2.5);
            events.Event("42");
            Row(log);
            events.Event("one");
            events.Event("two, \"three\"");
            publisher.Publish("on, off");
            Row(log);
            log.SetDoubleToStringFunction([](double) { return "0.5"; });
            publisher.Publish(1);
            Row(log);
            log.SetDoubleToStringFunction(nullptr);
            Row(log);
        });
    const std::string text = "\" say \"\"hi\"\",\nÉté 🤖\"";
    CHECK(
        bag ==
        "{\"topics\":[{\"unit\":\"s\",\"name\":\"Time\",\"attrs\":[\"xaxis\",\"hide\"]},{\"unit\":\"s\",\"name\":\"Twin\",\"attrs\":[]},"
        "{\"unit\":\"ul\",\"name\":\"Long\",\"attrs\":[]},{\"unit\":\"ul\",\"name\":\"Boolean\",\"attrs\":[]},"
        "{\"unit\":\"ul\",\"name\":\"Text\",\"attrs\":[]},{\"unit\":\"A\",\"name\":\"Published\",\"attrs\":[\"join:X\"]},"
        "{\"unit\":\"ul\",\"name\":\"Events\",\"attrs\":[\"log\"]}],\"values\":[{\"name\":\"Robot\",\"value\":\"R2\"}]}\n"
        "Time,Twin,Long,Boolean,Text,Published,Events\n"
        "100.020000,100.02,1234567890123,true," + text + ",-1.0,early\n"
        "100.020000,100.02,1234567890123,true," + text + ",2.5000,event 42\n"
        "100.020000,100.02,1234567890123,true," + text + ",\"on, off\",\"one; two, \"\"three\"\"\"\n"
        "0.5,0.5,1234567890123,true," + text + ",0.5,\n"
        "100.020000,100.02,1234567890123,true," + text + ",0.5,\n");
}

TEST_CASE("characters that titles cannot hold are replaced in both header lines") {
    for (const std::string name : {"a\nb", "a\rb", "\xED\xA0\x80", "a\xFFz"}) {
        std::string bag;
        StandardErrorOf([&] {
            bag = Logged([&] { BadLog::CreateTopic(name, "s", [] { return 1; }); }, [](BadLog& log) { Row(log); });
        });
        const std::string title = name == "a\nb" || name == "a\rb" ? "a b" : name == "a\xFFz" ? "a\uFFFDz" : "\uFFFD";
        CHECK(bag == "{\"topics\":[{\"unit\":\"s\",\"name\":\"" + title + "\",\"attrs\":[]}],\"values\":[]}\n" + title + "\n1.0000\n");
    }
}

TEST_CASE("a text becomes UTF-8 from any bytes, and keeps outer whitespace") {
    const auto bag = Logged(
        [&] {
            BadLog::CreateTopicStr("A", "ul", [] { return std::string{"a\0b\xC3(\xF0\x9F\xA4", 8}; });
            BadLog::CreateTopicStr("B", "ul", [] { return "x\u00A0"; });
            BadLog::CreateTopicStr("C", "ul", [] { return "\u3000"; });
        },
        [](BadLog& log) { Row(log); });
    CHECK(Rows(bag) == Lines{"a\uFFFDb\uFFFD(\uFFFD\uFFFD\uFFFD,\"x\u00A0\",\"\u3000\""});
}

TEST_CASE("a row of one empty text is not a blank line") {
    CHECK(Rows(Logged([] { BadLog::CreateTopicStr("A", "ul", [] { return ""; }); }, [](BadLog& log) { Row(log); })) == Lines{"\"\""});
}

TEST_CASE("an update consumes published data, and the last value counts") {
    const auto bag = Logged(
        [] {
            BadLog::CreateTopicSubscriber("Default", "ul", DataInferMode::DEFAULT);
            BadLog::CreateTopicSubscriber("Last", "ul", DataInferMode::LAST);
        },
        [](BadLog& log) {
            Row(log);
            for (const auto* name : {"Default", "Last"}) {
                BadLog::Publish(name, 1);
                BadLog::Publish(name, 2);
            }
            Row(log);
            log.Log();
            Row(log);
            BadLog::Publish("Default", "text");
            Row(log);
        });
    CHECK(Rows(bag) == Lines{"-1.0,-1.0", "2.0000,2.0000", "2.0000,2.0000", "-1.0,2.0000", "text,2.0000"});
}

TEST_CASE("a supplier that throws or returns nothing leaves a gap, is counted, reported once, and noted as an event in the log") {
    std::string bag;
    const auto messages = StandardErrorOf([&] {
        bag = Logged(
            [] {
                BadLog::CreateTopic("Good", "ul", [] { return 1; });
                BadLog::CreateTopic("Bad/Sensor", "ul", []() -> double { throw std::runtime_error{"unplugged"}; });
                BadLog::CreateTopicBoolean("Worse", "ul", []() -> bool { throw 7; });
                BadLog::CreateTopic("Nothing", "ul", [] { return std::optional<double>{}; });
                BadLog::CreateEvents("Events");
            },
            [](BadLog& log) {
                for (int i = 0; i < 3; i++) Row(log);
                CHECK(log.Counters().cellsMissed == 9);
                CHECK(log.Counters().rowsWritten == 3);
            });
    });
    const auto rows = Rows(bag);
    CHECK(Contains(rows[0], "1.0000,,,,\"The topic \"\"Bad/Sensor\"\" threw unplugged, so its cell is empty."));
    CHECK(rows[2] == "1.0000,,,,");
    CHECK(std::count(messages.begin(), messages.end(), '\n') == 3);
}

TEST_CASE("publishing to a name that does not exist is ignored, counted, and reported once for each name") {
    const auto messages = StandardErrorOf([] {
        const auto bag = Logged(
            [] {
                BadLog::CreateTopicSubscriber("Published", "ul", DataInferMode::LAST);
                BadLog::Publish("Published", 1);
            },
            [](BadLog& log) {
                BadLog::Publish("Unknown", 1);
                BadLog::Publish("Unknown", "2");
                Row(log);
                CHECK(log.Counters().callsIgnored == 2);
            });
        CHECK(Rows(bag) == Lines{"1.0000"});
    });
    CHECK(std::count(messages.begin(), messages.end(), '\n') == 1);
}

TEST_CASE("a formatter that throws leaves a gap") {
    StandardErrorOf([] {
        const auto bag = Logged(
            [] {
                BadLog::CreateTopic("One", "ul", [] { return 1; });
                BadLog::CreateTopic("Two", "ul", [] { return 2; });
            },
            [](BadLog& log) {
                log.SetDoubleToStringFunction([](double value) {
                    if (value == 1) throw std::runtime_error{"no ones"};
                    return "two";
                });
                Row(log);
            });
        CHECK(Rows(bag) == Lines{",two"});
    });
}

TEST_CASE("a formatter that logs, updates, flushes or closes in the middle of a row does not tear the row") {
    const auto messages = StandardErrorOf([] {
        int calls = 0;
        const auto bag = Logged(
            [&] {
                BadLog::CreateTopic("A", "ul", [] { return 1; });
                BadLog::CreateTopic("B", "ul", [&] { return calls; });
            },
            [&](BadLog& log) {
                log.SetDoubleToStringFunction([&](double value) {
                    log.Log();
                    log.UpdateTopics();
                    log.Flush();
                    if (++calls == 5) log.Close();
                    return std::to_string(static_cast<int>(value));
                });
                for (int i = 0; i < 3; i++) Row(log);
                CHECK(log.State() == LogState::CLOSED);
                CHECK(log.Counters().rowsWritten == 3);
            });
        CHECK(Rows(bag) == Lines{"1,0", "1,2", "1,4"});
    });
    INFO(messages);
    CHECK(Contains(messages, "Log() is ignored while a row is being written"));
}

TEST_CASE("a supplier may publish, log and update") {
    const auto bag = Logged(
        [] {
            BadLog::CreateTopicSubscriber("B", "ul", DataInferMode::DEFAULT);
            BadLog::CreateTopic("A", "ul", [] {
                BadLog::Publish("B", 2);
                return 1;
            });
        },
        [](BadLog& log) { Row(log); });
    CHECK(Rows(bag) == Lines{"2.0000,1.0000"});
}

TEST_CASE("mistakes in the setup are reported, and logging continues") {
    const Folder folder;
    const auto messages = StandardErrorOf([&] {
        const auto first = BadLog::Init(folder / "first.bag");
        CHECK(BadLog::CreateTopic("A", "ul", [] { return 1; }));
        CHECK_FALSE(BadLog::CreateTopic("A", "ul", [] { return 2; }));
        CHECK_FALSE(BadLog::CreateValue("A", ""));
        CHECK_FALSE(BadLog::CreateTopic("B", "ul", nullptr));
        CHECK(first.State() == LogState::SETTING_UP);
        first.Log();
        CHECK(first.FinishInitialization());
        CHECK_FALSE(first.FinishInitialization());
        CHECK_FALSE(BadLog::CreateTopic("Late", "ul", [] { return 1; }));
        BadLog::CreatePublisher("Later", "ul", DataInferMode::LAST).Publish(1);
        BadLog::CreateEvents("Latest").Event("nobody reads this");
        Row(first);
        const auto second = BadLog::Init(folder / "folders/are/created/second.bag");
        CHECK(first.State() == LogState::CLOSED);
        Row(first);
        second.FinishInitialization();
        second.Close();
    });
    CHECK(RowsIn(folder / "first.bag") == Lines{"1.0000"});
    CHECK(Contains(messages, "There is already a topic or value \"A\""));
    CHECK(Contains(messages, "without a supplier"));
    CHECK(Contains(messages, "the other one was closed"));
}

TEST_CASE("without flushing, rows are written together, by Flush, by Close, and after a quarter of a second") {
    const Folder folder;
    // A row that had to wait for a quarter of a second, as on a busy machine, may be written.
    for (bool isLate = true; isLate;) {
        const auto began = std::chrono::steady_clock::now();
        const auto early = BadLog::Init(folder / "early.bag", {/*flushesEachRow=*/false});
        BadLog::CreateTopic("A", "ul", [] { return 1; });
        early.FinishInitialization();
        Row(early);
        const auto written = RowsIn(folder / "early.bag").size();
        isLate = std::chrono::steady_clock::now() - began >= std::chrono::milliseconds{250};
        if (!isLate) {
            CHECK(written == 0);
        }
        early.Close();
    }
    const auto log = BadLog::Init(folder / "a.bag", {/*flushesEachRow=*/false});
    BadLog::CreateTopic("A", "ul", [] { return 1; });
    log.FinishInitialization();
    Row(log);
    log.Flush();
    CHECK(RowsIn(folder / "a.bag").size() == 1);
    Row(log);
    for (int i = 0; i < 12'000 && RowsIn(folder / "a.bag").size() == 1; i++) std::this_thread::sleep_for(std::chrono::milliseconds{10});
    CHECK(RowsIn(folder / "a.bag").size() == 2);
    Row(log);
    log.Close();
    CHECK(RowsIn(folder / "a.bag").size() == 3);
    CHECK(log.Counters().bytesWritten == static_cast<int64_t>(Read(folder / "a.bag").size()));
}

TEST_CASE("four threads publish and two log: no torn row, no lost final value") {
    constexpr int ROUNDS = 20'000;
    std::vector<badlog::Publisher> publishers;
    const auto bag = Logged(
        [&] {
            for (int i = 0; i < 4; i++) publishers.push_back(BadLog::CreatePublisher("Topic " + std::to_string(i), "ul", DataInferMode::LAST));
        },
        [&](BadLog& log) {
            std::atomic<bool> isDone{false};
            std::vector<std::thread> threads;
            for (size_t i = 0; i < 4; i++) {
                threads.emplace_back([&, i] {
                    for (int round = 1; round <= ROUNDS; round++) {
                        if (i % 2 == 0) {
                            publishers[i].Publish(round);
                        } else {
                            BadLog::Publish("Topic " + std::to_string(i), "text " + std::to_string(round) + ", \"of it\"");
                        }
                    }
                });
            }
            std::vector<std::thread> loggers;
            for (int i = 0; i < 2; i++) {
                loggers.emplace_back([&] {
                    while (!isDone) Row(log);
                });
            }
            for (auto& thread : threads) thread.join();
            isDone = true;
            for (auto& thread : loggers) thread.join();
            Row(log);
            CHECK(log.Counters().rowsMissed == 0);
            CHECK(log.Counters().callsIgnored == 0);
        });
    const auto rows = Rows(bag);
    const auto last = "text " + std::to_string(ROUNDS) + ", \"\"of it\"\"";
    CHECK(rows.back() == "20000,\"" + last + "\",20000,\"" + last + "\"");
    for (const auto& row : rows) REQUIRE(std::count(row.begin(), row.end(), ',') >= 3);
}
