package badlog.expression

/** What stands before the expression in the definition [text] of a virtual topic, the `=` included. */
internal class VirtualTopicHeading(private val text: String) {
    private var nameEnd = 0

    val name: String
    val unit: String

    /** How many characters it has. */
    val length: Int

    init {
        val scanner = Scanner(text)
        scanner.skipSpace()
        val isQuoted = scanner.at < text.length && text[scanner.at] == '"'
        val quoted = if (isQuoted) scanner.quoted('"', "name") else ""
        val equals = text.indexOf('=', scanner.at)
        if (equals < 0) fail("A virtual topic needs a name and =, as in Power [W] = Voltage * Current.", text.length)
        nameEnd = equals
        val rest = text.substring(scanner.at, equals).trim()
        val bracket = if (rest.endsWith(']')) rest.lastIndexOf('[') else -1
        unit = if (bracket < 0) "" else rest.substring(bracket + 1, rest.length - 1).trim()
        val plainName = if (bracket < 0) rest else rest.substring(0, bracket).trim()
        if (isQuoted && plainName.isNotEmpty()) fail("Between a quoted name and = only a unit may stand, in brackets.")
        name = if (isQuoted) quoted else plainName
        if (name.isBlank()) fail("The virtual topic has no name before =.")
        length = equals + 1
    }

    fun fail(message: String, until: Int = nameEnd): Nothing = throw Mistake(0, until, ExpressionErrorKind.SYNTAX, message)
}
