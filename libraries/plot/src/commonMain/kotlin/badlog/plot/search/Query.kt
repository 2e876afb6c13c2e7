package badlog.plot.search

/** What a person searches for: each word has to occur, in any order, in capitals or not. */
public class Query(text: String) {
    /** The words, in lower case. */
    public val words: List<String> = text.lowercase().split(' ', '\t').filter { it.isNotEmpty() }

    /** Whether nothing is searched for, so that everything is shown. */
    public val isEmpty: Boolean get() = words.isEmpty()

    /** Whether [text] has every word. */
    public fun matches(text: String): Boolean = isEmpty || matchesLowercase(text.lowercase())

    /** The same for a text that is in lower case already, as what is searched on each key should be. */
    public fun matchesLowercase(text: String): Boolean {
        for (word in words) if (word !in text) return false
        return true
    }
}
