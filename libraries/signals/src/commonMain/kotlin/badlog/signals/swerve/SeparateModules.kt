package badlog.signals.swerve

import badlog.core.recording.Topic
import badlog.signals.pose.ANGLES
import badlog.signals.pose.LENGTHS
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/**
 * Returns the swerve modules with speeds and angles in separate [topics], such as `Chassis/FrontLeft/Speed` and `Chassis/FrontLeft/Angle`. Each
 * module has one topic, with a unit of speed or angle, or a struct. A module is given by words or their first letters (`FL`), for at least three of
 * the four corners, or by its number, from 0 on. Apart from that and from the words for speed or angle, the names must be the same.
 */
internal fun separateModulesOf(topics: List<Topic>): List<SwerveModules> {
    val present = topics.filter { it.samples.isNotEmpty() }
    val speeds = present.mapNotNull { topic -> speedOf(topic)?.let { partOf(topic, it, SPEED_WORDS) } }.groupBy { it.key }
    val angles = present.mapNotNull { topic -> angleOf(topic)?.let { partOf(topic, it, ANGLE_WORDS) } }.groupBy { it.key }
    return speeds.mapNotNull { (key, all) -> modulesOf(key, all, angles[key].orEmpty()) }
}

private fun modulesOf(key: List<String>, speeds: List<ModulePart>, angles: List<ModulePart>): SwerveModules? {
    val speed = speeds.distinctBy { it.corner }.associateBy { it.corner }
    val angle = angles.distinctBy { it.corner }.associateBy { it.corner }
    // Logs may lack a module that has a wrong name.
    val found = (0 until MAX_MODULES).filter { it in speed && it in angle }
    val isNumbered = found.any { speed.getValue(it).isNumbered }
    if (found.size < MIN_MODULES || (isNumbered && found.last() >= found.size)) return null
    val speedParts = found.map(speed::getValue)
    val angleParts = found.map(angle::getValue)
    if ((speedParts.map { it.factor }.distinct() + angleParts.map { it.factor }.distinct()).size > 2) return null
    return SwerveModules(
        found.map { if (isNumbered) numberedLabel(it) else LABELS[it] },
        found.takeUnless { isNumbered },
        speedParts.map { it.name },
        angleParts.map { it.name },
        isTarget = key.any { it in TARGET_WORDS },
        meters = speedParts[0].factor,
        radians = angleParts[0].factor,
    )
}

/**
 * A topic of the module at [corner], or of the one with that number. [key] has the words of its name that it shares with the other modules.
 */
private class ModulePart(val name: String, val corner: Int, val isNumbered: Boolean, val key: List<String>, val factor: Double)

private fun partOf(topic: Topic, factor: Double, quantity: Set<String>): ModulePart? {
    val words = wordsOf(topic.name)
    for (i in words.indices) {
        val number = numberAt(words, i)
        val (corner, length) = number?.let { it to 2 } ?: cornerAt(words, i) ?: continue
        val after = words.drop(i + length)
        // The distance that a wheel has turned is also an angle.
        if (quantity === ANGLE_WORDS && after.any { it in DRIVING }) return null
        val key = (words.take(i) + after).filter { it !in quantity && it !in DRIVING }
        return ModulePart(topic.name, corner, isNumbered = number != null, key, factor)
    }
    return null
}

/** Returns the number of the module that [words] name from [i] on. */
private fun numberAt(words: List<String>, i: Int): Int? =
    if (words[i] in NUMBERED) words.getOrNull(i + 1)?.toIntOrNull()?.takeIf { it in 0 until MAX_MODULES } else null

/** Returns the corner that [words] name from [i] on, and the number of words. */
private fun cornerAt(words: List<String>, i: Int): Pair<Int, Int>? {
    val next = words.getOrNull(i + 1)
    ENDS[words[i]]?.let { end -> sideOf(next)?.let { side -> return end + side to 2 } }
    sideOf(words[i])?.let { side -> ENDS[next]?.let { end -> return end + side to 2 } }
    return LETTERS[words[i]]?.let { it to 1 }
}

/** Returns the corner that [words] name: 0 for the front left one, then front right, back left, back right. Null if they name none. */
internal fun cornerOf(words: List<String>): Int? = words.indices.firstNotNullOfOrNull { cornerAt(words, it)?.first }

/** Returns [words] without those for a corner. */
internal fun withoutCorner(words: List<String>): List<String> {
    val at = words.indices.firstOrNull { cornerAt(words, it) != null } ?: return words
    return words.take(at) + words.drop(at + (cornerAt(words, at)?.second ?: 0))
}

/** Returns the name of [corner] for people. */
internal fun labelOfCorner(corner: Int): String = LABELS[corner]

/** Returns the side that [word] names, 0 for left and 1 for right; logs also have `Rightt` and `LeftSide`. */
private fun sideOf(word: String?): Int? = SIDES.indexOfFirst { word?.startsWith(it) == true }.takeIf { it >= 0 }

private fun speedOf(topic: Topic): Double? = when {
    !topic.type.startsWith("struct:") -> LENGTHS[topic.unit.removeSuffix("/s")]?.takeIf { topic.unit.endsWith("/s") }
    "SwerveModule" in topic.type && (topic.name.endsWith("/speed") || topic.name.endsWith("/velocity")) -> 1.0
    else -> null
}

private fun angleOf(topic: Topic): Double? = when {
    !topic.type.startsWith("struct:") -> ANGLES[topic.unit]
    "SwerveModule" in topic.type && topic.name.endsWith("/angle/value") -> 1.0
    else -> null
}

private val LABELS = listOf("Front Left", "Front Right", "Back Left", "Back Right")
private val ENDS = mapOf("front" to 0, "back" to 2, "rear" to 2)
private val SIDES = listOf("left", "right")
private val LETTERS = mapOf("fl" to 0, "fr" to 1, "bl" to 2, "br" to 3, "rl" to 2, "rr" to 3)
private val NUMBERED = setOf("module", "mod")
private val DRIVING = setOf("drive", "driving", "wheel")
private val SPEED_WORDS = setOf("speed", "velocity")
private val ANGLE_WORDS =
    setOf("angle", "value", "rotation", "turn", "turning", "steer", "steering", "position", "azimuth", "heading", "direction")
