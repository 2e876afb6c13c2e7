package badlog.expression

/**
 * How many characters must be put in, left out or replaced to make [other] of [one] (Levenshtein 1966); [limit] when it is as
 * many or more.
 */
internal fun editDistance(one: String, other: String, limit: Int): Int {
    if (kotlin.math.abs(one.length - other.length) >= limit) return limit
    var last = IntArray(other.length + 1) { it }
    var row = IntArray(other.length + 1)
    for (i in one.indices) {
        row[0] = i + 1
        for (j in other.indices) {
            val replaced = last[j] + if (one[i] == other[j]) 0 else 1
            row[j + 1] = minOf(replaced, last[j + 1] + 1, row[j] + 1)
        }
        last = row.also { row = last }
    }
    return minOf(last[other.length], limit)
}
