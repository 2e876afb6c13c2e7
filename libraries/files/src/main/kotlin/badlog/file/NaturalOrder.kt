package badlog.file

/** Orders texts as people do: regardless of case, and numbers in them by their value, so that 9 stands before 10. */
public object NaturalOrder : Comparator<String> {
    override fun compare(a: String, b: String): Int {
        var i = 0
        var j = 0
        while (i < a.length && j < b.length) {
            if (isDigit(a[i]) && isDigit(b[j])) {
                val endA = endOfDigits(a, i)
                val endB = endOfDigits(b, j)
                val difference = compareNumbers(a.substring(i, endA).trimStart('0'), b.substring(j, endB).trimStart('0'))
                if (difference != 0) return difference
                i = endA
                j = endB
            } else {
                val difference = a[i++].lowercaseChar().compareTo(b[j++].lowercaseChar())
                if (difference != 0) return difference
            }
        }
        val difference = (a.length - i).compareTo(b.length - j)
        // Texts that only differ in case or in zeros still need an order of their own.
        return if (difference != 0) difference else a.compareTo(b)
    }

    private fun compareNumbers(a: String, b: String) = if (a.length != b.length) a.length.compareTo(b.length) else a.compareTo(b)

    private fun endOfDigits(text: String, from: Int): Int {
        var end = from
        while (end < text.length && isDigit(text[end])) end++
        return end
    }

    private fun isDigit(char: Char) = char in '0'..'9'
}
