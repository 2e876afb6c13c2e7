package badlog.viewer.draw.path

import badlog.core.recording.Topic
import badlog.signals.pose.ANGLES
import badlog.signals.pose.LENGTHS
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf

/**
 * Returns the swerve modules whose speeds and angles are separate [topics], such as `Chassis/FrontLeft/Speed` and
 * `Chassis/FrontLeft/Angle`: one topic for each of the four corners, with a unit of speed or angle, or a struct. The corner is given by
 * words or their first letters (`FL`), or by the number of a module, 0 to 3. Apart from that and from the words for speed or angle, the
 * names must be the same.
 */
internal fun separateModulesOf(topics: List<Topic>): List<SwerveModules> {
    val present = topics.filter { it.samples.isNotEmpty() }
    val speeds = present.mapNotNull { topic -> speedOf(topic)?.let { partOf(topic, it, SPEED_WORDS) } }.groupBy { it.key }
    val angles = present.mapNotNull { topic -> angleOf(topic)?.let { partOf(topic, it, ANGLE_WORDS) } }.groupBy { it.key }
    return speeds.mapNotNull { (key, all) ->
        val speed = oneOfEach(all) ?: return@mapNotNull null
        val angle = oneOfEach(angles[key].orEmpty()) ?: return@mapNotNull null
        SwerveModules(
            speed.map { it.name },
            angle.map { it.name },
            isTarget = key.any { it in TARGET_WORDS },
            meters = speed[0].factor,
            radians = angle[0].factor,
        )
    }
}

/** A topic of the module at [corner]; [key] has the words of its name that it shares with the other corners. */
private class ModulePart(val name: String, val corner: Int, val key: List<String>, val factor: Double)

private fun oneOfEach(parts: List<ModulePart>): List<ModulePart>? {
    val corners = List(CORNERS) { corner -> parts.firstOrNull { it.corner == corner } ?: return null }
    return corners.takeIf { found -> found.all { it.factor == found[0].factor } }
}

private fun partOf(topic: Topic, factor: Double, quantity: Set<String>): ModulePart? {
    val words = wordsOf(topic.name)
    for (i in words.indices) {
        val (corner, length) = cornerAt(words, i) ?: continue
        val after = words.drop(i + length)
        // The distance that a wheel has turned is also an angle.
        if (quantity === ANGLE_WORDS && after.any { it in DRIVING }) return null
        val key = (words.take(i) + after).filter { it !in quantity && it !in DRIVING }
        return ModulePart(topic.name, corner, key, factor)
    }
    return null
}

/** Returns the corner that [words] name from [i] on, and the number of words. */
private fun cornerAt(words: List<String>, i: Int): Pair<Int, Int>? {
    val next = words.getOrNull(i + 1)
    ENDS[words[i]]?.let { end -> SIDES[next]?.let { side -> return end + side to 2 } }
    SIDES[words[i]]?.let { side -> ENDS[next]?.let { end -> return end + side to 2 } }
    if (words[i] in NUMBERED) next?.toIntOrNull()?.let { if (it in 0 until CORNERS) return it to 2 }
    return LETTERS[words[i]]?.let { it to 1 }
}

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

private val ENDS = mapOf("front" to 0, "back" to 2, "rear" to 2)
private val SIDES = mapOf<String?, Int>("left" to 0, "right" to 1)
private val LETTERS = mapOf("fl" to 0, "fr" to 1, "bl" to 2, "br" to 3, "rl" to 2, "rr" to 3)
private val NUMBERED = setOf("module", "mod")
private val DRIVING = setOf("drive", "driving", "wheel")
private val SPEED_WORDS = setOf("speed", "velocity")
private val ANGLE_WORDS =
    setOf("angle", "value", "rotation", "turn", "turning", "steer", "steering", "position", "azimuth", "heading", "direction")
