package badlog.window.benchmark

import badlog.formats.wpilog.WpilogStream
import badlog.window.app.ViewerScreen
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.concurrent.thread
import kotlin.math.sin

/**
 * Returns the time from the disk to the picture while a log grows and the window is live. The logs have 1, 10 and 40 MB when the window
 * opens them.
 */
internal fun measureLiveFrames(): List<FrameTimes> = listOf(1, 10, 40).map { megabytes ->
    val file = Files.createTempFile("badlog-live", ".wpilog")
    try {
        GrowingLog(file, megabytes * 1_000_000L).use { log ->
            OffScreenWindow { viewer ->
                ViewerScreen(viewer)
            }.use { window -> FrameTimes("$megabytes MB", liveFramesIn(window, file, log)) }
        }
    } finally {
        Files.delete(file)
    }
}

private fun liveFramesIn(window: OffScreenWindow, file: Path, log: GrowingLog): List<Double> {
    val viewer = window.viewer
    val areDrawn = { viewer.graphs.plots.areReady(viewer.compared.drawn, viewer.view.viewport.visible) }
    window.measure({ viewer.loader.open(file) }) { viewer.current.recording != null && areDrawn() }
    log.start()
    window.measure { viewer.live.isGrowing }
    window.measure({ viewer.live.begin() }) { viewer.live.isStaying }
    return List(ROUNDS + WARM_UP) {
        // Starts each measurement at another moment between two looks at the file.
        Thread.sleep(it % 7 * 13L)
        val row = log.lastSecond
        window.measure { checkNotNull(viewer.current.recording).span.to >= row && areDrawn() }
    }.drop(WARM_UP)
}

/** A WPILOG of [TOPICS] topics and [bytes] bytes. Once started, a thread appends 50 rows a second. */
private class GrowingLog(file: Path, bytes: Long) : AutoCloseable {
    private val channel = FileChannel.open(file, StandardOpenOption.WRITE)
    private val stream = WpilogStream { piece, size -> channel.write(ByteBuffer.wrap(piece, 0, size)) }
    private val entries = List(TOPICS) { stream.start("NT:/Robot/Part ${it / 5}/Value $it", "double", "", 0) }
    private var row = 0L
    private val writer = thread(start = false, isDaemon = true) { write() }

    /** The time of the last row that is in the file. */
    @Volatile
    var lastSecond = 0.0
        private set

    init {
        while (channel.size() < bytes) writeRow()
        stream.flush()
    }

    fun start() = writer.start()

    private fun write() {
        try {
            while (true) {
                val second = writeRow()
                stream.flush()
                lastSecond = second
                Thread.sleep(ROW_MILLIS)
            }
        } catch (_: InterruptedException) {
            // The measurement is over.
        }
    }

    private fun writeRow(): Double {
        row++
        val micros = row * ROW_MILLIS * 1000
        for (entry in entries) {
            val payload = ByteBuffer.allocate(Double.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN).putDouble(sin(row * 0.01 + entry)).array()
            stream.record(entry, micros, payload)
        }
        return micros / 1e6
    }

    override fun close() {
        writer.interrupt()
        writer.join()
        channel.close()
    }
}

private const val ROUNDS = 60
private const val WARM_UP = 10

private const val TOPICS = 50
private const val ROW_MILLIS = 20L
