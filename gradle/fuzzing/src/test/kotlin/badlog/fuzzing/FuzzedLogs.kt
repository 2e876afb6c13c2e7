package badlog.fuzzing

import badlog.core.bag.BagParser
import badlog.core.bag.RecordingParser
import badlog.core.bag.describe
import badlog.core.recording.LogParser
import badlog.core.recording.Recording
import badlog.files.ReadOptions
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.describeLog
import java.nio.file.Files
import java.nio.file.Path

/** The sizes of the pieces in which bytes arrive: all at once, and pieces that end inside most structures. */
private val PIECES = listOf(Int.MAX_VALUE, 7, 61)

private fun parseInPieces(parser: LogParser, bytes: ByteArray, piece: Int): Recording {
    var at = 0
    while (at < bytes.size) {
        val until = if (piece > bytes.size - at) bytes.size else at + piece
        parser.accept(bytes, at, until)
        at = until
    }
    return parser.finish()
}

/** Reads [bytes] in all sizes of [PIECES] by parsers from [make], and checks that the results are the same. */
private fun readPieces(bytes: ByteArray, make: () -> LogParser, text: (Recording) -> String) {
    val recordings = PIECES.map { parseInPieces(make(), bytes, it) }
    val texts = recordings.map(text)
    for ((piece, other) in PIECES zip texts) check(other == texts[0]) { "In pieces of $piece: $other\nAt once: ${texts[0]}" }
    for (topic in recordings[0].topics) {
        val times = topic.times ?: continue
        check(times.size == topic.size) { "“${topic.name}” has ${topic.size} samples at ${times.size} times." }
        for (i in 1 until times.size) check(times[i - 1] <= times[i]) { "“${topic.name}” goes back in time at $i." }
    }
}

internal fun readBag(bytes: ByteArray) = readPieces(bytes, { RecordingParser(LOG_FORMATS, true) { BagParser() } }, ::describe)

internal fun readWpilog(bytes: ByteArray) = readPieces(bytes, { WpilogFormat.parser(keepSamples = true) }, ::describeLog)

internal fun readStationLog(bytes: ByteArray) = readPieces(bytes, { DriverStationFormat.parser(keepSamples = true) }, ::describeLog)

/** Reads a log with a message `p`. Its descriptor and its content are in [bytes], after two bytes with the descriptor's length. */
internal fun readProtobuf(bytes: ByteArray) {
    if (bytes.size < 2) return
    val size = ((bytes[0].toInt() and 0xFF shl 8) or (bytes[1].toInt() and 0xFF)).coerceAtMost(bytes.size - 2)
    val descriptor = bytes.copyOfRange(2, 2 + size)
    val message = bytes.copyOfRange(2 + size, bytes.size)
    val log = TestLog().start(1, "p", "proto:a.M").start(2, "/.schema/proto:a.proto", "proto:FileDescriptorProto")
    // The last row is half of the message, so that its lists are shorter than before.
    readWpilog(log.record(1, 1, message).record(2, 2, descriptor).record(1, 3, message).record(1, 4, message.copyOf(message.size / 2)).bytes)
}

/** The file for bytes read as a `.revlog`, a format that is recognized when a file is opened. */
private val REVLOG: Path by lazy { Files.createTempFile("fuzz", ".revlog").also { it.toFile().deleteOnExit() } }

internal fun readRevlog(bytes: ByteArray) {
    Files.write(REVLOG, bytes)
    readRecording(REVLOG, LOG_FORMATS, ReadOptions(cores = 1))
}
