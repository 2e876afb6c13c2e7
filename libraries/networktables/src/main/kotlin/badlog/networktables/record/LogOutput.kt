package badlog.networktables.record

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.time.Instant
import java.time.temporal.ChronoUnit

/**
 * Writes topics and the recorder's own entries into one log after another in the folder of [options]. Times are the robot's, in µs. Without
 * an open file, nothing is written.
 *
 * Its own entries are `messages` and `systemTime`, as in WPILib's `DataLogManager`; in `Recorder/`, the servers' connections and the number
 * of dropped values.
 */
internal class LogOutput(private val options: RecordOptions) {
    private class Open(val file: LogFile, val messages: Int, val systemTime: Int, val dropped: Int, val droppedBefore: Long) {
        var values = 0L
        var topics = 0
        var late = 0L
        var gaps = 0
        var isMatchKnown = false
        var reportedDropped = 0L
        var wallMicros = Long.MIN_VALUE
    }

    private var open: Open? = null
    private var valuesBefore = 0L

    val isOpen: Boolean get() = open != null

    /** Returns the current progress; [isConnected] is whether the robot's server is connected. */
    fun progress(isConnected: Boolean): RecordProgress {
        val open = open
        return RecordProgress(valuesBefore + (open?.values ?: 0), open?.topics ?: 0, open?.file?.bytes ?: 0, open?.file?.path, isConnected)
    }

    /**
     * Begins a file at [micros] with the topics of [sources] and their current values.
     *
     * @param dropped the number of values dropped so far.
     * @param logMicros converts a server's time to the robot's.
     * @throws java.io.IOException if the file cannot be written; the other functions throw it, too.
     */
    fun open(sources: List<Source>, micros: Long, dropped: Long, logMicros: (Source, Long) -> Long) {
        val file = LogFile.create(options.folder, Instant.now(), micros)
        val open = Open(
            file,
            file.start("messages", "string", OWN_METADATA, micros),
            file.start("systemTime", "int64", "{\"source\":\"badlog\",\"format\":\"time_t_us\"}", micros),
            file.start("Recorder/Dropped Values", "int64", OWN_METADATA, micros),
            dropped,
        )
        this.open = open
        file.record(open.dropped, micros, bytesOf(0))
        for (source in sources) {
            source.connectedEntry = 0
            connected(source, source.isSubscribed, micros)
            source.byName.values.forEach(::forget)
            val isCurrent = source.byId.values.toSet()
            for (topic in source.byName.values) {
                // Topics that the server no longer had after reconnecting are left out.
                if (source.link != null && topic !in isCurrent) continue
                announced(topic, micros)
                if (topic.latest != null) value(topic, logMicros(source, topic.latestMicros))
            }
        }
        tick(micros, dropped)
    }

    /** Ends the file and returns it; null if none is open. [micros] is the current time, [ignored] the number of unreadable values. */
    fun close(micros: Long, dropped: Long, ignored: Long): RecordedFile? {
        val open = open ?: return null
        tick(micros, dropped)
        val lost = dropped - open.droppedBefore
        if (lost > 0) message("$lost values are missing, because the disk was too slow.", micros)
        if (open.late > 0) message("${open.late} values have earlier times than those before them.", micros)
        if (ignored > 0) message("$ignored values or messages of servers could not be read.", micros)
        this.open = null
        valuesBefore += open.values
        open.file.close()
        return RecordedFile(open.file.path, open.values, open.topics, open.file.bytes, lost, open.late, open.gaps)
    }

    /** Records that [topic] exists from [micros] on. */
    fun announced(topic: RecordedTopic, micros: Long) {
        val file = open?.file ?: return
        if (topic.entry == 0) topic.entry = file.start(topic.logName, topic.logType, topic.metadata, micros)
    }

    /** Records that [topic] no longer exists. */
    fun unannounced(topic: RecordedTopic, micros: Long) {
        val file = open?.file ?: return
        if (topic.entry != 0) file.finish(topic.entry, micros)
        forget(topic)
    }

    /** Records the new properties of [topic]. */
    fun described(topic: RecordedTopic, micros: Long) {
        val file = open?.file ?: return
        if (topic.entry != 0) file.changeMetadata(topic.entry, topic.metadata, micros)
    }

    /**
     * Writes the latest value of [topic], set at [micros]. A value from before the file's start is written at its start. Returns false only
     * for the first value in the file that is earlier than the previous one of its topic.
     */
    fun value(topic: RecordedTopic, micros: Long): Boolean {
        val open = open ?: return true
        val payload = topic.latest ?: return true
        val time = maxOf(micros, open.file.startMicros)
        val before = topic.writtenMicros
        val isLate = before != null && time < before
        if (isLate) open.late++
        open.file.record(topic.entry, time, payload)
        topic.writtenMicros = time
        open.values++
        if (before == null) open.topics++
        return !(isLate && open.late == 1L)
    }

    /** Returns whether the file already contains the value [payload] of [topic] at [micros]. */
    fun has(topic: RecordedTopic, micros: Long, payload: ByteArray): Boolean {
        val start = open?.file?.startMicros ?: return false
        val before = topic.writtenMicros ?: return false
        return maxOf(micros, start) <= before && topic.latest.contentEquals(payload)
    }

    /** Records whether the server of [source] is connected from [micros] on. */
    fun connected(source: Source, isConnected: Boolean, micros: Long) {
        val open = open ?: return
        if (!isConnected && source.connectedEntry == 0 && !source.isRobot) return
        if (source.connectedEntry == 0) source.connectedEntry = open.file.start(source.connectedName, "boolean", OWN_METADATA, micros)
        open.file.record(source.connectedEntry, maxOf(micros, open.file.startMicros), byteArrayOf(if (isConnected) 1 else 0))
        if (source.isRobot && !isConnected) open.gaps++
    }

    fun message(text: String, micros: Long) {
        open?.run { file.record(messages, micros, text.encodeToByteArray()) }
    }

    /** Names the log after its match by appending [nameEnd]. */
    fun match(nameEnd: String) {
        val open = open ?: return
        if (open.isMatchKnown) return
        open.isMatchKnown = true
        open.file.rename(nameEnd, retriesOnClose = options.isRenamed)
    }

    /** Writes entries due at [micros], and flushes all data to the disk. */
    fun tick(micros: Long, dropped: Long) {
        val open = open ?: return
        val lost = dropped - open.droppedBefore
        if (lost != open.reportedDropped) {
            open.reportedDropped = lost
            open.file.record(open.dropped, micros, bytesOf(lost))
        }
        if (micros - WALL_MICROS >= open.wallMicros) {
            open.wallMicros = micros
            open.file.record(open.systemTime, micros, bytesOf(ChronoUnit.MICROS.between(Instant.EPOCH, Instant.now())))
        }
        open.file.flush()
    }

    private fun forget(topic: RecordedTopic) {
        topic.entry = 0
        topic.writtenMicros = null
    }

    private fun bytesOf(number: Long) = ByteBuffer.allocate(Long.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN).putLong(number).array()
}

private const val OWN_METADATA = "{\"source\":\"badlog\"}"

/** The time between records of the time of day, as in WPILib's logs. */
private const val WALL_MICROS = 5_000_000L
