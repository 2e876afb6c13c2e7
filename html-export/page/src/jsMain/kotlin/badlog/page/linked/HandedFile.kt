package badlog.page.linked

import badlog.page.dom.PageEvents
import kotlinx.browser.window
import org.khronos.webgl.ArrayBuffer
import org.w3c.dom.MessageEvent
import org.w3c.files.Blob
import org.w3c.files.File

/**
 * Another program that opened this page may hand over a log, as it does to Perfetto: it sends `PING` until it gets `PONG`, then an object
 * `{badlog: {buffer, fileName}}`. Nothing else is ever sent back, and nothing is read before a person has agreed.
 *
 * @property origin whose program it is, as the browser knows it.
 */
internal class HandedFile private constructor(val origin: String, private val bytes: Any, val name: String) {
    /** Returns it as a file. */
    fun file(): File = File(arrayOf(bytes), name)

    companion object {
        /** Calls [onHanded] with what is handed over, as long as nothing else is shown. */
        fun await(onHanded: (HandedFile) -> Unit) = PageEvents.on(window, "message") { event ->
            val message = event.unsafeCast<MessageEvent>()
            val sender: dynamic = message.source
            val handed: dynamic = message.data
            when {
                sender == null || sender == window -> Unit

                // An array of it equals it, too.
                jsTypeOf(handed) == "string" && handed == "PING" -> sender.postMessage("PONG", addressOf(message.origin))

                else -> read(message.origin, handed?.badlog)?.let(onHanded)
            }
        }

        /** A program without an origin, such as a file's, can only be addressed as anybody; it learns no more than that this is a page. */
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
