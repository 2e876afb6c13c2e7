package badlog.page.app

import badlog.page.board.BoardSection
import badlog.page.dom.bringIntoSight
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.findings.FindingsSection
import badlog.page.folder.EventsLink
import badlog.page.folder.FolderList
import badlog.page.folder.FolderNavigation
import badlog.page.note.NoteList
import badlog.page.panel.CursorPanel
import badlog.page.view.SearchCounts
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** The parts of the page that a search covers; those below the board are in [content]. */
internal class SearchedParts(
    private val board: BoardSection,
    private val folders: FolderList,
    private val findings: FindingsSection,
    private val send: (Action) -> Unit,
    private val notes: NoteList,
    private val navigation: FolderNavigation,
    private val events: EventsLink,
    private val values: CursorPanel,
    private val content: HTMLElement,
) {
    /** The notice that nothing matches the search. */
    val nothingFound: HTMLElement = element("p", "nothing-found", "Nothing matches. Escape clears the search.").apply { isHidden = true }

    /** Shows the matches of [query], and scrolls to them if necessary. */
    fun show(query: Query): SearchCounts {
        board.filter(query)
        val inFolders = folders.filter(query)
        send(FindingAction.Search(query.text))
        val hits = inFolders + SearchCounts(findings = findings.hits, notes = notes.filter(query))
        nothingFound.isHidden = query.isEmpty || !hits.isEmpty
        navigation.update(isSearching = !query.isEmpty)
        events.update()
        values.filter(query)
        // The findings begin above the screen if the page was scrolled before. They begin below it if there is a board above.
        val top = content.getBoundingClientRect().top
        val isBelow = top > window.innerHeight / 2 && !inFolders.isEmpty
        if (!query.isEmpty && (top < 0 || isBelow)) content.bringIntoSight()
        return hits
    }
}
