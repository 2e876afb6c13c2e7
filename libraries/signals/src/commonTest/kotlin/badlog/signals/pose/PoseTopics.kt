package badlog.signals.pose

import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic

/** A topic called [name] with a [unit] and a [type]; its [samples] are times and numbers. */
internal fun poseTopic(
    name: String,
    unit: String = "",
    type: String = "",
    samples: List<Pair<Double, Double>> = listOf(0.0 to 1.0, 1.0 to 2.0),
): Topic = Topic(
    name,
    unit,
    emptyList(),
    samples.map { it.second }.toDoubleArray(),
    TextColumn.EMPTY,
    CellCounts(samples.size, 0, 0, 0, 0, 0),
    samples.map { it.first }.toDoubleArray(),
    type,
)

/** The topics of a struct Pose2d called [name]. */
internal fun poseTopics(name: String, type: String = "struct:Pose2d"): List<Topic> = listOf("translation/x", "translation/y", "rotation/value").map { poseTopic("$name/$it", type = type) }
