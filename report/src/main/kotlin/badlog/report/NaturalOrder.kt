package badlog.report

/** Texts regardless of case, with the numbers in them by their size; equal ones by their characters. */
internal val NATURAL: Comparator<String> = Comparator<String>(::compareNaturally).thenComparing(naturalOrder())

private fun compareNaturally(a: String, b: String): Int {
    var i = 0
    var j = 0
    while (i < a.length && j < b.length) {
        if (a[i] in '0'..'9' && b[j] in '0'..'9') {
            val first = digitsAt(a, i)
            val second = digitsAt(b, j)
            val order = compareValuesBy(first, second, { it.trimStart('0').length }, { it.trimStart('0') })
            if (order != 0) return order
            i += first.length
            j += second.length
        } else {
            val order = a[i++].lowercaseChar().compareTo(b[j++].lowercaseChar())
            if (order != 0) return order
        }
    }
    return (a.length - i).compareTo(b.length - j)
}

private fun digitsAt(text: String, from: Int): String {
    var until = from
    while (until < text.length && text[until] in '0'..'9') until++
    return text.substring(from, until)
}
