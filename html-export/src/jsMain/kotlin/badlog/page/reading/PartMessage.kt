package badlog.page.reading

import badlog.bag.BagParser
import badlog.bag.RowBatch
import badlog.bag.RowBatchParser
import badlog.page.embedded.Base64
import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.dom.DedicatedWorkerGlobalScope
import kotlin.js.Promise

/**
 * The messages between the page and a worker about one part of a recording, see [PartsReading].
 *
 * The page sends the base64 and which of its bytes are the part. The worker answers with what they inflate to and, once it
 * knows the columns, with the rows that are complete in it; or with a failure.
 */
internal object PartMessage {
    /** A part for the worker: its number, its bytes from [skipped] until [until] of [base64], and the columns once they are known. */
    fun of(part: Int, base64: String, skipped: Int, until: Int, isLast: Boolean, readsDecimalComma: BooleanArray?): dynamic {
        val message = js("({})")
        message.part = part
        message.base64 = base64
        message.skipped = skipped
        message.until = until
        message.isLast = isLast
        message.columns = readsDecimalComma?.let { columns -> IntArray(columns.size) { if (columns[it]) 1 else 0 } }
        return message
    }

    /** Whether [message], from the page, is a part. */
    fun isPart(message: dynamic): Boolean = message != null && message.part != undefined

    /** Does the worker's work for the part [message]. */
    fun answer(page: DedicatedWorkerGlobalScope, message: dynamic) {
        inflate(message).then { page.postMessage(message, read(message, it)) }.catch { problem ->
            val failure = js("({})")
            failure.failure = problem.message ?: problem.toString()
            page.postMessage(failure)
        }
    }

    /** Gives what the worker answered to [parser], behind the parts before it; returns how many bytes it was. */
    fun take(message: dynamic, parser: BagParser): Int {
        val bytes = message.bytes.unsafeCast<ByteArray>()
        val from = message.from as Int
        val until = message.until as Int
        parser.accept(bytes, 0, from)
        val isTaken = message.numbers != null && parser.accept(batchOf(message))
        if (!isTaken) parser.accept(bytes, from, until)
        parser.accept(bytes, until, bytes.size)
        return bytes.size
    }

    private fun batchOf(message: dynamic) = RowBatch(
        message.numbers.unsafeCast<Array<DoubleArray>>(),
        message.details.unsafeCast<IntArray>(),
        message.texts.unsafeCast<Array<String>>(),
    )

    private fun inflate(message: dynamic): Promise<ByteArray> {
        val decoded = Base64.decode(message.base64 as String).unsafeCast<Int8Array>()
        val skipped = message.skipped as Int
        val compressed = Uint8Array(decoded.buffer, decoded.byteOffset + skipped, message.until as Int - skipped)
        // All parts but the last end in a flush; an empty last block makes whole streams of them.
        val isLast = message.isLast as Boolean
        val pieces: Array<dynamic> = if (isLast) arrayOf(compressed) else arrayOf(compressed, Uint8Array(arrayOf<Byte>(3, 0)))
        message.base64 = null
        val stream: dynamic = js("new DecompressionStream('deflate-raw')")
        val writer = stream.writable.getWriter()
        // The reader below gets the same failures.
        for (piece in pieces) writer.write(piece).then({}, {})
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
        val all = Uint8Array(chunks.sumOf { it.length })
        var at = 0
        for (chunk in chunks) {
            all.set(chunk, at)
            at += chunk.length
        }
        return Int8Array(all.buffer).unsafeCast<ByteArray>()
    }

    /** Puts what is in [bytes] into [message]; returns the buffers that change their owner. */
    private fun read(message: dynamic, bytes: ByteArray): Array<dynamic> {
        val columns = message.columns.unsafeCast<IntArray?>()
        val buffers = ArrayList<dynamic>()
        message.bytes = bytes
        buffers.add(bytes.unsafeCast<Int8Array>().buffer)
        message.from = if (columns == null) bytes.size else bytes.indexOf(LINE_FEED) + 1
        message.until = if (columns == null) bytes.size else bytes.lastIndexOf(LINE_FEED) + 1
        val batch = columns?.let { ints -> RowBatchParser(BooleanArray(ints.size) { ints[it] != 0 }) }
            ?.parse(bytes, message.from as Int, message.until as Int)
        if (batch != null) {
            message.numbers = batch.numbers
            message.details = batch.details
            message.texts = batch.texts
            for (numbers in batch.numbers) if (numbers.isNotEmpty()) buffers.add(numbers.asDynamic().buffer)
        }
        return buffers.toTypedArray()
    }

    private const val LINE_FEED: Byte = 10
}
