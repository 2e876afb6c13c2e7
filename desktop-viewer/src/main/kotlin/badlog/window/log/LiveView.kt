package badlog.window.log

import badlog.viewer.session.Place
import badlog.window.state.StateHolder
import java.nio.file.Path

/**
 * Whether the newest moment of a log is shown.
 *
 * @property growing the log that is being written; null for none.
 * @property isOn whether its newest moment is shown, with the cursor there, until a person goes elsewhere.
 */
internal data class Live(val growing: Path? = null, val isOn: Boolean = false)

/**
 * Shows the newest moment of the open log while its file grows: the cursor is there, and the visible range moves along, as wide as it is. Use
 * it only on the window's thread.
 */
internal class LiveView(private val current: CurrentRecording, private val view: AxisView) : StateHolder<Live>(Live()) {
    /** Where this has put the person last. */
    private var place: Place? = null
    private var awaited: Path? = null

    /** Whether the open log is being written. */
    val isGrowing: Boolean get() = current.recording != null && state.growing == current.recording?.file

    /** The newest moment of the open log if that is being written; null otherwise. */
    val newest: Double? get() = current.recording?.span?.to?.takeIf { isGrowing }

    /** Goes to the end of the open log; if that grows, stays there. */
    fun begin() {
        if (current.recording == null) return
        if (isGrowing) change { copy(isOn = true) }
        goToEnd()
    }

    /** Stays where it is from now on. */
    fun pause() = change { copy(isOn = false) }

    /** Begins with [log] as soon as it is open. */
    fun await(log: Path) {
        awaited = log
    }

    /** Another log is open from now on, which begins where it is, unless it was [awaited][await]. */
    fun opened() {
        val isAwaited = awaited != null && awaited == current.recording?.file
        awaited = null
        change { Live(growing = current.recording?.file.takeIf { isAwaited }) }
        if (isAwaited) begin()
    }

    /** Calls [show], which shows the open log as it was read anew, because it has grown or, without [isGrowing], has ended. */
    fun update(isGrowing: Boolean, show: () -> Unit) {
        val hasStayed = place?.let { it.range.visible == view.viewport.visible && it.cursors.pinned == view.cursors.pinned } == true
        if (state.isOn && !hasStayed) pause()
        show()
        change { copy(growing = current.recording?.file.takeIf { isGrowing }) }
        if (state.isOn) goToEnd()
    }

    private fun goToEnd() {
        view.go { atEnd() }
        place = view.place
    }
}
