package badlog.samples.generated.log

/** Writes the topics of a match into a file while the match goes on. */
internal interface Recorder {
    /** The loop has ended at [time], in s of the log. */
    fun loop(time: Double)

    /** Status frames have arrived at [time], in s of the log. */
    fun frame(time: Double)

    /** Returns the file. Call it once, last. */
    fun bytes(): ByteArray
}
