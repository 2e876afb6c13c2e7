package badlog.window.task

import androidx.compose.runtime.mutableStateListOf

/**
 * A sentence for the person at the window, shown until it is dismissed or a while has passed.
 *
 * @property id identifies it.
 * @property isError whether something failed.
 * @property action an action that it offers, or null.
 */
internal data class Notice(val id: Int, val text: String, val isError: Boolean, val action: NoticeAction? = null)

/** The action that a notice offers, with the label of its button. */
internal class NoticeAction(val label: String, val run: () -> Unit)

/** The notices at the bottom of the window, the latest last. Use it only on the window's thread. */
internal class Notices {
    private val mutable = mutableStateListOf<Notice>()
    private var lastId = 0

    /** The notices. */
    val all: List<Notice> get() = mutable

    /** Reports a success, and offers [action]. */
    fun say(text: String, action: NoticeAction? = null) = add(text, isError = false, action)

    /** Reports a failure: what, where, and what to do next, in one sentence. */
    fun complain(text: String) = add(text, isError = true, action = null)

    /** Removes notice [id]. */
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
