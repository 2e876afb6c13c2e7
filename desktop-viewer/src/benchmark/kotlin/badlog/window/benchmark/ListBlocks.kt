package badlog.window.benchmark

import badlog.catalog.folder.LogEntry
import badlog.core.analysis.Series
import badlog.core.analysis.statistics
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.files.LogFile
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.catalog.Verdict
import badlog.viewer.shown.folder.LogColumn
import badlog.window.folder.LogTable
import badlog.window.folder.ShownLogs
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import java.nio.file.Path
import kotlin.math.sin

/** Returns the longest blocks of the window's thread while a person searches, sorts and scrolls 1,000 logs. */
internal fun measureListBlocks(picture: Path): List<FrameTimes> = OffScreenWindow { viewer ->
    ViewerTheme(Theme.LIGHT) { LogTable(viewer.library, viewer.settings, ShownLogs(null, emptyList()), viewer.logActions) }
}.use { window ->
    val library = window.viewer.library
    window.measure({ library.change { withEntries(List(LOGS, ::entry)) } }) { library.state.visible.size == LOGS }
    window.save(picture)

    fun longest(change: () -> Unit): Double {
        window.measure(change) { true }
        return window.longestBlock
    }
    val rounds = List(ROUNDS + 1) {
        val typing = "browned".indices.map { end -> longest { library.change { filtered("browned".take(end + 1)) } } }
        val erasing = longest { library.change { filtered("") } }
        val sorting = listOf(LogColumn.MATCH, LogColumn.BATTERY, LogColumn.FILE, LogColumn.DATE).map { column ->
            longest { library.change { sorted(column) } }
        }
        val scrolling = List(PAGES) {
            longest { library.state.stepped(PAGE)?.let { library.select(it.file) } }
        }
        library.state.visible.firstOrNull()?.let { longest { library.select(it.file) } }
        listOf("a letter typed" to typing.max(), "the word erased" to erasing, "sorted" to sorting.max(), "a page down" to scrolling.max())
    }
    rounds[0].indices.map { i -> FrameTimes(rounds[0][i].first, rounds.drop(1).map { it[i].second }) }
}

private fun entry(number: Int): LogEntry {
    val second = FIRST_DAY + number / 40 * 86_400L + number % 40 * 600L
    val match = MatchOfLog("Mill Creek Regional", "Qualification", "${1 + number % 40}")
    val series = Series(DoubleArray(500) { it * 0.3 }, DoubleArray(500) { 11 + sin(it * 0.05 + number) })
    val statistics = series.statistics()
    val volts = TopicSummary("Volts", "V", TopicKind.NUMERIC, statistics, PreviewLine.of(series, statistics.min, statistics.max))
    val rules = listOf(FoundRule("Browned out", Severity.ERROR)).filter { number % 5 == 0 }
    val verdict = Verdict(Severity.ERROR, "Browned out at 1:33", listOf("The robot browned out.")).takeIf { rules.isNotEmpty() }
    return LogEntry(
        LogFile(Path.of("FRC_log_$number.bag").toAbsolutePath(), 100_000, second * 1000),
        LogSummary(
            match,
            LogDate(second, DateSource.VALUES),
            duration = 150.0,
            xUnit = "s",
            content = Content.SOMETHING,
            battery = BatteryUse(topic = "Volts", lowest = statistics.min),
            topics = listOf(volts),
        ),
        FindingSummary(0, rules, verdict),
    )
}

private const val LOGS = 1000
private const val PAGE = 15
private const val PAGES = 10
private const val ROUNDS = 3

/** 15 March 2024, 9:00, in s since 1970. */
private const val FIRST_DAY = 1_710_493_200L
