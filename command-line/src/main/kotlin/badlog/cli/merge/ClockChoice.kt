package badlog.cli.merge

import badlog.catalog.match.roleOf
import badlog.cli.input.Failure
import badlog.cli.search.signalsBeside
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockPlace
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.EnabledEdge
import badlog.signals.clock.motorFit
import badlog.signals.clock.onOneClock
import badlog.signals.match.NaturalOrder
import badlog.signals.match.files.FileRole
import badlog.signals.withSignals
import java.math.BigDecimal
import java.nio.file.Path
import java.util.IdentityHashMap
import kotlin.math.round

/** The number of seconds by which to move the log [file]. */
internal class Offset private constructor(val file: Path, val seconds: Double) {
    /** Returns whether it is the offset of [path]. A [file] without a folder matches the file of that name in any folder. */
    fun isOf(path: Path): Boolean = path.toAbsolutePath().normalize() == file.toAbsolutePath().normalize() || path.fileName == file

    companion object {
        /** Reads `FILE=SECONDS`; null for anything else. */
        fun of(text: String): Offset? {
            val equals = text.lastIndexOf('=')
            val seconds = text.substring(equals + 1).toDoubleOrNull()?.takeIf { it.isFinite() }
            return if (equals < 1 || seconds == null) null else Offset(Path.of(text.substring(0, equals)), seconds)
        }
    }
}

/**
 * A log with times that were moved to the common clock.
 *
 * @property edges the number of starts and ends of [what] that match the other log's; 0 if the move was given.
 * @property error the largest distance between matches, in s; if none match, the possible error of the clocks. 0 if the move was given.
 * @property early the number of its samples that would be before 0, and are left out of a merged log.
 */
internal class Move(val part: LogPart, val edges: Int, val error: Double, val what: String = "enabled", val early: Long = 0)

/** A time of [seconds] seconds without any log, after [one] and before [other]. */
internal class Pause(val one: LogPart, val other: LogPart, val seconds: Double)

/**
 * Logs on one clock. Some were moved to it.
 *
 * @property placed the logs with a given or found position on the common clock; the others just kept their times.
 * @property besides for each log that was aligned, the log with which it was aligned.
 */
internal class MovedLogs(
    val parts: List<LogPart>,
    val moves: List<Move>,
    val placed: Set<LogPart>,
    val besides: Map<LogPart, LogPart> = emptyMap(),
) {
    /** The pauses that are so long that the logs may have different clocks. */
    val pauses: List<Pause> = buildList {
        var last: LogPart? = null
        for (part in parts.filter { it.firstX.isFinite() && (it.xTopic != null || !it.hasRows) }.sortedBy { it.firstX }) {
            val before = last
            if (before != null) {
                val seconds = (part.firstX - before.lastX) * part.secondsPerX
                if (seconds > FAR_SECONDS) add(Pause(before, part, seconds))
            }
            if (before == null || part.lastX > before.lastX) last = part
        }
    }
}

/**
 * The way to put logs on one clock.
 *
 * @param alignsEnabled whether logs without an offset are moved so that the robot is enabled at the same times in all.
 */
