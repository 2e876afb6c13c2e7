package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import badlog.core.analysis.Span
import badlog.viewer.session.Place
import badlog.window.state.StateHolder
import java.nio.file.Path

/**
 * Whether a person follows a log that is being written.
 *
 * @property growing the file that another program was writing when it was looked at last; null for none.
 * @property place where a person who wanted to stay at the end was put last; null for one who does not.
 * @property held the visible range that a person wants to keep, though it ends where the log ended; null for none.
 */
internal data class Live(val growing: Path? = null, val place: Place? = null, val held: Span? = null)

/**
 * Stays at the newest moment of the open log while its file grows: the cursor is there, and the visible range moves along, until a person
 * goes elsewhere. Use it only on the window's thread.
 *
 * @param recorded returns the file that this window itself records; null for none.
 */
internal class LiveView(private val current: CurrentRecording, private val view: AxisView, private val recorded: () -> Path?) :
    StateHolder<Live>(Live()) {
    private var awaited: Path? = null

    /** Whether the open log is being written. */
    val isGrowing: Boolean get() = current.recording?.file?.let { it == recorded() || it == state.growing } == true

    /** Whether the person is at the end of the log, and has not gone elsewhere. */
    val isStaying: Boolean by derivedStateOf { state.place?.let(::isAt) == true }

    /** Whether nothing was looked at since the end was shown: no part of it, and no selected range. */
    val isUntouched: Boolean get() = isStaying && state.place?.range?.visible == view.viewport.visible && view.selection == null

    /** The newest moment of the open log if that is being written; null otherwise. */
    val newest: Double? get() = current.recording?.span?.to?.takeIf { isGrowing }

    /** Goes to the end of the open log; if that grows, stays there. */
    fun begin() {
        if (current.recording == null) return
        view.go { atEnd() }
        if (isGrowing) stayHere()
    }

    /** Stays where it is from now on, though the log grows. */
    fun pause() = change { copy(place = null, held = view.viewport.visible.takeIf { view.viewport.isZoomed }) }

    /** Begins with [log] as soon as it is open. */
    fun await(log: Path) {
        awaited = log
    }

    /** Another log is open from now on, which begins where it is, unless it was [awaited][await]. */
    fun opened() {
        val isAwaited = awaited != null && awaited == current.recording?.file
        awaited = null
        change { Live() }
        if (isAwaited) begin()
    }

    /** Says that another program writes [file] now; null if none writes the open log. */
    fun grows(file: Path?) = change { copy(growing = file) }

    /** Calls [show], which shows the open log as it was read or calculated anew, and stays at its end if the person was there. */
    fun staying(show: () -> Unit) {
        val isThere = isStaying
        val held = state.held?.takeIf { it == view.viewport.visible }
        val begin = view.viewport.full.from
        show()
        if (isThere) {
            view.go { movedToEnd() }
            return stayHere()
        }
        val isHeld = held != null && view.viewport.full.from == begin
        if (held != null && isHeld) view.change { moved(held.from, held.to) }
        change { copy(place = null, held = view.viewport.visible.takeIf { isHeld }) }
    }

    private fun stayHere() = change { copy(place = view.place, held = null) }

    /** Zooming and looking at what is beside the end do not go elsewhere. */
    private fun isAt(place: Place): Boolean {
        val isHere = view.viewport.isAtEnd && view.viewport.full == place.range.full
        return isHere && view.cursors.pinned == place.cursors.pinned && view.secondCursor == place.cursors.second
    }
}
