package badlog.cli.input

import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert

/** A typed position on an x axis. */
internal class Position private constructor(private val text: String, private val number: Double, private val isClock: Boolean) {
    /**
     * Returns its value on [axis].
     *
     * @throws Failure if it is a time, and the axis is not.
     */
    fun on(axis: XAxis): Double {
        if (!isClock) return number
        val secondsPerX = Units.secondsIn(axis.unit)
            ?: throw Failure(
                "$text is a time, but the x axis ${axis.title} is not in a unit of time; name the time topic with --x, " +
                    "or give a number.",
            )
        return number / secondsPerX
    }

    override fun toString(): String = text

    companion object {
        private val CLOCK = Regex("""(-?)(?:(\d+):)?(\d+):(\d\d(?:\.\d*)?)""")

        /** Reads a number, `m:ss` or `h:mm:ss`; null for anything else. */
        fun of(text: String): Position? {
            text.toDoubleOrNull()?.let { return if (it.isNaN()) null else Position(text, it, isClock = false) }
            val (sign, hours, minutes, seconds) = CLOCK.matchEntire(text)?.destructured ?: return null
            val total = ((hours.toDoubleOrNull() ?: 0.0) * 60 + minutes.toDouble()) * 60 + seconds.toDouble()
            return Position(text, if (sign.isEmpty()) total else -total, isClock = true)
        }
    }
}

/** Returns this option as a position on the x axis. */
internal fun RawOption.position(): NullableOption<Position, Position> =
    convert { Position.of(it) ?: fail("“$it” is neither a number nor a time such as 1:32.5") }
