package badlog.core.recording

/** The format that a [Recording] was read from: [BAG], [CSV], or a [LogFormat]. */
public interface RecordingFormat {
    /** The format's name for programs, such as `wpilog`: in lower case, without spaces. Each format has its own. */
    public val id: String

    /** The name that people use for one log of this format, such as `WPILOG`; its plural ends in `s`. */
    public val title: String

    /** The endings of file names in this format, in lower case, each with its dot. Only the content of a file decides its format. */
    public val endings: List<String>

    /** Whether all topics share rows; otherwise each has times of its own. */
    public val hasRows: Boolean

    /** Whether a log of this format has WPILOG records, or is read as such records. */
    public val hasRecords: Boolean get() = false

    public companion object {
        /** A JSON line, then CSV. */
        public val BAG: RecordingFormat = RowFormat("bag", "bag", listOf(".bag", ".badbag"))

        /** CSV alone: a bag without units, attributes and values. */
        public val CSV: RecordingFormat = RowFormat("csv", "CSV file", listOf(".csv"))
    }
}

private class RowFormat(override val id: String, override val title: String, override val endings: List<String>) : RecordingFormat {
    override val hasRows: Boolean get() = true

    override fun toString(): String = title
}
