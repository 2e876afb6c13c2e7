package badlog.signals.match.files

import badlog.core.analysis.stableOrder
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.core.text.UniqueNames
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.START_VALUE
import badlog.signals.clock.picked
import badlog.signals.clock.pickedSamples
import badlog.signals.clock.secondsPerX

/**
 * Returns one recording of this match, on the clock of its robot's log. It has the topics of that log as they are, then the other logs'
 * topics at times of their own, sorted if they went backwards. It leaves out samples before the robot's log, or before 0, and samples that
 * the Driver Station logged long after it.
 *
 * The topics of another log that are not in one folder are put into one, named after its file. Each file is a value in the folder `Files`,
 * which says how its clock was found and how much is left out. Missing files are values too.
 *
 * @param left a sentence about each log that is left out, which becomes a value and a problem.
 */
fun OneMatch.recording(left: List<String> = emptyList()): Recording {
    val robot = robot.log
    val names = UniqueNames().also { names -> robot.recording.topics.forEach { names.give(it.name) } }
    val beside = parts.drop(1).map { PartBeside(it, robot) }
    val topics = robot.recording.topics + beside.flatMap { it.topics(names) }
    val problems = parts.flatMap { it.file.log.recording.problems } + beside.flatMap { it.problems } +
        left.map { Problem(ProblemKind.LOG_LEFT_OUT, it) }
    return robot.recording.copy(topics = topics, values = valuesOf(beside, left), problems = problems)
}

/** The samples of the log of [part] during the log of [robot], at the robot's times. */
private class PartBeside(val part: MatchPart, private val robot: ClockedLog) {
    private val log = part.file.log
    private val places = HashMap<DoubleArray, Place>()

    /** The number of samples outside of the robot's time. */
    var outside = 0L
        private set

    fun topics(names: UniqueNames): List<Topic> {
        val folder = if (isInOneFolder(log.recording)) "" else folderOf(part.file.name) + "/"
        return log.recording.topics.filter { it !== log.view.xAxis.topic }.map { topic ->
            val x = topic.times ?: log.view.xAxis.positions
            // Topics that share their times keep sharing them.
            val place = places.getOrPut(x) { placeOf(x) }
            outside += place.outside
            val name = names.give(if (folder.isEmpty()) topic.name else folder + topic.name.removePrefix("/"))
            if (topic.isSparse) topic.pickedSamples(place.rows, name, place.times) else topic.picked(place.rows, name, place.times)
        }
    }

    /** Its unusual times. */
    val problems: List<Problem>
        get() = buildList {
            val sorted = places.values.count { it.isSorted }
            if (sorted > 0) {
                add(
                    Problem(
                        ProblemKind.TIMES_SORTED,
                        "The times in ${part.file.name} go backwards; its samples were sorted by time.",
                        count = sorted,
                    ),
                )
            }
            if (places.isNotEmpty() && places.values.all { it.rows.isEmpty() }) {
                val message = "No sample of ${part.file.name} is during the robot's log; check its clock (${part.why})."
                add(Problem(ProblemKind.LOG_LEFT_OUT, message))
            }
            val lost = places.values.sumOf { it.withoutTime }
            if (lost > 0) {
                val rows = if (lost == 1) "A row" else "$lost rows"
                val message = "$rows of ${part.file.name} without a time, and without an earlier row with one, cannot be placed."
                add(Problem(ProblemKind.X_GAPS, message, count = lost))
            }
        }

    private fun placeOf(x: DoubleArray): Place {
        // A WPILOG has no times before 0, and moving everything would change the robot's clock.
        val begin = minOf(0.0, robot.first)
        val end = if (part.file.role == FileRole.STATION) robot.last + AROUND else Double.POSITIVE_INFINITY
        val seconds = DoubleArray(x.size)
        var last = Double.NaN
        var isSorted = false
        for (i in x.indices) {
            // A row without a time belongs with the row before it.
            if (x[i].isFinite()) {
                (x[i] * log.view.secondsPerX + part.seconds).let {
                    if (it < last) isSorted = true
                    last = it
                }
            }
            seconds[i] = last
        }
        val kept = IntArray(x.size)
        var count = 0
        for (i in x.indices) if (seconds[i] in begin..end) kept[count++] = i
        val rows = stableOrder(seconds, kept.copyOf(count))
        val placed = seconds.count { !it.isNaN() }
        val times = DoubleArray(rows.size) { seconds[rows[it]] / robot.view.secondsPerX }
        return Place(rows, times, isSorted, withoutTime = x.size - placed, outside = placed - rows.size)
    }
}

/** The samples [rows], in this order, at [times]. */
private class Place(val rows: IntArray, val times: DoubleArray, val isSorted: Boolean, val withoutTime: Int, val outside: Int)

private fun isInOneFolder(recording: Recording): Boolean {
    val folders = recording.topics.mapTo(HashSet()) { it.name.substringBefore('/', "") }
    return (folders.size == 1 && folders.single().isNotEmpty()) || folders.all { it in OF_STATION }
}

private fun folderOf(name: String) = name.substringAfterLast('/').removeSuffix(".gz").substringBeforeLast('.').ifEmpty { name }

private fun OneMatch.valuesOf(beside: List<PartBeside>, left: List<String>): List<Value> {
    val values = ArrayList(robot.log.recording.values)
    for (part in parts.drop(1)) {
        // The time of day alone may belong to another match.
        val isSure = part.reason != ClockReason.SYSTEM_TIME
        for (value in part.file.log.recording.values) {
            if (value.name == START_VALUE || value in values) continue
            val isFree = isSure && values.none { it.name == value.name }
            values += if (isFree) value else value.copy(name = "${folderOf(part.file.name)}/${value.name}")
        }
    }
    val early = robot.log.first
    // Records of a WPILOG begin at 0 or later.
    val shift = if (early < 0) ", all of which is ${texted(-early)} s later, so that no time is before 0" else ""
    values += Value("Files/${robot.name}", "${robot.role.role}: ${parts.first().why}$shift")
    for (one in beside) {
        val part = one.part
        val outside = if (one.outside == 0L) "" else "; samples outside of the robot's log, which are left out: ${one.outside}"
        values += Value("Files/${part.file.name}", "${part.file.role.role}: moved by ${texted(part.seconds)} s; ${part.why}$outside")
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
