package badlog.rules

import badlog.signals.vocabulary.NamePattern
import org.tomlj.Toml
import org.tomlj.TomlArray
import org.tomlj.TomlPosition
import org.tomlj.TomlTable

/** Returns the result of [read], which reads a text of TOML. Throws [RulesException] if the text is nested too deeply. */
internal fun <T> notTooDeep(read: () -> T): T = try {
    read()
} catch (_: StackOverflowError) {
    throw RulesException(1, "It is nested too deeply to be read; a list of texts needs one pair of brackets.")
}

/** A TOML text. All functions throw [RulesException], which names the place, at the first mistake. */
internal class TomlText(source: String) {
    private val source = source.removePrefix(BYTE_ORDER_MARK)
    private val lines = this.source.lines()

    /** Returns the whole text as a table; only keys in [known] are allowed. [what] names the text in messages. */
    fun root(known: Set<String>, what: String = "the file"): TomlTable {
        val root = try {
            Toml.parse(source)
        } catch (_: RuntimeException) {
            // The library fails for some texts instead of naming the mistake, such as an inline table that never ends.
            fail(place(null, null), "This is not TOML: a bracket or a quote is not closed.")
        }
        root.errors().firstOrNull()?.let { error ->
            val said = error.message.orEmpty().lineSequence().first().trim().trimEnd('.')
            fail(place(error.position(), null), "This is not TOML: $said.")
        }
        requireKnown(root, known, what)
        return root
    }

    /** Returns every table of the list [key], with the place where it begins. */
    fun tables(root: TomlTable, key: String): List<Pair<TomlTable, RulePlace>> {
        val array = root.get(listOf(key)) ?: return emptyList()
        val mistake = "Each $key begins with [[$key]], in two brackets."
        if (array !is TomlArray) fail(placeOf(root, key), mistake)
        return (0 until array.size()).map { index ->
            val table = array.get(index) as? TomlTable ?: fail(placeOf(root, key), mistake)
            table to place(array.inputPositionOf(index), null)
        }
    }

    fun requireKnown(table: TomlTable, known: Set<String>, what: String) {
        val unknown = table.keySet().firstOrNull { it !in known } ?: return
        fail(placeOf(table, unknown, isKey = true), "“$unknown” is not a key of $what; the keys are ${known.joinToString()}.")
    }

    fun requireKeys(table: TomlTable, place: RulePlace, keys: List<String>, what: String) {
        for (key in keys) if (!table.contains(listOf(key))) fail(place, "This $what has no “$key”.")
    }

    fun patterns(table: TomlTable, key: String, isNeeded: Boolean): List<NamePattern> =
        if (!isNeeded && !table.contains(listOf(key))) emptyList() else strings(table, key).map(::NamePattern)

    /** Returns the texts of the list [key]; empty if there is none. */
    fun optionalStrings(table: TomlTable, key: String): List<String> = if (table.contains(listOf(key))) strings(table, key) else emptyList()

    fun strings(table: TomlTable, key: String): List<String> {
        val value = table.get(listOf(key))
        val texts = if (value is String) listOf(value) else (value as? TomlArray)?.toList()?.filterIsInstance<String>().orEmpty()
        val isWhole = value is String || (value is TomlArray && value.size() == texts.size)
        if (!isWhole || texts.isEmpty() || texts.any { it.isBlank() }) {
            fail(placeOf(table, key), "“$key” is a list of texts, as in $key = [\"one\", \"two\"].")
        }
        return texts
    }

    fun string(table: TomlTable, key: String): String? {
        val value = table.get(listOf(key)) ?: return null
        if (value !is String || value.isBlank()) fail(placeOf(table, key), "“$key” is a text in quotes.")
        return value
    }

    fun isTrue(table: TomlTable, key: String): Boolean = when (val value = table.get(listOf(key))) {
        null -> false
        is Boolean -> value
        else -> fail(placeOf(table, key), "“$key” is true or false, without quotes.")
    }

    fun placeOf(table: TomlTable, key: String, isKey: Boolean = false): RulePlace =
        place(table.inputPositionOf(listOf(key)), if (isKey) key else table.get(listOf(key)) as? String)

    /** Returns where [text] is on the line of [position], or [position] itself. */
    private fun place(position: TomlPosition?, text: String?): RulePlace {
        val number = (position?.line() ?: 1).coerceIn(1, lines.size)
        val line = lines[number - 1]
        val column = ((position?.column() ?: 1) - 1).coerceIn(0, line.length)
        // The value begins behind its key.
        val found = if (text.isNullOrEmpty()) -1 else line.indexOf(text, maxOf(column, line.indexOf('=') + 1).coerceAtMost(line.length))
        val literal = if (found < 0 && !text.isNullOrEmpty()) line.indexOf(text) else found
        return RulePlace(number, line, if (literal >= 0) literal else column, text.takeIf { literal >= 0 })
    }

    fun fail(place: RulePlace, message: String): Nothing = throw RulesException(place.lineNumber, place.pointed(message))
}

/** The character with which some Windows editors begin a file. */
private const val BYTE_ORDER_MARK = "\uFEFF"
