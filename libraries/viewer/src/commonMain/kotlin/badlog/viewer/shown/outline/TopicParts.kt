package badlog.viewer.shown.outline

import badlog.core.analysis.GraphSeries
import badlog.core.recording.PathName
import badlog.core.recording.Topic

/**
 * Returns the name of the graph that the part [topic] of an array or struct belongs to. It is the topic's own name if it is not a part:
 *
 * - The elements of an array share one graph: `axes[0]` and `axes[1]` become `axes`. The same applies to the topics of a folder with
 *   numbers as their names.
 * - The fields of a struct share one: x, y and angle of a pose, three speeds of a chassis.
 * - The same field of all swerve modules of a folder shares one: their speeds, their angles, their distances.
 */
internal fun graphNameOf(topic: Topic): String {
    val name = topic.name
    if (STRUCTS.none { topic.type.startsWith(it) }) return arrayOf(name) ?: name
    val fields = fieldsOf(name)
    val owner = name.dropLast(fields.length)
    if ("module" in topic.type.lowercase()) {
        val folder = PathName.folderOf(arrayOf(owner) ?: owner)
        val meaning = MEANINGS.firstOrNull { (field, _) -> fields.startsWith(field) }?.second
        if (meaning != null) return if (folder.isEmpty()) meaning else "$folder/$meaning"
    }
    return owner
}

/** Returns the array with the element [name], or null. */
private fun arrayOf(name: String): String? {
    val bracket = name.lastIndexOf('[')
    if (bracket >= 0 && name.endsWith(']') && isNumber(name.substring(bracket + 1, name.lastIndex))) return name.substring(0, bracket)
    return PathName.folderOf(name).takeIf { it.isNotEmpty() && isNumber(PathName.baseNameOf(name)) }
}

private fun isNumber(text: String) = text.isNotEmpty() && text.all { it in '0'..'9' }

/** Returns the end of [name] that consists of field names, with slashes. It has at least one name if there is a folder. */
private fun fieldsOf(name: String): String {
    var start = name.lastIndexOf('/')
    if (start <= 0) return ""
    while (start > 0) {
        val before = name.lastIndexOf('/', start - 1)
        // An array's brackets belong to the owner of the field, not to the field.
        if (before <= 0 || name.substring(before + 1, start) !in NESTED) break
        start = before
    }
    return name.substring(start)
}

/** Returns whether [topic] has two different values. */
fun everChanges(topic: Topic): Boolean {
    val first = topic.samples.firstOrNull { !it.isNaN() }
    return topic.texts.dictionary.size > 1 || (first != null && topic.samples.any { !it.isNaN() && it != first })
}

/** Whether the line has nothing to draw. */
internal val GraphSeries.isEmpty: Boolean get() = topic.texts.size == 0 && topic.samples.all { it.isNaN() }

/** The structs of a log, and WPILib's equivalent messages. */
private val STRUCTS = listOf("struct:", "proto:wpi.proto.")

/** Fields of WPILib's structs that have fields themselves. */
private val NESTED = setOf("translation", "rotation", "q", "angle")

private val MEANINGS = listOf(
    "/speed" to "Module speeds",
    "/velocity" to "Module speeds",
    "/angle" to "Module angles",
    "/distance" to "Module distances",
)
