package badlog.recording

/**
 * Receives the numbers of one topic while its file is read, in place of the recording: its topic then has none, though all else
 * is known of it.
 */
public fun interface NumberSink {
    /** The next row has [number], or NaN for a cell without one; [row] counts from 0. */
    public fun add(row: Int, number: Double)

    public companion object {
        /** Drops the numbers. */
        public val NONE: NumberSink = NumberSink { _, _ -> }
    }
}

/** Decides where the numbers of a file's topics go. Asked once for each topic, before its first row. */
public fun interface NumberSinks {
    /** Where the numbers of the topic [name] with [attributes] go; null for the recording. */
    public fun of(name: String, attributes: List<String>): NumberSink?

    public companion object {
        /** All numbers go to the recording. */
        public val RECORDING: NumberSinks = NumberSinks { _, _ -> null }
    }
}
