package badlog.viewer.app

/**
 * A sentence for the person at the window, shown until it is dismissed or has been there for a while.
 *
 * @property id tells it from the others.
 * @property isError whether something did not work.
 * @property action what can be done about it at once, or null.
 */
internal data class Notice(val id: Int, val text: String, val isError: Boolean, val action: NoticeAction? = null)

/** What a notice offers to do, as its button says it. */
internal class NoticeAction(val label: String, val run: () -> Unit)
