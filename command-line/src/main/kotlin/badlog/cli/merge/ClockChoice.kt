package badlog.cli.merge

import badlog.cli.input.Failure
import badlog.cli.search.signalsBeside
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.formats.revlog.RevlogFormat
import badlog.signals.clock.ClockFit
import badlog.signals.clock.EnabledEdge
import badlog.signals.clock.enabledEdges
import badlog.signals.clock.motorFit
import badlog.signals.withSignals
import java.math.BigDecimal
import java.nio.file.Path
import java.util.IdentityHashMap
import kotlin.math.round

/** The number of seconds by which to move the log [file]. */
internal class Offset private constructor(val file: Path, val seconds: Double) {
    /** Returns whether that is [path], which may be in a folder. */
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
 * A log that was moved.
 *
 * @property edges the number of starts and ends of [what] that match those of the first log; 0 if the move was given.
 * @property error their largest distance from those, or else the possible error of the clocks, in s; 0 if the move was given.
 */
internal class Move(val part: LogPart, val edges: Int, val error: Double, val what: String = "enabled")

/** A time of [seconds] seconds without any log, after [one] and before [other]. */
internal class Pause(val one: LogPart, val other: LogPart, val seconds: Double)

/** Logs on one clock, some of which were moved for that. */
internal class MovedLogs(val parts: List<LogPart>, val moves: List<Move>) {
    /** Pauses so long that the logs may have different clocks. */
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

    private companion object {
        /** A robot that restarts its program is back within this time. */
        const val FAR_SECONDS = 60.0
    }
}

/**
 * How logs are put on one clock.
 *
 * @param alignsEnabled whether logs without an offset are moved so that the robot is enabled at the same time as in the
 * first log.
 */
internal class ClockChoice(private val offsets: List<Offset>, private val alignsEnabled: Boolean) {
    /**
     * Returns [parts], moved.
     *
     * @param station the one of them that is a Driver Station log, to be put beside the first.
     * @throws Failure if one cannot be moved.
     */
    fun moved(parts: List<LogPart>, station: StationPart? = null): MovedLogs {
        if (alignsEnabled && offsets.isEmpty() && station == null && parts.none(::isOfMotors)) return aligned(parts)
        val moves = ArrayList<Move>()
        val edges = if (alignsEnabled) edgesOf(parts.first()) else emptyList()
        val all = parts.mapIndexed { index, part ->
            val offset = offsets.find { it.isOf(part.file) }
            when {
                offset != null -> part.later(offset.seconds).also { moves += Move(it, 0, 0.0) }

                part === station?.part -> station.beside(parts.first()).also { moves += Move(it, station.fit.edges, station.fit.error) }

                index > 0 && isOfMotors(part) -> byMotors(part, parts.first())?.also { moves += it }?.part ?: part

                alignsEnabled && index > 0 -> fitOf(part, edges).let { fit ->
                    Move(part.later(fit.seconds), fit.edges, fit.error).also { moves += it }.part
                }

                else -> part
            }
        }
        return MovedLogs(all, moves)
    }

    /**
     * Returns [parts], moved so that the robot is enabled at the same times, on the clock of the one that would otherwise move to later
     * times; on a later one if another would begin before 0. Their order makes no difference.
     */
    private fun aligned(parts: List<LogPart>): MovedLogs {
        val edges = edgesOf(parts.first())
        val fits = parts.drop(1).map { fitOf(it, edges) }
        val offsets = listOf(0.0) + fits.map { it.seconds }
        val last = offsets.max()
        val early = parts.zip(offsets).filterNot { (part, _) -> part.hasRows || part.firstX.isNaN() }.minOfOrNull { (part, offset) ->
            part.firstX +
                offset -
                last
        }
        val later = maxOf(0.0, -(early ?: 0.0)) - last
        val moved = parts.zip(offsets) { part, offset -> if (round((offset + later) * MICROS) == 0.0) part else part.later(offset + later) }
        val moves = moved.mapIndexedNotNull { index, part ->
            if (part ===
                parts[index]
            ) {
                null
            } else {
                (fits.getOrNull(index - 1) ?: fits.minBy { it.edges }).let { Move(part, it.edges, it.error) }
            }
        }
        return MovedLogs(moved, moves)
    }

    private fun isOfMotors(part: LogPart) = part.recording.format == RevlogFormat

    /**
     * Returns the move of a log of REV's motor controllers, which does not show when the robot was enabled, beside [robot]; null if no
     * motor shows it.
     */
    private fun byMotors(part: LogPart, robot: LogPart): Move? {
        val signals = signalsBeside(robot.file)
        val (own, others) = listOf(part, robot).map { LogView.of(it.recording).withSignals(signals, it.file.fileName.toString()) }
        val fit = motorFit(own, others, signals)
        if (fit == null && alignsEnabled) {
            throw Failure("Nothing in ${part.file} matches ${robot.file}; use --offset ${part.file}=SECONDS instead.")
        }
        return fit?.let { Move(part.later(maxOf(it.seconds, -part.firstX)), it.edges, it.error, "motors driven") }
    }

    private fun fitOf(part: LogPart, edges: List<EnabledEdge>): ClockFit = ClockFit.ofEdges(edgesOf(part), edges)
        ?: throw Failure("The logs share no time of enabling or disabling; use --offset instead.")

    private fun edgesOf(part: LogPart): List<EnabledEdge> =
        LogView.of(part.recording).withSignals(signalsBeside(part.file), part.file.fileName.toString()).enabledEdges().ifEmpty {
            throw Failure("${part.file} does not show when the robot was enabled or disabled; use --offset ${part.file}=SECONDS instead.")
        }
}

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
        return LogPart(file, recording.copy(topics = topics), offset + micros / MICROS)
    }
    val x = xTopic ?: throw Failure("$file has no x axis, so it cannot be moved; name the topic of time with --x.")
    if (Units.secondsIn(x.unit) == null && !Units.isNone(x.unit)) {
        throw Failure("$file counts x in ${x.unit}, so it cannot be moved by seconds; name the topic of time with --x.")
    }
    val by = BigDecimal.valueOf(micros / MICROS / secondsPerX)
    val later = x.copy(samples = DoubleArray(x.samples.size) { x.samples[it].plus(by) })
    val topics = recording.topics.map { if (it === x) later else it }
    return LogPart(file, recording.copy(topics = topics), offset + micros / MICROS)
}

/** Decimal addition, without rounding errors of binary fractions. */
private fun Double.plus(other: BigDecimal): Double = if (isFinite()) BigDecimal.valueOf(this).add(other).toDouble() else this

private const val MICROS = 1e6
