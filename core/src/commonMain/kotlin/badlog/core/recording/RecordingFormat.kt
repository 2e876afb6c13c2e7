package badlog.core.recording

/** The format that a [Recording] was read from: [BAG], [CSV], or a [LogFormat]. */
public interface RecordingFormat {
    /** Its name for programs, such as `wpilog`: in lower case, without spaces. No two formats have the same. */
    public val id: String

    /** What people call one log of this format, such as `WPILOG`; an `s` makes it several. */
    public val title: String

    /** What the names of such files end in: in lower case, each with its dot. A file's content decides what it really is. */
    public val endings: List<String>

    /** Whether all topics share rows; otherwise each has times of its own. */
    public val hasRows: Boolean

    /** Whether a log of this format has the records of a WPILOG, or is read as the records of one. */
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
