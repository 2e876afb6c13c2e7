package badlog.samples.generated.log

/** Writes the topics of a match into a file while the match goes on. */
internal interface Recorder {
    /** Called at the end of a loop, at [time] s of the log. */
    fun loop(time: Double)

    /** Called when status frames have arrived, at [time] s of the log. */
    fun frame(time: Double)

    /** Returns the file. Call it once, at the end. */
    fun bytes(): ByteArray
}
