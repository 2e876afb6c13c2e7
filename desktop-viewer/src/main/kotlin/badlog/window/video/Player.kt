package badlog.window.video

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.withFrameNanos
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.viewer.session.video.speedAfter
import badlog.viewer.state.PlaceAction
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder

/** Plays the recording by moving the cursor. */
internal class Player(private val current: CurrentRecording, private val view: AxisView) : StateHolder<Playback>(Playback()) {
    /** The played range: the selection, or otherwise the visible range when looping, or everything. */
    private val range: Span get() = view.selection ?: if (state.loops) view.viewport.visible else view.viewport.full

    /** Starts playback, from the start if the cursor is at the end; or pauses it. */
    fun toggle() {
        if (!state.isPlaying && current.recording == null) return
        val range = range
        val cursor = view.cursor
        if (!state.isPlaying && (cursor == null || cursor !in range || cursor >= range.to)) {
            val isAnywhere = cursor == null && !state.loops
            val start = if (isAnywhere) view.viewport.visible.from.coerceIn(range.from, range.to) else range.from
            view.send(PlaceAction.MoveCursor(start))
        }
        change { copy(isPlaying = !isPlaying) }
    }

    /** Turns looping on or off. */
    fun toggleLoop() = change { copy(loops = !loops) }

    /** Advances the cursor by [seconds] of playback. */
    fun advance(seconds: Double) {
        val open = current.recording ?: return change { copy(isPlaying = false) }
        // After sleeping, the machine must not jump to the end.
        val distance = seconds.coerceIn(0.0, MAX_STEP) * state.speed * perSecond(open.view.xAxis, view.viewport.full)
        val step = state.advanced(view.cursor, distance, range)
        view.send(PlaceAction.MoveCursor(step.cursor))
        change { step.playback }
        follow(step.cursor)
    }

    private fun follow(x: Double) {
        val visible = view.viewport.visible
        if (x in visible) return
        // Leaves most of the room for the following data, and does not fill the history with steps.
        val from = x - visible.width * LEAD
        view.send(PlaceAction.Move(from, from + visible.width))
    }
}

/** Advances [player] frame by frame, while it plays. */
@Composable
internal fun PlayerFrames(player: Player) {
    if (!player.state.isPlaying) return
    LaunchedEffect(player) {
        var before = withFrameNanos { it }
        while (player.state.isPlaying) {
            val now = withFrameNanos { it }
            player.advance((now - before) / NANOS)
            before = now
        }
    }
}

/**
 * Returns the distance in x per second at speed 1. It depends on the unit of x; if that is not a unit of time, all of [full] takes a
 * minute.
 */
internal fun perSecond(axis: XAxis, full: Span): Double = Units.secondsIn(axis.unit)?.let { 1 / it } ?: (full.width / SECONDS_OF_MINUTE)

private const val NANOS = 1e9
private const val SECONDS_OF_MINUTE = 60

/**
 * The playback of the cursor.
 *
 * @property isPlaying whether it is running.
 * @property speed the speed relative to the recording; if x is not a time, the whole recording takes a minute at speed 1.
 * @property loops whether it starts over at the end of its range: the selection, or otherwise the visible range.
 */
internal data class Playback(val isPlaying: Boolean = false, val speed: Double = 1.0, val loops: Boolean = false) {
    /**
     * Returns the cursor after advancing by [distance] of x, which is not negative, and the playback from there on. The cursor stays within
     * [range]: at the end, it starts over if the playback loops, otherwise it stops. From outside, it begins at the start of [range].
     */
    fun advanced(cursor: Double?, distance: Double, range: Span): Step {
        val from = cursor?.takeIf { it in range } ?: range.from
        val next = from + distance
        return when {
            next < range.to -> Step(next, this)
            !loops || range.width <= 0 -> Step(range.to, copy(isPlaying = false))
            else -> Step(range.from + (next - range.from).mod(range.width), this)
        }
    }

    /** Returns the playback [steps] faster, see [speedAfter]. */
    fun faster(steps: Int): Playback = copy(speed = speedAfter(speed, steps))

    /**
     * A step of playback.
     *
     * @property cursor the cursor's new place.
     * @property playback the new state of playback.
     */
    data class Step(val cursor: Double, val playback: Playback)
}

private const val MAX_STEP = 0.25
private const val LEAD = 0.1
