package badlog.networktables.record

import badlog.core.waiting.eventually
import badlog.formats.wpilog.record.RecordEntry
import badlog.formats.wpilog.record.RecordLog
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes

/** A running recorder and its messages. It uses [clock], or this computer's clock if that is null, as WPILib's servers do. */
internal class Running(val folder: Path, servers: List<RecordedServer>, options: RecordOptions, clock: StillClock?) :
    RecordListener,
    AutoCloseable {
    val events = CopyOnWriteArrayList<String>()
    val files = CopyOnWriteArrayList<RecordedFile>()
    val recorder = if (clock == null) Recorder(servers, options, this) else Recorder(servers, options, this) { clock.micros }

    override fun connected(name: String, address: ServerAddress) {
        events += "connected $name"
    }

    override fun disconnected(name: String, reason: String) {
        events += "disconnected $name: $reason"
    }

    override fun finished(file: RecordedFile) {
        files += file
    }

    override fun noted(message: String) {
        events += message
    }

    fun count(what: String) = events.count { it.startsWith(what) }

    /** Ends it, and returns its files in the order in which they were begun. */
    fun logs(): List<RecordLog> {
        close()
        return files.map { logIn(it.path) }
    }

    /**
     * Waits until the only log on the disk [predicate]. It advances [clock] meanwhile, because the recorder flushes periodically, but slowly
     * enough that no server counts as silent.
     */
    fun awaitOnDisk(clock: StillClock, predicate: (RecordLog) -> Boolean) = eventually("what was sent to be on the disk") {
        clock.advance(1_000)
        predicate(folder.onlyLog())
    }

    override fun close() = recorder.close()
}

/** Records [servers], which share one clock, while [action] runs. */
internal fun recording(
    vararg servers: FakeServer,
    isPerEnable: Boolean = false,
    isWanted: ((String) -> Boolean)? = null,
    isRenamed: Boolean = true,
    action: (Running) -> Unit,
) = recording(
    servers.mapIndexed { index, server ->
        RecordedServer(listOf("robot", "Driver Station")[index], listOf("NT:", "DS:")[index], isMirror = index == 1) { ServerAddress("127.0.0.1", server.port) }
    },
    isPerEnable,
    isWanted,
    isRenamed,
    servers[0].clock,
    action,
)

internal fun recording(
    servers: List<RecordedServer>,
    isPerEnable: Boolean = false,
    isWanted: ((String) -> Boolean)? = null,
    isRenamed: Boolean = true,
    clock: StillClock? = null,
    action: (Running) -> Unit,
) {
    val folder = Files.createTempDirectory("badlog")
    try {
        Running(folder, servers, RecordOptions(folder, isPerEnable, isWanted, isRenamed), clock).use { running ->
            running.recorder.start()
            action(running)
        }
    } finally {
        folder.toFile().deleteRecursively()
    }
}

internal fun logIn(file: Path): RecordLog = RecordLog.Reader().run {
    accept(file.readBytes())
    finish()
}

/** The only file in this folder, as it is now. */
internal fun Path.onlyLog(): RecordLog = logIn(listDirectoryEntries().single { it.name.endsWith(".wpilog") })

internal fun RecordLog.entry(name: String): RecordEntry = entries.single { it.name == name }

internal fun RecordEntry.payloads(): List<ByteArray> = List(size, ::payload)

internal fun RecordEntry.times(): List<Double> = List(size, ::time)

internal fun RecordEntry.texts(): List<String> = payloads().map { it.decodeToString() }

internal fun RecordEntry.truths(): List<Boolean> = payloads().map { it.single().toInt() != 0 }

internal fun RecordEntry.numbers(): List<Double> = payloads().map { ByteBuffer.wrap(it).order(ByteOrder.LITTLE_ENDIAN).getDouble() }

internal fun RecordEntry.longs(): List<Long> = payloads().map { ByteBuffer.wrap(it).order(ByteOrder.LITTLE_ENDIAN).getLong() }
