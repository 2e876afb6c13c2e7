package badlog.viewer.task

import androidx.compose.runtime.mutableStateListOf

/**
 * A sentence for the person at the window, shown until it is dismissed or has been there for a while.
 *
 * @property id identifies it.
 * @property isError whether something did not work.
 * @property action what can be done about it at once, or null.
 */
internal data class Notice(val id: Int, val text: String, val isError: Boolean, val action: NoticeAction? = null)

/** What a notice offers to do, as its button says it. */
internal class NoticeAction(val label: String, val run: () -> Unit)

/** The sentences that the window shows at its foot, the latest last. To be used on the window's thread only. */
internal class Notices {
    private val mutable = mutableStateListOf<Notice>()
    private var lastId = 0

    /** Them. */
    val all: List<Notice> get() = mutable

    /** Says that something went well, and offers [action]. */
    fun say(text: String, action: NoticeAction? = null) = add(text, isError = false, action)

    /** Says that something did not work: what, where, and what to do next, in one sentence. */
    fun complain(text: String) = add(text, isError = true, action = null)

    /** Takes notice [id] away. */
    fun dismiss(id: Int) {
        mutable.removeAll { it.id == id }
    }

    private fun add(text: String, isError: Boolean, action: NoticeAction?) {
        mutable.removeAll { it.text == text }
        while (mutable.size >= MAX_NOTICES) mutable.removeAt(0)
        mutable += Notice(++lastId, text, isError, action)
    }

    private companion object {
        const val MAX_NOTICES = 3
    }
}
