package badlog.page.served

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

    /** How long to wait before the next [more], in ms: whole logs are asked for seldom. */
    var pause = PAUSE
        private set

    /** Returns the log with what is new in it, up to its last whole row; null if nothing is. Rejected with a sentence. */
    fun more(): Promise<File?> = ask(address, from = bytes.size.toDouble() - KNOWN_BYTES).then { response ->
        response.arrayBuffer().catch<ArrayBuffer> { throw IllegalStateException(LOST) }.then { take(it, response.status == PART) }
    }.unsafeCast<Promise<File?>>()

    private fun take(buffer: ArrayBuffer, isPart: Boolean): File? {
        pause = if (isPart) PAUSE else maxOf(PAUSE, buffer.byteLength / WHOLE_BYTES_PER_MILLI)
        val known = if (isPart) KNOWN_BYTES else bytes.size.toInt()
        if (buffer.byteLength <= known) return null
        bytes = Blob(if (isPart) arrayOf(bytes, buffer.slice(KNOWN_BYTES)) else arrayOf(buffer))
        val cut = if (file.name.endsWith(".wpilog", ignoreCase = true)) 0 else afterLastLine(Uint8Array(buffer))
        val options = json("lastModified" to file.asDynamic().lastModified).unsafeCast<FilePropertyBag>()
        return File(arrayOf(bytes.slice(0, bytes.size.toInt() - cut)), file.name, options).also { it.place = file.place }
    }

    /** Returns how many bytes of [part] are behind its last line, whose row is not whole yet. */
    private fun afterLastLine(part: Uint8Array): Int {
        var end = part.length
        while (end > 0 && part[end - 1] != LINE_FEED) end--
        return part.length - end
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
