package badlog.recording

/**
 * A named, united, attributed stream of samples, one for each row of its recording.
 *
 * @property name the full name, unique in its recording; `/` makes folders, see [PathName].
 * @property unit the unit as the file gives it; `ul` and the empty text mean none.
 * @property attributes the attributes as the file gives them, in its order.
 * @property samples one number for each row, NaN where the cell has none; of size 0 when no cell has a number. Not to be
 *   changed.
 * @property texts the cells that hold a text.
 * @property counts what the cells held.
 */
public class Topic(
    public val name: String,
    public val unit: String,
    public val attributes: List<String>,
    public val samples: DoubleArray,
    public val texts: TextColumn,
    public val counts: CellCounts,
) {
    /** What the cells turned out to be. */
    public val kind: TopicKind = kindOf(counts)

    /**
     * Whether fewer than half of the rows have a number, and those mostly stand alone. Such a topic is sampled at times of its
     * own, as in a CSV file made from a log of changes: its empty cells are no gaps, there just was no sample.
     */
    public val isSparse: Boolean
        get() {
            val withoutNumber = counts.empty.toLong() + counts.texts
            val withNumber = counts.total - withoutNumber
            return withoutNumber > withNumber && withNumber < ALONE * counts.gaps
        }

    public companion object {
        /** The unit of a topic that has none. */
        public const val UNITLESS: String = "ul"

        /** On average so many numbers between two gaps still count as standing alone. */
        private const val ALONE = 2L

        internal fun kindOf(counts: CellCounts): TopicKind {
            val numeric = counts.numbers + counts.notFinite + counts.truthValues
            return when {
                numeric == 0 && counts.texts == 0 -> TopicKind.EMPTY
                counts.texts > numeric -> if (counts.texts * 2L >= counts.total) TopicKind.STATE else TopicKind.EVENT
                counts.truthValues == numeric -> TopicKind.BOOLEAN
                else -> TopicKind.NUMERIC
            }
        }
    }
}
