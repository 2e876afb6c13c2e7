package badlog.viewer.app

/**
 * A sentence for the person at the window, shown until it is dismissed or has been there for a while.
 *
 * @property id tells it from the others.
 * @property isError whether something did not work.
 */
internal data class Notice(val id: Int, val text: String, val isError: Boolean)
