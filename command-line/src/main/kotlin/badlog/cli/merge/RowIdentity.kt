package badlog.cli.merge

/** Tells whether a row of [one] and a row of [other] say the same in every cell; never where their topics differ. */
internal class RowIdentity(one: LogPart, other: LogPart) {
    private val areAlike = one.recording.topics.size == other.recording.topics.size
    private val pairs = one.recording.topics.map { it to other.topic(it.name) }

    /** Whether row [row] of the one is row [otherRow] of the other. */
    fun isSame(row: Int, otherRow: Int): Boolean =
        areAlike && pairs.all { (topic, twin) -> twin != null && isSameCell(topic, row, twin, otherRow) }
}
