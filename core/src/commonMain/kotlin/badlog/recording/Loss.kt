package badlog.recording

/**
 * How much of a file a [Problem] cost: what stood there, and is in no row of the recording. What a cut took before it came to
 * the file cannot be known and is not counted.
 *
 * @property rows how many rows were dropped.
 * @property cells how many cells were dropped or emptied, whole ones and rests of them, those of [rows] too.
 * @property bytes how many bytes of the file, inflated, were given up.
 */
public data class Loss(public val rows: Int = 0, public val cells: Int = 0, public val bytes: Long = 0) {
    /** The sum of both. */
    public operator fun plus(other: Loss): Loss = Loss(rows + other.rows, cells + other.cells, bytes + other.bytes)

    public companion object {
        /** Nothing was lost. */
        public val NONE: Loss = Loss()
    }
}
