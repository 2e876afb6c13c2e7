package badlog.page.embedded

import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import kotlin.js.Promise

/**
 * Inflates a gzip stream that arrives in pieces, with the browser's own `DecompressionStream`.
 *
 * It reads while it writes, and never needs a clean end: robots never close their streams, and a stream closed too early discards its
 * buffer. If the browser stops within a stream of several members, [Inflater] does the rest.
 *
 * @param expectedBytes the number of bytes to inflate; reading stops there.
 * @param isWhole whether the stream is known to be a single, complete member, so that it may be closed.
 * @param sink receives the inflated bytes.
 */
internal class Inflation(private val expectedBytes: Double, private val isWhole: Boolean, private val sink: (ByteArray) -> Unit) {
    private val stream: dynamic = js("new DecompressionStream('gzip')")
    private val writer: dynamic = stream.writable.getWriter()
    private val reader: dynamic = stream.readable.getReader()

    // Kept for streams that the browser may not read to the end; robots write these, and they are small.
    private val pieces = ArrayList<ByteArray>()
    private var hasEnded = false
    private var hasStopped = false
    private lateinit var finish: () -> Unit
    private lateinit var fail: (Throwable) -> Unit

    /** The number of bytes inflated so far. */
    var inflatedBytes = 0.0
        private set

    /** Whether the browser found an error in the stream, which has its own checksum. */
    var hasFailed = false
        private set

    /** Fulfilled when there is nothing more to inflate; rejected only if [sink] throws. */
    val finished: Promise<Unit> = Promise { resolve, reject ->
        finish = { resolve(Unit) }
        fail = reject
    }

    init {
        if (expectedBytes <= 0.0) stop() else read()
    }

    /** Accepts the next piece of the stream. The promise is fulfilled when there is room for another. */
    fun accept(compressed: ByteArray): Promise<Unit> = Promise { resolve, _ ->
        if (!isWhole) pieces += compressed
        if (hasStopped) {
            resolve(Unit)
        } else {
            writer.write(compressed).then({ resolve(Unit) }, { resolve(Unit) })
        }
    }

    /** Marks the end of the pieces. Call it when the last one has been accepted. */
    fun end() {
        hasEnded = true
        when {
            hasStopped -> complete()
            isWhole -> writer.close().then({}, {})
            else -> waitForQuiet(inflatedBytes)
        }
    }

    private fun read() {
        reader.read().then({ result: dynamic ->
            if (result.done) stop() else take(result.value.unsafeCast<Uint8Array>())
        }, {
            hasFailed = true
            stop()
        })
    }

    private fun take(chunk: Uint8Array) {
        if (hasStopped) return
        try {
            give(Int8Array(chunk.buffer, chunk.byteOffset, chunk.length).unsafeCast<ByteArray>())
        } catch (problem: Throwable) {
            hasStopped = true
            fail(problem)
            return
        }
        if (inflatedBytes >= expectedBytes) stop() else read()
    }

    private fun give(bytes: ByteArray) {
        inflatedBytes += bytes.size
        sink(bytes)
    }

    // A cut stream never signals its end. It is over if nothing arrives for a while after its last piece.
    private fun waitForQuiet(bytes: Double) {
        js("setTimeout")({
            if (inflatedBytes == bytes) stop() else waitForQuiet(inflatedBytes)
        }, QUIET_MILLISECONDS)
    }

    private fun stop() {
        if (hasStopped) return
        hasStopped = true
        // Otherwise pieces that wait for the reader would wait forever.
        reader.cancel().then({}, {})
        if (isWhole || hasEnded || inflatedBytes >= expectedBytes) complete()
    }

    private fun complete() {
        try {
            if (!isWhole && inflatedBytes < expectedBytes) inflateRest()
            finish()
        } catch (problem: Throwable) {
            fail(problem)
        }
    }

    private fun inflateRest() {
        val all = ByteArray(pieces.sumOf { it.size })
        var end = 0
        for (piece in pieces) {
            piece.copyInto(all, end)
            end += piece.size
        }
        pieces.clear()
        var known = inflatedBytes
        Inflater(all) { bytes ->
            val skipped = minOf(known, bytes.size.toDouble()).toInt()
            known -= skipped
            if (skipped < bytes.size) give(bytes.copyOfRange(skipped, bytes.size))
        }.run()
    }
}

private const val QUIET_MILLISECONDS = 300
