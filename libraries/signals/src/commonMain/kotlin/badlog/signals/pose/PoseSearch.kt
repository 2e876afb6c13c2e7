package badlog.signals.pose

import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf
import kotlin.math.PI

/**
 * Returns the poses in [topics], in order:
 *
 * - the structs `Pose2d`, `Pose3d` and `Translation2d` of WPILib, and arrays of them;
 * - three numbers x, y and degrees, as from a `Field2d`, in an array with the name of a pose; for a Limelight, `botpose_wpiblue`;
 * - two topics in a unit of length with names that end in X and Y, and a third one for the heading: `Drive/Pose X`, `… Y`, `… Heading`.
 *
 * Needs no samples.
 */
fun posesOf(topics: List<Topic>): List<Pose> = PoseSearch(topics).poses

private class PoseSearch(topics: List<Topic>) {
    private val byName = topics.filter { it.kind == TopicKind.NUMERIC }.associateBy { it.name }
    private val byWords = HashMap<String, Topic>()

    init {
        for (topic in byName.values) if (topic.unit in ANGLES) byWords.getOrPut(wordsOf(topic.name).joinToString(" ")) { topic }
    }

    val poses: List<Pose> = byName.values.mapNotNull { topic ->
        when {
            topic.name.endsWith(FIELD_X) -> structPose(topic)
            topic.name.endsWith(FIRST) -> arrayPose(topic)
            else -> namedPose(topic)
        }
    }

    private fun structPose(topic: Topic): Pose? {
        val fields = topic.name.removeSuffix(FIELD_X)
        val base = fields.removeSuffix("/translation")
        val isStruct = topic.type.startsWith(STRUCT)
        // A transform is a movement, not a place; and a quaternion also has an x.
        if (isStruct && !topic.type.startsWith(if (base == fields) "${STRUCT}Translation" else "${STRUCT}Pose")) return null
        if (base == fields && !isStruct) return namedPose(topic)
        val angle = "$base/rotation/value"
        val heading = if (angle in byName) listOf(angle) else QUATERNION.map { "$base/rotation/q/$it" }.filter { it in byName }
        return pose(base, topic, "$fields/y", heading, 1.0, 1.0)
    }

    private fun arrayPose(topic: Topic): Pose? {
        val base = topic.name.removeSuffix(FIRST)
        val isBotPose = BOT_POSES.any { base.endsWith(it, ignoreCase = true) }
        val isPose = isBotPose || ("$base[2]" in byName && "$base[3]" !in byName && wordsOf(base).any { it in POSE_WORDS })
        if (!isPose) return null
        val radians = if (base.contains("PathPlanner/")) 1.0 else DEGREE
        return pose(base, topic, "$base[1]", listOf(if (isBotPose) "$base[5]" else "$base[2]").filter { it in byName }, 1.0, radians)
    }

    private fun namedPose(topic: Topic): Pose? {
        val meters = LENGTHS[topic.unit] ?: return null
        val words = wordsOf(topic.name)
        if (words.lastOrNull() != "x") return null
        val at = topic.name.indexOfLast { it == 'x' || it == 'X' }
        val y = topic.name.replaceRange(at, at + 1, if (topic.name[at] == 'x') "y" else "Y")
        if (byName[y]?.unit != topic.unit) return null
        val before = words.dropLast(1).joinToString(" ")
        val heading = HEADINGS.firstNotNullOfOrNull { byWords["$before $it"] }
        val base = topic.name.take(at).trimEnd('/', ' ', '_', '-', '.')
        return pose(base, topic, y, listOfNotNull(heading?.name), meters, ANGLES[heading?.unit] ?: 1.0)
    }

    private fun pose(base: String, x: Topic, y: String, heading: List<String>, meters: Double, radians: Double): Pose? {
        if (y !in byName) return null
        val list = base.takeIf { it.endsWith(']') }?.substringBeforeLast('[')
        return Pose(
            base,
            x.name,
            y,
            heading.takeIf { it.size != 2 && it.size != 3 }.orEmpty(),
            meters,
            radians,
            roleOf(base, list != null),
            list,
        )
    }

    private fun roleOf(base: String, isList: Boolean): PoseRole {
        val words = wordsOf(base)
        return when {
            words.any { it in SEEN_WORDS } -> PoseRole.SEEN
            words.any { it in TARGET_WORDS || it in PLAN_WORDS } || isList -> PoseRole.PLANNED
            else -> PoseRole.DRIVEN
        }
    }
}

private const val FIELD_X = "/x"
private const val FIRST = "[0]"
private const val STRUCT = "struct:"
private const val DEGREE = PI / 180
private val QUATERNION = listOf("w", "x", "y", "z")
private val BOT_POSES = listOf("botpose_wpiblue", "botpose_orb_wpiblue")

/** Units of length in meters. */
val LENGTHS: Map<String, Double> =
    mapOf("m" to 1.0, "meters" to 1.0, "cm" to 0.01, "in" to 0.0254, "inches" to 0.0254, "ft" to 0.3048, "feet" to 0.3048)

/** Units of angle in radians. */
val ANGLES: Map<String, Double> = mapOf("deg" to DEGREE, "°" to DEGREE, "degrees" to DEGREE, "rad" to 1.0, "radians" to 1.0)
private val HEADINGS = listOf("heading", "rotation", "angle", "theta", "yaw")
private val POSE_WORDS = setOf("pose", "field", "odometry", "botpose")
private val PLAN_WORDS = setOf("trajectory", "plan", "planned", "auto", "autonomous")
private val SEEN_WORDS =
    setOf("vision", "camera", "limelight", "photon", "photonvision", "tag", "tags", "apriltag", "apriltags", "botpose", "seen")