internal class ClockChoice(private val offsets: List<Offset>, private val alignsEnabled: Boolean) {
    /**
     * Returns [parts] with their times moved to one clock.
     *
     * @param station the Driver Station log among [parts], with the robot's log to align it with; null if there is none.
     * @throws Failure if one cannot be moved.
     */
    fun moved(parts: List<LogPart>, station: StationPart? = null): MovedLogs {
        val own = parts.filter { it !== station?.part }
        val places = placesOf(own)
        val later = if (isFree(own)) laterFor(own, places) else 0.0
        val moves = ArrayList<Move>()
        val moved = own.mapIndexed { index, part ->
            val place = places[index] ?: return@mapIndexed part
            val seconds = place.seconds + later
            if (round(seconds * MICROS) == 0.0) return@mapIndexed part
            val isByMotors = isOfMotors(part) && place.fit != null
            // The robot's clock stays, so that what motor controllers logged before its 0 has no place.
            val kept = if (isByMotors) part.since(-seconds) else part
            val by = kept.later(seconds)
            val early = part.recording.sampleCount - kept.recording.sampleCount
            val fit = place.fit ?: places.mapNotNull { it?.fit }.takeIf { later != 0.0 }?.minByOrNull { it.edges }
            by.also { moves += Move(it, fit?.edges ?: 0, fit?.error ?: 0.0, if (isByMotors) "motors driven" else "enabled", early) }
        }
        val placed = moved.filterIndexedTo(HashSet()) { i, _ -> alignsEnabled || isGiven(own[i]) }
        val besides = HashMap<LogPart, LogPart>()
        for (i in own.indices) places[i]?.beside?.let { besides[moved[i]] = moved[it] }
        val beside = station?.let { one ->
            val robot = moved[own.indexOf(one.robot)]
            one.beside(robot).also {
                besides[it] = robot
                moves += Move(it, one.fit.edges, one.fit.error, early = one.part.recording.sampleCount - it.recording.sampleCount)
            }
        }
        return MovedLogs(moved + listOfNotNull(beside), moves, placed, besides)
    }

    /** Whether nothing says where one of [parts] stands, so that all of them may move. */
    private fun isFree(parts: List<LogPart>) = alignsEnabled && parts.none(::isGiven)

    /** Returns whether the offset of [part] was given. */
    fun isGiven(part: LogPart): Boolean = offsets.any { it.isOf(part.file) }

    private fun placesOf(parts: List<LogPart>): List<ClockPlace?> {
        val given = parts.indices.mapNotNull { i -> offsets.find { it.isOf(parts[i].file) }?.let { i to it.seconds } }.toMap()
        val others = parts.indices.filter { it !in given && !isOfMotors(parts[it]) }
        // The others are aligned with a log that has an offset, otherwise with the first. Without --align, all keep their clocks.
        val isBesideGiven = given.keys.any { !isOfMotors(parts[it]) }
        val kept = if (!alignsEnabled) {
            others
        } else if (isBesideGiven) {
            emptyList()
        } else {
            others.take(1)
        }
        val edges = if (alignsEnabled && others.size + given.size > 1) edgesOf(parts, others, given.keys) else emptyMap()
        val places = onOneClock(parts.size, given + kept.associateWith { 0.0 }) { one, other -> fitOf(parts, edges, one, other) }
        if (alignsEnabled) parts.indices.find { places[it] == null }?.let { throw unplaced(parts, it) }
        return places
    }

    /** Returns when each of [parts] was enabled and disabled. Those that were [given] a place count only if they show it. */
    private fun edgesOf(parts: List<LogPart>, others: List<Int>, given: Set<Int>): Map<Int, List<EnabledEdge>> {
        val shown = (others + given).associateWith { clocked(parts[it]).edges }
        others.find { shown.getValue(it).isEmpty() }?.let { silent ->
            val file = parts[silent].file
            throw Failure("$file does not show when the robot was enabled or disabled; use --offset $file=SECONDS instead.")
        }
        return shown
    }

    private fun fitOf(parts: List<LogPart>, edges: Map<Int, List<EnabledEdge>>, own: Int, other: Int): ClockFit? {
        val (part, beside) = parts[own] to parts[other]
        if (isOfMotors(beside)) return null
        if (isOfMotors(part)) return byMotors(part, beside)
        return ClockFit.ofEdges(edges[own] ?: return null, edges[other] ?: return null)
    }

    private fun unplaced(parts: List<LogPart>, index: Int): Failure {
        val file = parts[index].file
        return Failure(
            if (isOfMotors(parts[index])) {
                "Nothing in $file matches the other logs; use --offset $file=SECONDS instead."
            } else {
                "$file shares no time of enabling or disabling with the other logs; use --offset $file=SECONDS instead."
            },
        )
    }

