package badlog.formats.column

import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Topic
import badlog.core.recording.addNotFinite
import badlog.core.recording.addNotUtf8
import badlog.core.recording.addRounded
import badlog.core.recording.timesText

/** Reports the oddities of [topic], which was made from [column] and [timestamps]. */
internal fun reportTopic(topic: Topic, column: SampleColumn, timestamps: Timestamps, problems: ProblemList) {
    val name = topic.name
    if (timestamps.disorder > 0) {
        problems.add(
            ProblemKind.TIMES_SORTED,
            "“$name” goes back in time${timesText(timestamps.disorder)}; its samples were sorted.",
            topic = name,
            count = timestamps.disorder,
        )
    }
    if (column.sawOtherText) problems.addNotUtf8(name)
    if (column.roundedCount > 0) problems.addRounded(name, column.roundedCount)
    problems.addNotFinite(topic, "samples")
}
