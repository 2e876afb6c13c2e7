package badlog.page.linked

import badlog.page.dom.PageEvents
import kotlinx.browser.window
import org.khronos.webgl.ArrayBuffer
import org.w3c.dom.MessageEvent
import org.w3c.files.Blob
import org.w3c.files.File

/**
 * A log that another program, which opened this page, passes to it by Perfetto's protocol. The program sends `PING` until it receives
 * `PONG`, then an object `{badlog: {buffer, fileName}}`. Nothing else is ever sent back, and nothing is read before a person has agreed.
 *
 * @property origin the origin of the program, as reported by the browser.
 */
internal class HandedFile private constructor(val origin: String, private val bytes: Any, val name: String) {
    /** Returns the log as a file. */
    fun file(): File = File(arrayOf(bytes), name)

    companion object {
        /** Calls [onHanded] with each log that arrives this way, until something else is shown. */
        fun await(onHanded: (HandedFile) -> Unit) = PageEvents.on(window, "message") { event ->
            val message = event.unsafeCast<MessageEvent>()
            val sender: dynamic = message.source
            val handed: dynamic = message.data
            when {
                sender == null || sender == window -> Unit

                // An array with the text equals the text, too.
                jsTypeOf(handed) == "string" && handed == "PING" -> sender.postMessage("PONG", addressOf(message.origin))

                else -> read(message.origin, handed?.badlog)?.let(onHanded)
            }
        }

        /**
         * Returns the target for an answer. A program without an origin, such as a file, can only be addressed as `*`; it learns only that
         * this is a page.
         */
        private fun addressOf(origin: String) = if (origin == "null") "*" else origin

        private fun read(origin: String, handed: dynamic): HandedFile? {
            if (handed == null) return null
            val bytes: Any = handed.buffer.unsafeCast<Any?>() ?: return null
            if (bytes !is ArrayBuffer && bytes !is Blob) return null
            val name = handed.fileName
            return HandedFile(origin, bytes, fileNameOf(if (jsTypeOf(name) == "string") name as String else ""))
        }
    }
}
