package badlog.driverstation

/** What stands one behind the other in a file of the Driver Station: records, or events. */
internal interface Frames {
    /** How many bytes the frame at [at] has; [MORE] where too few have come to know or to take it, [NONE] where none begins. */
    fun sizeAt(bytes: ByteArray, at: Int, until: Int, isEnd: Boolean): Int

    /** Whether the frame at [at], which is whole, is surely one, and not damage that looks like it. */
    fun isSure(bytes: ByteArray, at: Int): Boolean

    /** Reads the frame at [at]. */
    fun take(bytes: ByteArray, at: Int, size: Int)

    /** Says that [bytes] bytes were lost; returns how many frames that was. */
    fun skip(bytes: Int): Int

    companion object {
        const val MORE = 0
        const val NONE = -1
    }
}
