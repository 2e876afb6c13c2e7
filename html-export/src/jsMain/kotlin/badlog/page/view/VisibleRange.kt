package badlog.page.view

import badlog.analysis.Span
import kotlin.math.abs

/**
 * The part of the x axis that every graph shows, and the ones shown before it.
 *
 * @param from the smallest x of the recording.
 * @param to the largest x of the recording.
 */
internal class VisibleRange(from: Double, to: Double) {
    /** All there is to see; wider than the recording where that has a single x. */
    val full: Span = if (to > from) Span(from, to) else around(if (from.isFinite()) from else 0.0)

    /** What is seen now. */
    var now: Span = full
        private set

    private val history = ArrayList<Span>()
    private val listeners = ArrayList<() -> Unit>()

    // Narrower, and neighbouring pixels would be the same number.
    private val narrowest =
        minOf(maxOf(full.width * 1e-9, maxOf(abs(full.from), abs(full.to)) * 1e-12, 1e-300), full.width)

    val isZoomed: Boolean get() = now != full
    val canGoBack: Boolean get() = history.isNotEmpty()

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Shows what lies from [from] to [to], which may be given in any order; [back] returns from it. */
    fun show(from: Double, to: Double) {
        remember()
        move(from, to)
    }

    /** Keeps what is seen now for [back]. To be called when a gesture begins that goes on with [move]. */
    fun remember() {
        if (history.lastOrNull() == now) return
        if (history.size == LONGEST_HISTORY) history.removeAt(0)
        history += now
    }

    /** Shows what lies from [from] to [to], as one of many steps. Keeps within the recording. */
    fun move(from: Double, to: Double) {
        if (!from.isFinite() || !to.isFinite()) return
        val width = abs(to - from).coerceIn(narrowest, full.width)
        val start = ((from + to) / 2 - width / 2).coerceIn(full.from, maxOf(full.from, full.to - width))
        set(if (width >= full.width) full else Span(start, start + width))
    }

    /** Makes what is seen [factor] times as wide, leaving x = [center] where it stands on the screen. */
    fun scale(factor: Double, center: Double) {
        val width = (now.width * factor).coerceIn(narrowest, full.width)
        val share = (center - now.from) / now.width
        val start = (center - width * share).coerceIn(full.from, maxOf(full.from, full.to - width))
        move(start, start + width)
    }

    /** Shows everything. */
    fun reset() {
        if (!isZoomed) return
        remember()
        set(full)
    }

    /** Shows what was seen before. */
    fun back() {
        while (history.isNotEmpty()) {
            val span = history.removeAt(history.size - 1)
            if (span == now) continue
            set(span)
            return
        }
    }

    /** Shows [x], moving no further than needed, so that a part of the width lies on either side. */
    fun reveal(x: Double) {
        if (x in now.from..now.to || !x.isFinite()) return
        show(x - now.width / 2, x + now.width / 2)
    }

    private fun set(span: Span) {
        if (span == now) return
        now = span
        for (listener in listeners) listener()
    }

    private fun around(x: Double): Span {
        val half = maxOf(0.5, abs(x) * 1e-6)
        return Span(x - half, x + half)
    }

    private companion object {
        const val LONGEST_HISTORY = 100
    }
}
