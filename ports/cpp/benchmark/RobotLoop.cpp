#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "badlog/BadLog.h"

#if defined(BADLOG_WPILIB)
#include <wpi/DataLogBackgroundWriter.h>
#endif

namespace {

constexpr size_t QUERIED = 40;
constexpr size_t PUBLISHED = 10;
constexpr int LOOPS = 1'000;
constexpr int ROUNDS = 15;

/** The numbers of a robot, the same as in badlog's benchmark for Java. */
class Signals {
public:
    Signals() {
        for (size_t i = 0; i < m_table.size(); i++) {
            m_table[i] = std::sin(static_cast<double>(i) * 0.37) * std::pow(10, static_cast<int>(i % 7) - 2);
        }
    }
    void Next() { m_loop++; }
    double Signal(size_t number) const { return m_table[(m_loop + number * 61) % m_table.size()]; }

private:
    std::array<double, 4096> m_table{};
    size_t m_loop = 0;
};

/** Returns a folder in memory, if there is such a disk, so that the log is measured, not the disk. */
std::filesystem::path Folder() {
    return std::filesystem::exists("/dev/shm") ? std::filesystem::path{"/dev/shm"} : std::filesystem::temp_directory_path();
}

/** Returns the time of this thread in microseconds. The time of other programs and threads does not count. */
double ThreadTime() {
#if defined(CLOCK_THREAD_CPUTIME_ID)
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
#else
    return std::chrono::duration<double, std::micro>{std::chrono::steady_clock::now().time_since_epoch()}.count();
#endif
}

/** Returns the median time of a loop over some rounds, in microseconds; `rest` is called after each round. */
template <typename Loop, typename Rest>
double Microseconds(Loop loop, Rest rest) {
    std::vector<double> rounds;
    for (int round = 0; round < ROUNDS; round++) {
        const auto began = ThreadTime();
        for (int i = 0; i < LOOPS; i++) loop();
        rounds.push_back((ThreadTime() - began) / LOOPS);
        rest();
    }
    std::sort(rounds.begin(), rounds.end());
    return rounds[rounds.size() / 2];
}

double Badlog() {
    using badlog::BadLog;
    Signals signals;
    const auto path = Folder() / "badlog-benchmark.bag";
    const auto log = BadLog::Init(path.string());
    for (size_t i = 0; i < QUERIED; i++) BadLog::CreateTopic("Queried/" + std::to_string(i), "V", [&, i] { return signals.Signal(i); });
    std::vector<badlog::Publisher> publishers;
    for (size_t i = 0; i < PUBLISHED; i++) {
        publishers.push_back(BadLog::CreatePublisher("Published/" + std::to_string(i), "V", badlog::DataInferMode::DEFAULT));
    }
    log.FinishInitialization();
    const auto microseconds = Microseconds([&] {
        signals.Next();
        for (size_t i = 0; i < PUBLISHED; i++) publishers[i].Publish(signals.Signal(QUERIED + i));
        log.UpdateTopics();
        log.Log();
    }, [] {});
    log.Close();
    std::filesystem::remove(path);
    return microseconds;
}

#if defined(BADLOG_WPILIB)
/** Measures WPILib's log as teams use it. It has an entry for each number, and one append each; the log writes in its own thread. */
double WpilibDataLog() {
    Signals signals;
    wpi::log::DataLogBackgroundWriter log{Folder().string(), "badlog-benchmark.wpilog"};
    std::vector<wpi::log::DoubleLogEntry> entries;
    for (size_t i = 0; i < QUERIED + PUBLISHED; i++) entries.emplace_back(log, "Topic/" + std::to_string(i));
    const auto microseconds = Microseconds([&] {
        signals.Next();
        for (size_t i = 0; i < entries.size(); i++) entries[i].Append(signals.Signal(i));
    }, [&] {
        // Otherwise it would drop the entries that do not fit into memory, and dropping costs nothing.
        log.Flush();
        std::this_thread::sleep_for(std::chrono::milliseconds{200});
    });
    log.Stop();
    std::filesystem::remove(Folder() / "badlog-benchmark.wpilog");
    return microseconds;
}
#endif

}  // namespace

int main() {
    std::printf("One loop, in time of its thread: %zu numbers published, %zu asked for, a row of %zu written.\n", PUBLISHED, QUERIED, QUERIED + PUBLISHED);
    std::printf("badlog for C++: %.2f us\n", Badlog());
#if defined(BADLOG_WPILIB)
    std::printf("WPILib's DataLog, %zu entries: %.2f us\n", QUERIED + PUBLISHED, WpilibDataLog());
#endif
    return 0;
}
