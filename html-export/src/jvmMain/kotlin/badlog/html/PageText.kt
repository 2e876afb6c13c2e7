package badlog.html

/** What every page begins with, in ASCII. */
internal const val PAGE_START = "<!DOCTYPE html"

/** [text] as it may stand between HTML tags, or in an attribute in double quotes, and nowhere become a tag. */
internal fun escapeHtml(text: String): String = text
    .replace("&", "&amp;")
    .replace("<", "&lt;")
    .replace(">", "&gt;")
    .replace("\"", "&quot;")

/** [text] as a JSON string that can stand in a script element: without any `<`, it neither ends nor comments it out. */
internal fun quoteJson(text: String): String = buildString(text.length + 2) {
    append('"')
    for (char in text) {
        when {
            char == '"' || char == '\\' -> append('\\').append(char)

            // Half of a pair alone cannot be written as UTF-8.
            char < ' ' || char == '<' || char.isSurrogate() -> append("\\u").append(char.code.toString(16).padStart(4, '0'))

            else -> append(char)
        }
    }
    append('"')
}
