package badlog.signals.match.files

import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.core.text.UniqueNames
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.START_VALUE
import badlog.signals.clock.secondsPerX
import badlog.signals.clock.slice

/**
 * Returns one recording of this match, on the clock of its robot's log: the topics of that log as they are, then those of each other log
 * at times of their own. What is before 0 on that clock is left out, and what the Driver
 * Station logged long after the robot's log.
 *
 * A log whose topics are not all in one folder gets one, named after its file. Each file is a value in the folder `Files`, which says how
 * its clock was found; what is missing, and the [left] files, are values too.
 */
fun OneMatch.recording(left: List<String> = emptyList()): Recording {
    val robot = checkNotNull(robot.log)
    val names = UniqueNames().also { names -> robot.recording.topics.forEach { names.give(it.name) } }
    val topics = robot.recording.topics + parts.drop(1).flatMap { topicsOf(it, robot, names) }
    val problems = parts.mapNotNull { it.file.log }.flatMap { it.recording.problems }
    return robot.recording.copy(topics = topics, values = valuesOf(left), problems = problems)
}

private fun topicsOf(part: MatchPart, robot: ClockedLog, names: UniqueNames): List<Topic> {
    val log = part.file.log ?: return emptyList()
    // A WPILOG has no times before 0, and moving everything would change the robot's clock.
    val begin = minOf(0.0, robot.first)
    val end = if (part.file.role == FileRole.STATION) robot.last + AROUND else Double.POSITIVE_INFINITY
    val folder = if (isInOneFolder(log.recording)) "" else folderOf(part.file.name) + "/"
    val clocks = HashMap<DoubleArray, Place>()
    val rows = log.view.xAxis.positions
    return log.recording.topics.filter { it !== log.view.xAxis.topic }.map { topic ->
        val x = topic.times ?: rows
        // Topics that share their times keep sharing them.
        val place = clocks.getOrPut(x) { placeOf(x, log, part.seconds, begin, end, robot) }
        val name = if (folder.isEmpty()) topic.name else folder + topic.name.removePrefix("/")
        topic.slice(place.from, place.from + place.times.size, names.give(name), place.times)
    }
}

/** The samples from index [from] on, at [times]. */
private class Place(val from: Int, val times: DoubleArray)

/** Returns the part of [x] between [begin] and [end] s on the robot's clock, in the robot's unit: up to where it first goes backwards. */
private fun placeOf(x: DoubleArray, log: ClockedLog, seconds: Double, begin: Double, end: Double, robot: ClockedLog): Place {
    val from = x.indexOfFirst { it * log.view.secondsPerX + seconds >= begin }.let { if (it < 0) x.size else it }
    val times = ArrayList<Double>()
    for (i in from until x.size) {
        val time = x[i] * log.view.secondsPerX + seconds
        if (!(time <= end) || (times.isNotEmpty() && time / robot.view.secondsPerX < times.last())) break
        times += time / robot.view.secondsPerX
    }
    return Place(from, times.toDoubleArray())
}

private fun isInOneFolder(recording: Recording): Boolean {
    val folders = recording.topics.mapTo(HashSet()) { it.name.substringBefore('/', "") }
    return (folders.size == 1 && folders.single().isNotEmpty()) || folders.all { it in OF_STATION }
}

private fun folderOf(name: String) = name.substringAfterLast('/').substringBeforeLast('.').ifEmpty { name }

private fun OneMatch.valuesOf(left: List<String>): List<Value> {
    val values = ArrayList(checkNotNull(robot.log).recording.values)
    for (part in parts.drop(1)) {
        // The time of day alone may be that of another match.
        val isSure = part.reason != ClockReason.SYSTEM_TIME
        for (value in part.file.log?.recording?.values.orEmpty()) {
            if (value.name == START_VALUE || value in values) continue
            val isFree = isSure && values.none { it.name == value.name }
            values += if (isFree) value else value.copy(name = "${folderOf(part.file.name)}/${value.name}")
        }
    }
    for (part in parts) {
        val moved = if (part === parts.first()) "" else "moved by ${texted(part.seconds)} s; "
        values += Value("Files/${part.file.name}", "${part.file.role.role}: $moved${part.why}")
    }
    (sentences + left).forEachIndexed { i, sentence -> values += Value("Files/Note ${i + 1}", sentence) }
    return values
}

private fun texted(seconds: Double): String = (kotlin.math.round(seconds * MILLIS) / MILLIS).toString()

/** The folders of the Driver Station's topics. */
private val OF_STATION = setOf("Driver Station", "PDP", "PDH", "DS:")
/** In s. */
private const val AROUND = 10.0
private const val MILLIS = 1000.0