    /** Returns by how much all of [parts] move. One of them keeps its clock, and none without rows begins before 0. */
    private fun laterFor(parts: List<LogPart>, places: List<ClockPlace?>): Double {
        val offsets = parts.indices.filterNot { isOfMotors(parts[it]) }.map { parts[it] to (places[it]?.seconds ?: 0.0) }
        val last = offsets.maxOfOrNull { (_, offset) -> offset } ?: return 0.0
        val early = offsets.filterNot { (part, _) -> part.hasRows || part.firstX.isNaN() }
            .minOfOrNull { (part, offset) -> part.firstX + offset - last }
        return maxOf(0.0, -(early ?: 0.0)) - last
    }

    /**
     * Returns how the clock of a log of REV's motor controllers relates to [robot]'s. Such a log does not show when the robot was enabled.
     */
    private fun byMotors(part: LogPart, robot: LogPart): ClockFit? {
        val signals = signalsBeside(robot.file)
        val (own, others) = listOf(part, robot).map { LogView.of(it.recording).withSignals(signals, it.file.fileName.toString()) }
        return motorFit(own, others, signals)
    }
}

private fun isOfMotors(part: LogPart): Boolean = part.role == FileRole.MOTORS

/** Returns [part] in the form in which logs from the same time are recognized. */
internal fun clocked(part: LogPart) = ClockedLog(part.file.fileName.toString(), part.recording, signalsBeside(part.file))

/** The program or devices that wrote this log. */
internal val LogPart.role: FileRole get() = roleOf(file.fileName.toString(), recording)

/** The order of logs in a merge: by [role], then by name. The order of the arguments does not matter. */
internal val PART_ORDER: Comparator<LogPart> =
    compareBy<LogPart> { it.role }
        .thenBy(NaturalOrder) { it.file.fileName.toString() }
        .thenBy { it.file.toAbsolutePath().normalize().toString() }

/** The number of seconds per unit of x. */
internal val LogPart.secondsPerX: Double
    get() = Units.secondsIn(axis.unit) ?: 1.0

/**
 * Returns the same log, delayed by [seconds].
 *
 * @throws Failure if its x is not a time, or would begin before 0 in a log that cannot have such times.
 */
internal fun LogPart.later(seconds: Double): LogPart {
    val micros = round(seconds * MICROS)
    if (!hasRows) {
        // Topics that share their times keep sharing them.
        val moved = IdentityHashMap<DoubleArray, DoubleArray>()
        fun later(times: DoubleArray) = moved.getOrPut(times) { DoubleArray(times.size) { round(times[it] * MICROS + micros) / MICROS } }
        val topics = recording.topics.map { it.copy(times = it.times?.let(::later)) }
        if (firstX * MICROS + micros < 0) throw Failure("$file would start before 0; give the other logs a positive --offset instead.")
        return with(recording.copy(topics = topics), offset + micros / MICROS)
    }
    val x = xTopic ?: throw Failure("$file has no x axis, so it cannot be moved; name the topic of time with --x.")
    if (Units.secondsIn(x.unit) == null && !Units.isNone(x.unit)) {
        throw Failure("$file counts x in ${x.unit}, so it cannot be moved by seconds; name the topic of time with --x.")
    }
    val by = BigDecimal.valueOf(micros / MICROS / secondsPerX)
    val later = x.copy(samples = DoubleArray(x.samples.size) { x.samples[it].plus(by) })
    val topics = recording.topics.map { if (it === x) later else it }
    return with(recording.copy(topics = topics), offset + micros / MICROS)
}

/** Decimal addition, without rounding errors of binary fractions. */
private fun Double.plus(other: BigDecimal): Double = if (isFinite()) BigDecimal.valueOf(this).add(other).toDouble() else this

private const val MICROS = 1e6

/** The maximum time in which a robot restarts its program. */
private const val FAR_SECONDS = 60.0
