package badlog.core.recording

/**
 * A log format that may be read besides the bag, such as WPILOG. Formats are not registered anywhere: code that reads files
 * passes those it knows.
 */
public interface LogFormat : RecordingFormat {
    override val hasRows: Boolean get() = false

    /** The number of bytes at a file's start that [matches] needs. */
    public val signatureSize: Int

    /**
     * Returns whether a file that begins with the first [size] of [bytes] has this format. Fewer than [signatureSize] bytes are the whole
     * file.
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
 * Makes a recording from the bytes of a file, which are pushed to it in pieces of any size. It never throws because of the
 * bytes: whatever is wrong becomes a problem of the recording. Compressed files must be inflated first. Not thread-safe.
 */
public interface LogParser {
    /** The number of rows read so far; of records, if the format has no rows. */
    public val rowCount: Int

    /**
     * The maximum number of rows or records to read: a small compressed file may hold a billion, which would fill the memory. Set it
     * before the first bytes.
     */
    public var maxRows: Int

    /**
     * Whether no further bytes will be read, because there are more rows than [maxRows] or what follows is not a row: they need not be
     * passed.
     */
    public val isFull: Boolean

    /** Reads the bytes from [from] until [until] of [bytes], which follow those of previous calls. Keeps no reference to the array. */
    public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size)

    /** Ends the file, and returns what was read. Call it once, last. */
    public fun finish(): Recording
}
