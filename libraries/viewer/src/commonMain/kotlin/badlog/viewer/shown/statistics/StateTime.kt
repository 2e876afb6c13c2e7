package badlog.viewer.shown.statistics

import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.core.analysis.XAxis
import badlog.viewer.text.fixedText
import badlog.viewer.text.lengthOn
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/**
 * The time that a lane was in a state.
 *
 * @property state the name of the state.
 * @property time the length on x, in its unit.
 * @property share the fraction of the time in any state, 0 to 1; NaN if that time is 0.
 * @property count the number of times that the state was entered, including being in it at the start.
 */
class StateTime(val state: String, val time: Double, val share: Double, val count: Int) {
    /** Returns [time] with the unit of [axis]. */
    fun timeText(axis: XAxis): String = lengthOn(axis, numberText(time))

    /** The displayed [share] in percent; `–` if unknown. */
    val shareText: String get() = withUnit(fixedText(share * 100, 1), "%")

    /** Returns all values in one line: `true 4.2 s (2.7 %), 3 times`. */
    fun text(axis: XAxis): String = "$state ${timeText(axis)} ($shareText), $count ${if (count == 1) "time" else "times"}"

    companion object {
        /** The column titles for the lane's name and [state], [time], [share] and [count] in a table. */
        val TITLES: List<String> = listOf("Lane", "State", "Time", "Share", "Times")

        /** The maximum number of listed states of a lane; a longer list is not readable. */
        const val MAX_LISTED: Int = 12
    }
}

/**
 * Returns the time in each of [states], the names of these runs' states, in all [parts] together. Gaps between them do not count. The
 * longest time is first; states that did not occur are omitted. A state that spans two parts counts twice.
 */
fun StateRuns.timesOf(states: List<String>, parts: List<Span>): List<StateTime> {
    val times = HashMap<Int, Double>()
    val counts = HashMap<Int, Int>()
    for ((from, to) in parts) {
        for (run in firstReaching(from) until this.states.size) {
            if (this.from[run] > to) {
                if (isOrdered) break else continue
            }
            val time = minOf(this.to[run], to) - maxOf(this.from[run], from)
            // A run that only touches the range is not in it.
            if (time < 0 || (time == 0.0 && this.to[run] > this.from[run] && from < to)) continue
            val state = this.states[run]
            times[state] = (times[state] ?: 0.0) + time
            counts[state] = (counts[state] ?: 0) + 1
        }
    }
    val all = times.values.sum()
    return times.map { (state, time) ->
        StateTime(states.getOrElse(state) { "?" }, time, if (all > 0) time / all else Double.NaN, counts.getValue(state))
    }.sortedWith(compareBy({ -it.time }, { it.state }))
}

/** Returns the time in each of [states] within [span] as lines of text; [axis] has its unit. */
fun StateRuns.textOf(states: List<String>, span: Span, axis: XAxis): String =
    timesOf(states, listOf(span)).take(StateTime.MAX_LISTED).joinToString("\n") { it.text(axis) }
