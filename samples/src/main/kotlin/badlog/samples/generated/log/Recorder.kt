package badlog.samples.generated.log

/** Writes the topics of a match into a file while the match goes on. */
internal interface Recorder {
    /** Called at the end of a loop, at [time] on the log's clock, in s. */
    fun loop(time: Double)

    /** Called when status frames have arrived, at [time] on the log's clock, in s. */
    fun frame(time: Double)

    /** Returns the file. Call it once, at the end. */
    fun bytes(): ByteArray
}
