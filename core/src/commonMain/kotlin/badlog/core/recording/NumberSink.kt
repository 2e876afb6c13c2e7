package badlog.core.recording

/**
 * Receives the numbers of one topic in place of the recording, while the file is read. The topic then has no samples, but is complete
 * otherwise.
 */
public fun interface NumberSink {
    /** Receives the [number] of the next row, or NaN for a cell without one; [row] counts from 0. */
    public fun add(row: Int, number: Double)

    public companion object {
        /** Drops the numbers. */
        public val NONE: NumberSink = NumberSink { _, _ -> }
    }
}

/** Chooses the sink for the numbers of each topic. Called once for each topic, before its first row. */
public fun interface NumberSinks {
    /** Returns the sink for the numbers of the topic [name] with [attributes]; null to keep them in the recording. */
    public fun of(name: String, attributes: List<String>): NumberSink?

    public companion object {
        /** Sends all numbers to the recording. */
        public val RECORDING: NumberSinks = NumberSinks { _, _ -> null }
    }
}
