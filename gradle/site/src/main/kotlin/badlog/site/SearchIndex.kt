package badlog.site

/**
 * The index of the search, as a script: a page on disk may load scripts, but no data.
 *
 * Each section of a guide is one entry; so is each public type of the API.
 */
internal class SearchIndex {
    private val entries = ArrayList<String>()

    /** Adds all sections of [guide], listed in the contents as [title]. */
    fun add(guide: Guide, title: String) {
        for (section in guide.sections) {
            val anchor = if (section.level == 1) "" else "#" + section.anchor
            add(guide.address + anchor, title, if (section.level == 1) guide.title else section.heading, section.text)
        }
    }

    /** Adds the entry for [address]: the page's [title], a [heading] on it, and the [text] below. */
    fun add(address: String, title: String, heading: String, text: String) {
        entries += listOf(address, title, heading, text.replace(SPACES, " ")).joinToString(",", "[", "]", transform = ::quote)
    }

    fun script(): String = entries.joinToString(",\n", "window.searchIndex = [\n", "\n];\n")

    private fun quote(text: String): String = buildString {
        append('"')
        for (char in text) {
            when {
                char == '"' || char == '\\' -> append('\\').append(char)

                char < ' ' || char == '<' || char == '\u2028' || char == '\u2029' -> append(
                    "\\u",
                ).append(char.code.toString(16).padStart(4, '0'))

                else -> append(char)
            }
        }
        append('"')
    }

    private companion object {
        val SPACES = Regex("""\s+""")
    }
}
