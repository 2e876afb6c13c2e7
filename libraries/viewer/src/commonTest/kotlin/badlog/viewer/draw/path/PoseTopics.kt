package badlog.viewer.draw.path

import badlog.core.recording.Topic
import badlog.viewer.timedTopic

/** A topic called [name] with a few numbers, of a [unit] and a [type]. */
internal fun poseTopic(name: String, unit: String = "", type: String = ""): Topic = timedTopic(name, 0.0 to 1.0, 1.0 to 2.0).copy(unit = unit, type = type)

/** The topics of a struct Pose2d called [name]. */
internal fun poseTopics(name: String, type: String = "struct:Pose2d"): List<Topic> = listOf("translation/x", "translation/y", "rotation/value").map { poseTopic("$name/$it", type = type) }
