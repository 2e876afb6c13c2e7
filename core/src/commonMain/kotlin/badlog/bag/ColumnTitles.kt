package badlog.bag

/**
 * The titles of a file's columns, as far as its first two lines and the rows after them agree on them.
 *
 * @property titles a title for each column.
 * @property isDoubtful for each column, whether it may be another's title.
 */
internal class ColumnTitles(val titles: List<String>, val isDoubtful: BooleanArray = BooleanArray(titles.size)) {
    /** The same with each title as [change] makes it. */
    fun map(change: (String) -> String) = ColumnTitles(titles.map(change), isDoubtful)

    companion object {
        /**
         * The titles where line 1 has [names], line 2 has [titles], and the rows have [width] cells, or 0 where that is not known.
         * Line 1 wins where it has as many.
         */
        fun of(names: List<String>, titles: List<String>, width: Int): ColumnTitles = when {
            width == 0 || (titles.size == width && names.size != width) || names.sorted() == titles.sorted() -> ColumnTitles(titles)
            names.size == width -> if (titles.size == width) paired(names, titles) else ofNames(names, titles)
            else -> doubtful(List(width) { titles.getOrElse(it) { "" } })
        }

        private fun doubtful(titles: List<String>) = ColumnTitles(titles, BooleanArray(titles.size) { true })

        /** Some titles differ from the names. */
        private fun paired(names: List<String>, titles: List<String>): ColumnTitles {
            val same = titles.indices.count { titles[it] == names[it] }
            val waiting = names.filterIndexed { index, name -> titles[index] != name }.toMutableList()
            // Where the order of line 2 is another one, a title is where it says.
            val isReordered = same * 2 < names.size
            val pairs = arrayOfNulls<String>(titles.size)
            val isDoubtful = BooleanArray(titles.size)
            for (i in titles.indices) {
                if (titles[i] == names[i]) {
                    pairs[i] = names[i]
                } else if (isReordered && waiting.remove(titles[i])) {
                    pairs[i] = titles[i]
                }
            }
            for (i in titles.indices) {
                if (pairs[i] != null) continue
                pairs[i] = if (!isReordered && waiting.remove(names[i])) names[i] else waiting.removeAt(0)
                isDoubtful[i] = true
            }
            return ColumnTitles(pairs.map { it.orEmpty() }, isDoubtful)
        }

        /** There are too few or too many titles. */
        private fun ofNames(names: List<String>, titles: List<String>): ColumnTitles {
            val waiting = names.indices.groupByTo(HashMap()) { names[it] }
            val found = titles.mapNotNull { waiting[it]?.removeFirstOrNull() }
            val isAtEnd = titles.first() == names.first() || titles.last() == names.last()
            val isInOrder = isAtEnd && found.size * FEW >= names.size && found.zipWithNext().all { (one, next) -> one < next }
            // What a hole leaves may be the beginning or the end of one name.
            val line = names.joinToString(",")
            val rest = titles.joinToString(",")
            if (isInOrder || line.startsWith(rest) || line.endsWith(rest)) return ColumnTitles(names)
            // Line 2 had an order of its own; it is known from its ends on.
            val left = names.toMutableList()
            val first = titles.takeWhile { left.remove(it) }
            val last = titles.drop(first.size).takeLastWhile { left.remove(it) }
            return doubtful(first + left + last)
        }

        /** One of so many titles in the order of line 1 shows that it is theirs. */
        private const val FEW = 4
    }
}
