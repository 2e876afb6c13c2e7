package badlog.window.task

import androidx.compose.runtime.mutableStateListOf
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.awt.Desktop
import java.awt.GraphicsEnvironment
import java.io.IOException
import java.nio.file.Path

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
}

/**
 * Returns the action that opens [place] with the system's program for it; null if the system cannot. It runs in [scope]. [place] is a file
 * or a folder.
 */
internal fun openAction(place: Path, scope: CoroutineScope, notices: Notices): NoticeAction? {
    val canOpen = !GraphicsEnvironment.isHeadless() && Desktop.isDesktopSupported() &&
        Desktop.getDesktop().isSupported(Desktop.Action.OPEN)
    if (!canOpen) return null
    return NoticeAction("Open") {
        scope.launch {
            try {
                withContext(Dispatchers.IO) { Desktop.getDesktop().open(place.toFile()) }
            } catch (_: IOException) {
                notices.complain("The system has no program that opens $place; open it by hand.")
            } catch (_: IllegalArgumentException) {
                notices.complain("$place does not exist.")
            }
        }
    }
}

private const val MAX_NOTICES = 3
