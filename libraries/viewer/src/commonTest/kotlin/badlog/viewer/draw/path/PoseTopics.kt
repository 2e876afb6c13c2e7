package badlog.viewer.draw.path

import badlog.core.recording.Topic
import badlog.viewer.timedTopic
import kotlin.math.PI

/** A topic called [name] with a few numbers, of a [unit] and a [type]. */
internal fun poseTopic(name: String, unit: String = "", type: String = ""): Topic = timedTopic(name, 0.0 to 1.0, 1.0 to 2.0).copy(unit = unit, type = type)

/** The topics of a struct Pose2d called [name]. */
internal fun poseTopics(name: String, type: String = "struct:Pose2d"): List<Topic> = listOf("translation/x", "translation/y", "rotation/value").map { poseTopic("$name/$it", type = type) }

/** The topics of a struct Pose2d called [name], which faces up the field. Each of [places] is a time, an x and a y. */
internal fun pathTopics(name: String, vararg places: Triple<Double, Double, Double>): List<Topic> = listOf(
    timedTopic("$name/translation/x", *places.map { it.first to it.second }.toTypedArray()),
    timedTopic("$name/translation/y", *places.map { it.first to it.third }.toTypedArray()),
    timedTopic("$name/rotation/value", *places.map { it.first to PI / 2 }.toTypedArray()),
).map { it.copy(type = "struct:Pose2d", unit = "") }
