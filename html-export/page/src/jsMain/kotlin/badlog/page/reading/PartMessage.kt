package badlog.page.reading

import badlog.core.bag.BagParser
import badlog.core.bag.RowBatch
import badlog.core.bag.RowBatchParser
import badlog.page.embedded.Base64
import badlog.protocol.Crc32
import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.dom.DedicatedWorkerGlobalScope
import kotlin.js.Promise

/**
 * The messages between the page and a worker about one part of a recording, see [PartsReading].
 *
 * The page sends the base64 and, once known, the columns. The worker answers with the CRC-32 of the decoded bytes, the inflated bytes and,
 * if it knows the columns, the complete rows in them; or with a failure.
 */
internal object PartMessage {
    /** Returns the message with the part [part] for the worker, and the columns if they are known. */
    fun of(part: Int, base64: String, readsDecimalComma: BooleanArray?): dynamic {
        val message = js("({})")
        message.part = part
        message.base64 = base64
        message.columns = readsDecimalComma?.let { columns -> IntArray(columns.size) { if (columns[it]) 1 else 0 } }
        return message
    }

    /** Returns whether [message], from the page, is a part. */
    fun isPart(message: dynamic): Boolean = message != null && message.part != undefined

    /** Processes the part [message] in the worker and answers [page]. */
    fun answer(page: DedicatedWorkerGlobalScope, message: dynamic) {
        val deflated = Base64.decode(message.base64 as String)
        message.crc = Crc32().apply { update(deflated) }.value
        inflate(deflated).then { page.postMessage(message, read(message, it)) }.catch { problem ->
            val failure = js("({})")
            failure.failure = problem.message ?: problem.toString()
            page.postMessage(failure)
        }
    }

    /** Passes the worker's answer to [parser], after the previous parts. Returns the number of bytes. */
    fun take(message: dynamic, parser: BagParser): Int {
        val bytes = message.bytes.unsafeCast<ByteArray>()
        val from = message.from as Int
        val until = message.until as Int
        parser.accept(bytes, 0, from)
        val isTaken = message.numbers != undefined && parser.accept(batchOf(message))
        if (!isTaken) parser.accept(bytes, from, until)
        parser.accept(bytes, until, bytes.size)
        return bytes.size
    }

    private fun batchOf(message: dynamic): RowBatch {
        val details = message.details.unsafeCast<IntArray>()
        val rows = details[0]
        val numbers = Array((message.numbers.length as Int) / rows) { column ->
            message.numbers.subarray(column * rows, (column + 1) * rows).unsafeCast<DoubleArray>()
        }
        return RowBatch(numbers, details, message.texts.unsafeCast<Array<String>>())
    }

    private fun inflate(deflated: ByteArray): Promise<ByteArray> {
        val stream: dynamic = js("new DecompressionStream('deflate-raw')")
        val writer = stream.writable.getWriter()
        // A part ends in a flush, and an empty last block makes it a complete stream. The reader below reports the same failures.
        writer.write(deflated).then({}, {})
        writer.write(Uint8Array(arrayOf<Byte>(3, 0))).then({}, {})
        writer.close().then({}, {})
        return readAll(stream.readable.getReader(), ArrayList())
    }

    private fun readAll(reader: dynamic, chunks: ArrayList<Uint8Array>): Promise<ByteArray> = Promise { resolve, reject ->
        fun read() {
            reader.read().then({ result: dynamic ->
                if (result.done as Boolean) {
                    resolve(joined(chunks))
                } else {
                    chunks.add(result.value.unsafeCast<Uint8Array>())
                    read()
                }
            }, reject)
        }
        read()
    }

    private fun joined(chunks: List<Uint8Array>): ByteArray {
        // Usually there is only one.
        val all = chunks.singleOrNull { it.length > 0 } ?: Uint8Array(chunks.sumOf { it.length }).apply {
            var at = 0
            for (chunk in chunks) {
                set(chunk, at)
                at += chunk.length
            }
        }
        return Int8Array(all.buffer, all.byteOffset, all.length).unsafeCast<ByteArray>()
    }

    /** Puts the content of [bytes] into [message]. Returns the buffers to transfer. */
    private fun read(message: dynamic, bytes: ByteArray): Array<dynamic> {
        message.base64 = null
        message.bytes = bytes
        message.from = bytes.indexOf(LINE_FEED) + 1
        message.until = bytes.lastIndexOf(LINE_FEED) + 1
        val buffer = bytes.asDynamic().buffer
        val columns = message.columns.unsafeCast<IntArray?>() ?: return arrayOf(buffer)
        val batch = parserFor(columns).parse(bytes, message.from as Int, message.until as Int) ?: return arrayOf(buffer)
        // All in one buffer, because transferring each buffer takes time.
        val count = batch.rowCount
        val numbers = DoubleArray(count * columns.size)
        batch.numbers.forEachIndexed { column, samples -> samples.copyInto(numbers, column * count, 0, count) }
        message.numbers = numbers
        message.details = batch.details
        message.texts = batch.texts
        return arrayOf(buffer, numbers.asDynamic().buffer)
    }

    // Shared by all parts, which have the same columns.
    private var rows: RowBatchParser? = null

    private fun parserFor(columns: IntArray) = rows ?: RowBatchParser(BooleanArray(columns.size) { columns[it] != 0 }).also { rows = it }

    private const val LINE_FEED: Byte = 10
}
