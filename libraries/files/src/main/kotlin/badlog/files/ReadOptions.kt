package badlog.files

import badlog.core.recording.NumberSinks

/**
 * How [readRecording] and [readLog] read a log.
 *
 * @property keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @property untilLastLineEnd true to ignore everything after the file's last line end, or everything if there is none: part of a row in a
 *   file that is still being written is not a problem. The same applies to part of a record at the end of a log of records. Has no effect
 *   on a compressed file.
 * @property sinks receives the numbers of a bag or CSV file that the recording does not keep; it always keeps texts and counts. It and its
 *   sinks are called on one thread at a time, though not always the same one, and not the calling one; all calls have returned when the log
 *   has been read. Each sink receives each row once, in order. Not used for logs of records.
 * @property cores the number of cores for reading a large file; 1 for only the calling thread, if others read other files meanwhile.
 * @property name the name of the log, if the file temporarily has another one; null for the name of the file.
 * @property maker makes one log from a file that contains several; null if such files are not read.
 */
public class ReadOptions(
    public val keepSamples: Boolean = true,
    public val untilLastLineEnd: Boolean = false,
    public val sinks: NumberSinks = NumberSinks.RECORDING,
    public val cores: Int = Runtime.getRuntime().availableProcessors(),
    public val name: String? = null,
    public val maker: LogMaker? = null,
)
