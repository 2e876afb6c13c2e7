package badlog.viewer.playback

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.withFrameNanos
import badlog.analysis.Span
import badlog.analysis.Units
import badlog.analysis.XAxis
import badlog.viewer.app.Viewer

/** Lets the cursor run, frame by frame, while it is to. */
@Composable
internal fun PlaybackRunning(viewer: Viewer) {
    if (!viewer.playback.isPlaying) return
    LaunchedEffect(viewer) {
        var before = withFrameNanos { it }
        while (viewer.playback.isPlaying) {
            val now = withFrameNanos { it }
            advance(viewer, (now - before) / NANOS)
            before = now
        }
    }
}

/** Starts the cursor, from the beginning when it stands at the end; or halts it. */
internal fun togglePlaying(viewer: Viewer) {
    val playback = viewer.playback
    if (!playback.isPlaying && viewer.open == null) return
    val range = rangeOf(viewer)
    val cursor = viewer.cursor
    if (!playback.isPlaying && (cursor == null || cursor !in range || cursor >= range.to)) {
        viewer.cursor = if (cursor == null && !playback.loops) viewer.viewport.visible.from.coerceIn(range.from, range.to) else range.from
    }
    viewer.playback = playback.copy(isPlaying = !playback.isPlaying)
}

/** Lets [seconds] pass. */
internal fun advance(viewer: Viewer, seconds: Double) {
    val open = viewer.open
    if (open == null) {
        viewer.playback = viewer.playback.copy(isPlaying = false)
        return
    }
    // A machine that was asleep must not jump to the end.
    val distance = seconds.coerceIn(0.0, LONGEST_STEP) * viewer.playback.speed * perSecond(open.view.xAxis, viewer.viewport.full)
    val step = viewer.playback.advanced(viewer.cursor, distance, rangeOf(viewer))
    viewer.cursor = step.cursor
    viewer.playback = step.playback
    follow(viewer, step.cursor)
}

/** What is played: when looping the selection or what is seen, else to the end of the selection or of everything. */
private fun rangeOf(viewer: Viewer): Span = viewer.selection ?: if (viewer.playback.loops) viewer.viewport.visible else viewer.viewport.full

private fun follow(viewer: Viewer, x: Double) {
    val visible = viewer.viewport.visible
    if (x in visible) return
    // Most of the room for what comes, and the way back is not filled with pages.
    val from = x - visible.width * LEAD
    viewer.viewport = viewer.viewport.moved(from, from + visible.width)
}

/** How much of x passes in a second at speed 1: what its unit says, or else all of it in a minute. */
internal fun perSecond(axis: XAxis, full: Span): Double = Units.secondsIn(axis.unit)?.let { 1 / it } ?: (full.width / SECONDS_OF_MINUTE)

private const val NANOS = 1e9
private const val LONGEST_STEP = 0.25
private const val LEAD = 0.1
private const val SECONDS_OF_MINUTE = 60
