package badlog.page.view

/** What a person searches for: each word has to occur, in any order, in capitals or not. */
internal class Query(text: String) {
    private val words = text.lowercase().split(' ', '\t').filter { it.isNotEmpty() }

    /** Whether nothing is searched for, so that everything is shown. */
    val isEmpty: Boolean get() = words.isEmpty()

    /** Whether [haystack], which is in lower case, has every word. */
    fun matches(haystack: String): Boolean = words.all { it in haystack }
}
