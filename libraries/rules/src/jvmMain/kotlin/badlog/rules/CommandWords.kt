package badlog.rules

/**
 * Returns the words of a [command] line, separated by spaces. In single or double quotes, a space is part of a word. A backslash is an
 * ordinary character, because Windows paths need it. No shell is involved: `$`, `|` and `*` have no special meaning.
 *
 * @throws IllegalArgumentException if a quote is never closed, or the command has no word.
 */
fun commandWords(command: String): List<String> {
    val words = ArrayList<String>()
    val word = StringBuilder()
    var quote: Char? = null
    var isWord = false
    for (char in command) {
        when {
            char == quote -> quote = null

            quote != null -> word.append(char)

            char == '"' || char == '\'' -> {
                quote = char
                isWord = true
            }

            char.isWhitespace() -> {
                if (isWord) words += word.toString()
                word.clear()
                isWord = false
            }

            else -> {
                word.append(char)
                isWord = true
            }
        }
    }
    require(quote == null) { "In the command “$command” a quote ($quote) is never closed." }
    if (isWord) words += word.toString()
    require(words.isNotEmpty()) { "The command of the hook is empty." }
    return words
}
