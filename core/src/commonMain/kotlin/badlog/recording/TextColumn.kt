package badlog.recording

/**
 * The text cells of a topic, sparse and without an object per cell: cell `i` is [dictionary]`[ids[i]]` and stands in row
 * [rows]`[i]`. Rows ascend.
 *
 * @property rows the rows, from 0, that have a text; where the topic has times of its own, its samples that are one.
 * @property ids for each of [rows], the place of its text in [dictionary]; same size.
 * @property dictionary every different text once, in the order in which they were met.
 */
public class TextColumn(public val rows: IntArray, public val ids: IntArray, public val dictionary: List<String>) {
    /** How many cells have a text. */
    public val size: Int get() = rows.size

    /** The text of cell [index], from 0 until [size]. */
    public operator fun get(index: Int): String = dictionary[ids[index]]

    public companion object {
        /** No texts. */
        public val EMPTY: TextColumn = TextColumn(IntArray(0), IntArray(0), emptyList())
    }
}
