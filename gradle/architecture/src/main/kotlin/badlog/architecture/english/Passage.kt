package badlog.architecture.english

/**
 * A piece of English in a file: a comment, or a guide without its code.
 *
 * @property line the line on which it begins, from 1.
 */
internal class Passage(val line: Int, val text: String)

/** Returns the English in [text], the content of the file called [name]; empty for files of other kinds. */
internal fun passagesOf(name: String, text: String): List<Passage> = when (name.substringAfterLast('.')) {
    "md" -> listOf(Passage(1, withoutCode(text)))
    "py" -> comments(text, PYTHON, listOf("#", RAW))
    in C_LIKE -> comments(text, C, listOf("/"))
    else -> emptyList()
}

private fun comments(text: String, tokens: Regex, begins: List<String>): List<Passage> {
    var line = 1
    var counted = 0
    return tokens.findAll(text).filter { token -> begins.any(token.value::startsWith) }.map { token ->
        line += text.substring(counted, token.range.first).count { it == '\n' }
        counted = token.range.first
        Passage(line, TAG.replace(withoutCode(token.value), ""))
    }.toList()
}

/** Returns [text] with only the line breaks of its code, so that the others keep their lines. */
private fun withoutCode(text: String) = CODE.replace(text) { code -> "`" + code.value.filter { it == '\n' } }

private val C_LIKE = setOf("kt", "kts", "java", "gradle", "cpp", "h")
private const val RAW = "\"\"\""
private const val STRING = """"(?:[^"\\\n]++|\\.)*+"|'(?:[^'\\\n]++|\\.)*+'"""

/** Comments and strings: whichever begins first hides the other one inside it. */
private val C = Regex("""/\*[\s\S]*?\*/|//[^\n]*|"{3}[\s\S]*?"{3}|$STRING""")
private val PYTHON = Regex("""#[^\n]*|"{3}[\s\S]*?"{3}|$STRING""")
private val CODE = Regex("""```[\s\S]*?```|`[^`\n]*`""")

/** The name after a tag of KDoc is code, too. */
private val TAG = Regex("""@(?:param|property) \w+""")
