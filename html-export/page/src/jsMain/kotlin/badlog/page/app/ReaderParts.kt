package badlog.page.app

import badlog.page.board.BoardSection
import badlog.page.header.SearchBox
import badlog.page.panel.CursorPanel
import badlog.page.panel.ModulesPanel
import badlog.viewer.session.link.OpenedParts

/** The parts of the page that a reader can open and close, in the form used by links. */
internal class ReaderParts(
    private val search: SearchBox,
    private val values: CursorPanel,
    private val modules: ModulesPanel,
    private val board: BoardSection,
) {
    /** The parts that are open. */
    val now: OpenedParts
        get() {
            val statistics = board.cards.withIndex().filter { it.value.hasStatistics }.map { it.index + 1 }
            return OpenedParts(search.text, values.isOpen, modules.isOpen, statistics)
        }

    /** Opens the parts in [wanted]; other open parts stay open. */
    fun open(wanted: OpenedParts) {
        if (wanted.search.isNotEmpty()) search.show(wanted.search)
        if (wanted.hasValues && !values.isOpen) values.toggle()
        if (wanted.hasModules && !modules.isOpen) modules.toggle()
        for (place in wanted.statistics) board.cards.getOrNull(place - 1)?.takeIf { !it.hasStatistics }?.toggleStatistics()
    }
}
