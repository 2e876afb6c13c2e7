package badlog.core.recording

/** A log format other than the bag, such as WPILOG. Formats are not registered: code that reads files passes the formats it knows.  */
public interface LogFormat : RecordingFormat {
    override val hasRows: Boolean get() = false

    /** The number of bytes at a file's start that [matches] needs. */
    public val signatureSize: Int

    /**
     * Returns whether a file that begins with the first [size] of [bytes] has this format. If [size] is less than [signatureSize], they are
     * the whole file.
     */
    public fun matches(bytes: ByteArray, size: Int): Boolean

    /**
     * Creates a parser for one file of this format.
     *
     * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
     */
    public fun parser(keepSamples: Boolean): LogParser
}

/**
 * Makes a recording from the bytes of a file, which arrive in pieces of any size. It never throws because of the bytes: anything wrong in
 * them becomes a problem of the recording. Compressed files must be inflated first. Not thread-safe.
 */
public interface LogParser {
    /** The number of rows read so far, or of records if the format has no rows. */
    public val rowCount: Int

    /**
     * The maximum number of rows or records to read. Set it before the first bytes. A small compressed file may hold a billion rows, which
     * would fill the memory.
     */
    public var maxRows: Int

    /**
     * Whether the rest of the file will not be read, and need not be passed. Either there are more rows than [maxRows], or the following
     * bytes are not rows.
     */
    public val isFull: Boolean

    /** Reads the next bytes of the file, from [from] until [until] of [bytes]. Keeps no reference to the array. */
    public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size)

    /** Ends the file, and returns the recording. Call it once, last. */
    public fun finish(): Recording
}
