package badlog.page.formula

import badlog.expression.ViewWithVirtualTopics
import badlog.expression.VirtualTopicsDraft
import badlog.page.dom.sliceMillis
import kotlinx.browser.window

/**
 * Calculates the topics of [draft] in slices, so that the page stays responsive. Work that fits one slice is done at once.
 *
 * @param onProgress called after each slice but the last, with the share of the work that is done.
 * @param onFailure called if there is not enough memory, or for an unexpected error.
 * @param done called at the end, unless the work is canceled.
 */
internal class FormulaSlices(
    private val draft: VirtualTopicsDraft,
    private val onProgress: (Double) -> Unit,
    private val onFailure: (Throwable) -> Unit,
    private val done: (ViewWithVirtualTopics) -> Unit,
) {
    /** Whether it is done, canceled or failed. */
    var isOver = false
        private set

    /** Calculates until the time of one slice is over; a timer then starts the next slice. */
    fun next() {
        if (isOver) return
        val end = window.performance.now() + sliceMillis(SLICE)
        work { window.performance.now() < end }
    }

    /** Calculates the rest at once. */
    fun finish() {
        if (!isOver) work { true }
    }

    /** Stops the work for good; none of the functions is called afterwards. */
    fun cancel() {
        isOver = true
    }

    private fun work(mayGoOn: () -> Boolean) {
        try {
            while (draft.step()) {
                if (mayGoOn()) continue
                onProgress(draft.share)
                window.setTimeout(::next, 0)
                return
            }
            isOver = true
            done(draft.extended)
        } catch (problem: Throwable) {
            isOver = true
            onFailure(problem)
        }
    }

    private companion object {
        /** The milliseconds of a slice, which fits into a frame. */
        const val SLICE = 16
    }
}
