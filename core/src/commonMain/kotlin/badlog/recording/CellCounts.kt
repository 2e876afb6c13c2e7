package badlog.recording

/**
 * How many cells of a topic held what. The first five add up to the topic's [size][Topic.size], so every cell is accounted
 * for. Where topics have times of their own, a sample is a cell and a neighbouring sample a neighbouring row.
 *
 * @property numbers finite numbers.
 * @property notFinite `NaN` and infinities that were written as such.
 * @property truthValues `true` and `false`.
 * @property texts any other text.
 * @property empty nothing, `null`, or a cell that its row lacks.
 * @property gaps into how many runs of neighbouring rows the cells without a number fall.
 */
public data class CellCounts(
    public val numbers: Int,
    public val notFinite: Int,
    public val truthValues: Int,
    public val texts: Int,
    public val empty: Int,
    public val gaps: Int,
) {
    /** The number of cells. */
    public val total: Int get() = numbers + notFinite + truthValues + texts + empty
}
