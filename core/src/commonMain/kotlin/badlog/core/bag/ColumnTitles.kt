package badlog.core.bag

/**
 * The titles of a file's columns, according to its first two lines and the rows after them.
 *
 * @property titles a title for each column.
 * @property isDoubtful for each column, whether its title may belong to another column.
 */
internal class ColumnTitles(val titles: List<String>, val isDoubtful: BooleanArray = BooleanArray(titles.size)) {
    /** Returns these titles with [change] applied to each. */
    fun map(change: (String) -> String) = ColumnTitles(titles.map(change), isDoubtful)

    companion object {
        /**
         * Returns the titles for [names] on line 1, [titles] on line 2, and rows of [width] cells. A [width] of 0 means that it is not
         * known. If line 1 has that many names, it takes precedence.
         */
        fun of(names: List<String>, titles: List<String>, width: Int): ColumnTitles = when {
            width == 0 || (titles.size == width && names.size != width) || names.sorted() == titles.sorted() -> ColumnTitles(titles)
            names.size == width -> if (titles.size == width) paired(names, titles) else ofNames(names, titles)
            else -> doubtful(List(width) { titles.getOrElse(it) { "" } })
        }

        private fun doubtful(titles: List<String>) = ColumnTitles(titles, BooleanArray(titles.size) { true })

        /** Pairs names with titles if some of them differ. */
        private fun paired(names: List<String>, titles: List<String>): ColumnTitles {
            val same = titles.indices.count { titles[it] == names[it] }
            val waiting = names.filterIndexed { index, name -> titles[index] != name }.toMutableList()
            // If line 2 has a different order, its order counts.
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

        /** Uses the names because there are too few or too many titles. */
        private fun ofNames(names: List<String>, titles: List<String>): ColumnTitles {
            val waiting = names.indices.groupByTo(HashMap()) { names[it] }
            val found = titles.mapNotNull { waiting[it]?.removeFirstOrNull() }
            val isAtEnd = titles.first() == names.first() || titles.last() == names.last()
            val isInOrder = isAtEnd && found.size * NAMES_PER_MATCH >= names.size && found.zipWithNext().all { (one, next) -> one < next }
            // A hole may leave only the start or the end of a name.
            val line = names.joinToString(",")
            val rest = titles.joinToString(",")
            if (isInOrder || line.startsWith(rest) || line.endsWith(rest)) return ColumnTitles(names)
            // Line 2 had its own order, which is known from both ends of the line inwards.
            val left = names.toMutableList()
            val first = titles.takeWhile { left.remove(it) }
            val last = titles.drop(first.size).takeLastWhile { left.remove(it) }
            return doubtful(first + left + last)
        }

        /** Line 1's order counts if at least one in this many names is among the titles, in that order. */
        private const val NAMES_PER_MATCH = 4
    }
}
