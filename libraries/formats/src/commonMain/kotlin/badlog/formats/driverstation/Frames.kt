package badlog.formats.driverstation

/** The sequence of frames in a file of the Driver Station: records, or events. */
internal interface Frames {
    /**
     * Returns the size in bytes of the frame at [at]. Returns [MORE] if too few bytes have arrived to know or to read it, [NONE] if none
     * begins there.
     */
    fun sizeAt(bytes: ByteArray, at: Int, until: Int, isEnd: Boolean): Int

    /** Returns whether the complete frame at [at] is certainly a frame, not damage that looks like one. */
    fun isSure(bytes: ByteArray, at: Int): Boolean

    /** Reads the frame at [at]. */
    fun take(bytes: ByteArray, at: Int, size: Int)

    /** Records that [bytes] bytes were lost. Returns the number of frames in them. */
    fun skip(bytes: Int): Int

    companion object {
        const val MORE = 0
        const val NONE = -1
    }
}
