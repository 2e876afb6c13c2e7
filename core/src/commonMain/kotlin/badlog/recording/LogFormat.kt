package badlog.recording

/**
 * A format of logs that a reader of files may know besides the bag, such as the WPILOG. Formats are not registered anywhere:
 * whoever reads files passes those it knows.
 */
public interface LogFormat {
    /** How many bytes of a file's beginning [matches] wants to see. */
    public val signatureSize: Int

    /** Whether a file that begins with the first [size] of [bytes] is of this format; fewer than [signatureSize] are a whole file. */
    public fun matches(bytes: ByteArray, size: Int): Boolean

    /**
     * A parser of one file of this format.
     *
     * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
     */
    public fun parser(keepSamples: Boolean): LogParser
}

/**
 * Makes a recording of the bytes of a file, pushed to it in pieces of any size. Nothing in the bytes makes it throw: whatever is
 * wrong becomes a problem of the recording. Compressed files are to be inflated before. Not safe for use by several threads.
 */
public interface LogParser {
    /** How many rows have been read so far; records, where a format has no rows. */
    public val rowCount: Int

    /**
     * How many rows, or records, are read at most: a small compressed file may hold a billion, which would fill the memory. To be set
     * before the first bytes.
     */
    public var maxRows: Int

    /** Whether nothing that follows is read, because there are more rows than [maxRows] or what follows is none: it need not be given. */
    public val isFull: Boolean

    /** Reads the bytes from [from] until [until] of [bytes], which follow those of the calls before. Keeps no reference. */
    public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size)

    /** Says that the file has ended, and returns what was read. To be called once, last. */
    public fun finish(): Recording
}
