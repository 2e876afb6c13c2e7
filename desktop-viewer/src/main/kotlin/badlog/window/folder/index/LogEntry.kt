package badlog.window.folder.index

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.files.LogFile
import java.nio.file.Path

/**
 * What the library knows about a file without reading it again.
 *
 * @property source the file when it was read.
 * @property match its match.
 * @property date when it began.
 * @property duration its length on x; null if x is only the number of the row.
 * @property xUnit the unit of [duration].
 * @property samples the number of samples of all its topics together.
 * @property problems the number of its problems.
 * @property content whether there is anything to see.
 * @property trouble why it cannot be read, as a sentence; null if it can.
 * @property batteryMinimum the lowest voltage of the robot's battery, in volts; null if no topic shows it.
 * @property batteryTopic the name of that topic.
 * @property topics its topics with numbers, in the order of the file.
 * @property found what the rules found in it; null while they have not been run.
 */
internal data class LogEntry(
    val source: LogFile,
    val match: MatchFacts = MatchFacts(),
    val date: LogDate,
    val duration: Double? = null,
    val xUnit: String = "",
    val samples: Long = 0,
    val problems: ProblemCounts = ProblemCounts(),
    val content: Content = Content.UNREADABLE,
    val trouble: String? = null,
    val batteryMinimum: Double? = null,
    val batteryTopic: String? = null,
    val topics: List<TopicSummary> = emptyList(),
    val found: LogFound? = null,
) {
    /** The file; absolute. */
    val file: Path get() = source.path

    /** The file's name without its folders. */
    val fileName: String get() = source.name

    /** Its name for people: the match, or else the name of the file. */
    val title: String get() = match.match ?: fileName

    /** Whether it can be opened. */
    val isReadable: Boolean get() = trouble == null

    /** Whether there is nothing to see in it. */
    val isGray: Boolean get() = content != Content.SOMETHING

    /** Returns the summary of the topic called [name], or null when the log has none. */
    fun topic(name: String): TopicSummary? = topics.firstOrNull { it.name == name }
}

/** The number of kinds of problems of each severity in a recording. */
internal data class ProblemCounts(val errors: Int = 0, val warnings: Int = 0, val notes: Int = 0) {
    /** Returns the number for [severity]. */
    fun of(severity: Severity): Int = when (severity) {
        Severity.ERROR -> errors
        Severity.WARNING -> warnings
        Severity.NOTE -> notes
    }
}

/**
 * What is stored about a topic with numbers, without its samples.
 *
 * @property name the full name.
 * @property unit the unit, `ul` for none.
 * @property statistics over all of the recording.
 * @property preview its course.
 */
internal data class TopicSummary(
    val name: String,
    val unit: String,
    val kind: TopicKind,
    val statistics: SeriesStatistics,
    val preview: PreviewLine,
)
