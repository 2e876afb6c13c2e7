package badlog.signals.match

/** Orders texts as people do. Case does not matter, and numbers in them count by their value, so that 9 comes before 10. */
public object NaturalOrder : Comparator<String> {
    override fun compare(a: String, b: String): Int {
        var i = 0
        var j = 0
        while (i < a.length && j < b.length) {
            if (isDigit(a[i]) && isDigit(b[j])) {
                val endA = endOfDigits(a, i)
                val endB = endOfDigits(b, j)
                val difference = compareNumbers(a, i, endA, b, j, endB)
                if (difference != 0) return difference
                i = endA
                j = endB
            } else {
                val one = a[i++]
                val other = b[j++]
                val difference = if (one == other) 0 else one.lowercaseChar().compareTo(other.lowercaseChar())
                if (difference != 0) return difference
            }
        }
        val difference = (a.length - i).compareTo(b.length - j)
        // Texts that differ only in case or in zeros still need a definite order.
        return if (difference != 0) difference else a.compareTo(b)
    }

    /** Compares the digits from [i] until [endA] of [a] with those from [j] until [endB] of [b], as numbers. */
    private fun compareNumbers(a: String, i: Int, endA: Int, b: String, j: Int, endB: Int): Int {
        var one = i
        var other = j
        while (one < endA && a[one] == '0') one++
        while (other < endB && b[other] == '0') other++
        if (endA - one != endB - other) return (endA - one).compareTo(endB - other)
        while (one < endA) {
            val difference = a[one++].compareTo(b[other++])
            if (difference != 0) return difference
        }
        return 0
    }

    private fun endOfDigits(text: String, from: Int): Int {
        var end = from
        while (end < text.length && isDigit(text[end])) end++
        return end
    }

    private fun isDigit(char: Char) = char in '0'..'9'
}
