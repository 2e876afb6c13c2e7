package badlog.core.recording

/**
 * The text cells of a topic, sparse and without an object per cell. Cell `i` is [dictionary]`[ids[i]]` and is in row [rows]`[i]`. Rows
 * ascend.
 *
 * @property rows the rows, from 0, that have a text; for a topic with times of its own, the indices of its text samples.
 * @property ids for each of [rows], the index of its text in [dictionary]; of the same size.
 * @property dictionary every different text once, in order of first appearance.
 */
public class TextColumn(public val rows: IntArray, public val ids: IntArray, public val dictionary: List<String>) {
    /** The number of cells that have a text. */
    public val size: Int get() = rows.size

    /** Returns the text of cell [index], from 0 until [size]. */
    public operator fun get(index: Int): String = dictionary[ids[index]]

    public companion object {
        /** No texts. */
        public val EMPTY: TextColumn = TextColumn(IntArray(0), IntArray(0), emptyList())
    }
}
