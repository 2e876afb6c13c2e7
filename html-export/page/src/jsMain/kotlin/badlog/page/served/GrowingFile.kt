package badlog.page.served

import badlog.formats.TEXT_ENDINGS
import badlog.page.dom.json
import badlog.page.dom.place
import org.khronos.webgl.ArrayBuffer
import org.khronos.webgl.Uint8Array
import org.khronos.webgl.get
import org.w3c.files.Blob
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * A log that is being written on the page's server, at [address]: asks for what is new in it, or for all of it if the server has no parts.
 *
 * @param file what was in it so far.
 */
internal class GrowingFile(private val file: File, private val address: String) {
    private var bytes: Blob = file

    /** Where the last whole row ends: a part may have no end of a row. */
    private var whole = file.size.toInt()

    // Bytes that are not text may be line feeds anywhere.
    private val isText = TEXT_ENDINGS.any { file.name.endsWith(it, ignoreCase = true) }

    /** How long to wait before the next [more], in ms: whole logs are asked for seldom. */
    var pause = PAUSE
        private set

    /** Returns the log with what is new in it, up to its last whole row; null if nothing is. Rejected with a sentence. */
    fun more(): Promise<File?> = ask(address, from = bytes.size.toDouble() - KNOWN_BYTES).then { response ->
        response.arrayBuffer().catch<ArrayBuffer> { throw NotNow(LOST) }.then { take(it, response.status == PART) }
    }.unsafeCast<Promise<File?>>()

    private fun take(buffer: ArrayBuffer, isPart: Boolean): File? {
        pause = if (isPart) PAUSE else maxOf(PAUSE, buffer.byteLength / WHOLE_BYTES_PER_MILLI)
        val begin = if (isPart) bytes.size.toInt() - KNOWN_BYTES else 0
        if (begin + buffer.byteLength <= bytes.size.toInt()) return null
        bytes = Blob(if (isPart) arrayOf(bytes, buffer.slice(KNOWN_BYTES)) else arrayOf(buffer))
        val end = if (isText) endOfLines(Uint8Array(buffer), begin) else bytes.size.toInt()
        if (end <= whole) return null
        whole = end
        val options = json("lastModified" to file.asDynamic().lastModified).unsafeCast<FilePropertyBag>()
        return File(arrayOf(bytes.slice(0, end)), file.name, options).also { it.place = file.place }
    }

    /** Returns where the last line ends when [part], which is at [begin], is there: behind it is a row that is not whole yet. */
    private fun endOfLines(part: Uint8Array, begin: Int): Int {
        var end = part.length
        while (end > 0 && part[end - 1] != LINE_FEED) end--
        return if (end > 0) begin + end else whole
    }

    private companion object {
        const val PAUSE = 50

        /** What is asked for again, because it is an error to ask for nothing but what is not there yet. */
        const val KNOWN_BYTES = 1

        /** 2 Mbit/s, half of what a robot has on a field. */
        const val WHOLE_BYTES_PER_MILLI = 250
        const val LINE_FEED: Byte = 10
        const val PART: Short = 206
    }
}
