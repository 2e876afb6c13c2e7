package badlog.rules

import badlog.expression.Expression
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.recording.Severity
import org.tomlj.Toml
import org.tomlj.TomlArray
import org.tomlj.TomlPosition
import org.tomlj.TomlTable
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/** Reads a file of rules. Throws [RulesException] at the first mistake. */
internal class RulesReader(private val source: String) {
    private val lines = source.lines()

    fun read(): RulesFile {
        val root = Toml.parse(source)
        root.errors().firstOrNull()?.let { error ->
            val said = error.message.orEmpty().lineSequence().first().trim().trimEnd('.')
            fail(place(error.position(), null), "This is not TOML: $said.")
        }
        requireKnown(root, setOf("aliases", "rule", "hook"), "the file")
        return RulesFile(RuleSet(aliases(root), rules(root)), hooks(root), source)
    }

    private fun aliases(root: TomlTable): List<Alias> {
        if (!root.contains(listOf("aliases"))) return emptyList()
        val table = root.get(listOf("aliases")) as? TomlTable ?: fail(placeOf(root, "aliases"), "“aliases” is a table: [aliases].")
        return table.keySet().map { name ->
            if (!isUsable(name)) {
                fail(placeOf(table, name), "“$name” cannot be an alias; use letters, digits and _, but not a word of the language.")
            }
            val value = table.get(listOf(name))
            if (value is TomlTable) {
                requireKnown(value, setOf("names", "unit"), "an alias")
                Alias(name, patterns(value, "names", isNeeded = true), string(value, "unit"))
            } else {
                Alias(name, patterns(table, name, isNeeded = true), null)
            }
        }
    }

    private fun isUsable(name: String): Boolean {
        if (name in RuleProgram.RESERVED || !name.all { it.isLetterOrDigit() || it == '_' }) return false
        val alone = Expression.parse("$name > 0", Vocabulary(listOf(Signal(name, SignalKind.NUMBER, ""))))
        return alone is Expression && alone.topics == listOf(name)
    }

    private fun rules(root: TomlTable): List<Rule> {
        val names = HashSet<String>()
        return tables(root, "rule").map { (table, place) ->
            val rule = rule(table, place)
            if (!names.add(rule.name)) fail(placeOf(table, "name"), "There are two rules named “${rule.name}”.")
            rule
        }
    }

    private fun hooks(root: TomlTable): List<HookCommand> = tables(root, "hook").map { (table, place) ->
        requireKnown(table, setOf("name", "command", "seconds"), "a hook")
        if (!table.contains(listOf("command"))) fail(place, "This hook has no “command”.")
        val command = string(table, "command").orEmpty()
        val words = try {
            commandWords(command)
        } catch (e: IllegalArgumentException) {
            fail(placeOf(table, "command"), e.message.orEmpty())
        }
        val seconds = when (val value = table.get(listOf("seconds"))) {
            null -> null
            is Number -> value.toDouble().seconds
            else -> Duration.ZERO
        }
        if (seconds?.isPositive() == false) fail(placeOf(table, "seconds"), "“seconds” is a number above 0: how long the hook may take.")
        HookCommand(words, string(table, "name"), seconds)
    }

    /** Every table of the list [key], and where it begins. */
    private fun tables(root: TomlTable, key: String): List<Pair<TomlTable, RulePlace>> {
        val array = root.get(listOf(key)) ?: return emptyList()
        val mistake = "Each $key begins with [[$key]], in two brackets."
        if (array !is TomlArray) fail(placeOf(root, key), mistake)
        return (0 until array.size()).map { index ->
            val table = array.get(index) as? TomlTable ?: fail(placeOf(root, key), mistake)
            table to place(array.inputPositionOf(index), null)
        }
    }

    private fun rule(table: TomlTable, place: RulePlace): Rule {
        requireKnown(table, KEYS, "a rule")
        for (key in listOf("name", "severity", "when", "text")) {
            if (!table.contains(listOf(key))) fail(place, "This rule has no “$key”.")
        }
        val severity = string(table, "severity").orEmpty()
        val each = if (table.contains(listOf("each"))) {
            TopicChoice(patterns(table, "each", true), patterns(table, "except", false), string(table, "unit"))
        } else {
            listOf("except", "unit").firstOrNull { table.contains(listOf(it)) }
                ?.let { fail(placeOf(table, it), "“$it” says which topics “each” means; without “each” it has no meaning.") }
        }
        return Rule(
            name = string(table, "name").orEmpty(),
            severity = Severity.entries.find { it.name.lowercase() == severity }
                ?: fail(placeOf(table, "severity"), "A severity is “error”, “warning” or “note”, not “$severity”."),
            condition = string(table, "when").orEmpty(),
            text = text(table),
            only = if (table.contains(listOf("only"))) strings(table, "only") else emptyList(),
            each = each,
            place = placeOf(table, "when"),
        )
    }

    private fun text(table: TomlTable): RuleText = try {
        RuleText.parse(string(table, "text").orEmpty())
    } catch (mistake: RuleText.Mistake) {
        val place = placeOf(table, "text")
        throw RulesException(place.lineNumber, place.pointed(mistake.message, mistake.from, mistake.until))
    }

    private fun requireKnown(table: TomlTable, known: Set<String>, what: String) {
        val unknown = table.keySet().firstOrNull { it !in known } ?: return
        fail(placeOf(table, unknown, isKey = true), "“$unknown” is not a key of $what; the keys are ${known.joinToString()}.")
    }

    private fun patterns(table: TomlTable, key: String, isNeeded: Boolean): List<NamePattern> {
        if (!isNeeded && !table.contains(listOf(key))) return emptyList()
        return strings(table, key).map(::NamePattern)
    }

    private fun strings(table: TomlTable, key: String): List<String> {
        val value = table.get(listOf(key))
        val texts = if (value is String) listOf(value) else (value as? TomlArray)?.toList()?.filterIsInstance<String>().orEmpty()
        val isWhole = value is String || (value is TomlArray && value.size() == texts.size)
        if (!isWhole || texts.isEmpty() || texts.any { it.isBlank() }) {
            fail(placeOf(table, key), "“$key” is a list of texts, as in $key = [\"one\", \"two\"].")
        }
        return texts
    }

    private fun string(table: TomlTable, key: String): String? {
        val value = table.get(listOf(key)) ?: return null
        if (value !is String || value.isBlank()) fail(placeOf(table, key), "“$key” is a text in quotes.")
        return value
    }

    private fun placeOf(table: TomlTable, key: String, isKey: Boolean = false): RulePlace =
        place(table.inputPositionOf(listOf(key)), if (isKey) key else table.get(listOf(key)) as? String)

    /** Where [text] stands on the line of [position], or [position] itself. */
    private fun place(position: TomlPosition?, text: String?): RulePlace {
        val number = (position?.line() ?: 1).coerceIn(1, lines.size)
        val line = lines[number - 1]
        val column = ((position?.column() ?: 1) - 1).coerceIn(0, line.length)
        // The value begins behind its key.
        val found = if (text.isNullOrEmpty()) -1 else line.indexOf(text, maxOf(column, line.indexOf('=') + 1).coerceAtMost(line.length))
        val literal = if (found < 0 && !text.isNullOrEmpty()) line.indexOf(text) else found
        return RulePlace(number, line, if (literal >= 0) literal else column, text.takeIf { literal >= 0 })
    }

    private fun fail(place: RulePlace, message: String): Nothing = throw RulesException(place.lineNumber, place.pointed(message))

    private companion object {
        val KEYS = setOf("name", "severity", "when", "text", "only", "each", "except", "unit")
    }
}
