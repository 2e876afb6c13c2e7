package badlog.viewer.session.link

import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.WantedFinding

/**
 * The pinned cursors and the selected finding, each as the end of an address. They are restored when the log is opened again; may be empty.
 */
val Place.keptText: String
    get() {
        val selected = visited?.run { WantedFinding(finding.rule, finding.topic, span.from) } ?: wanted
        val finding = selected?.run { PageAddress(x, finding = FindingName(rule, topic)) } ?: PageAddress()
        val cursors = PageAddress(cursors.pinned, second = cursors.second)
        return listOf(cursors, finding).joinToString(" ") { it.toText() }.trim()
    }

/** Returns the actions that lead back to the place of [text], which [keptText] wrote. */
fun actionsOfKept(text: String): List<Action> = text.split(' ').mapNotNull { part ->
    val address = pageAddressOf(part)
    val x = address.moment ?: return@mapNotNull null
    address.finding?.run { FindingAction.Select(WantedFinding(rule, topic, x)) } ?: PlaceAction.Pin(x, address.second)
}
