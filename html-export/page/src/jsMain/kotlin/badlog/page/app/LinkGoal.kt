package badlog.page.app

import badlog.page.board.BoardSection
import badlog.page.findings.FindingsSection
import badlog.page.graph.GraphsInSight
import badlog.viewer.session.link.PageAddress
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element

/** The part of the page that a link points at: the board, a finding, or a graph. */
internal class LinkGoal(private val board: BoardSection, private val inSight: GraphsInSight, private val findings: FindingsSection) {
    /** The element that has the keyboard's focus because a link points at it. */
    private var focused: Element? = null

    /** Scrolls to the target of [address] and focuses it. [isAgain] is whether that was done before. */
    fun go(address: PageAddress, isAgain: Boolean) {
        if (address.board != null && address.finding == null) {
            board.bringIntoSight()
        } else {
            inSight.showAny()
            address.moment?.let { findings.visitAt(it, address.finding) }
        }
        focus(address, isAgain)
    }

    /** Focuses the target, unless the focus has moved since it was done before. */
    private fun focus(address: PageAddress, isAgain: Boolean) {
        val isElsewhere = isAgain && document.activeElement.let { it !== document.body && it !== focused }
        // A page in a frame leaves the focus to the page around it.
        if (isElsewhere || window.parent !== window) return
        if (address.finding == null || !findings.focusCurrent()) inSight.focusAny()
        focused = document.activeElement
    }
}
