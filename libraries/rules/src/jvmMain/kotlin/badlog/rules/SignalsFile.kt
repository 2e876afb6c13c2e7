package badlog.rules

import badlog.core.json.quotedJson
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.NamedUnit
import badlog.signals.vocabulary.SignalContent
import badlog.signals.vocabulary.SignalName
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.TopicPattern
import badlog.signals.vocabulary.flagReadingOf
import org.tomlj.TomlArray
import org.tomlj.TomlTable

/** A file with the names of signals in logs; `docs/signals.md` describes its format. */
object SignalsFile {
    /** The name of such a file among logs. */
    const val NAME: String = "badlog-signals.toml"

    /** The source text of the built-in vocabulary. */
    val builtInSource: String by lazy { resource(NAME) }

    /**
     * Reads [text], which is TOML.
     *
     * @throws RulesException at the first mistake.
     */
    fun parse(text: String): SignalVocabulary = notTooDeep { SignalsReader(TomlText(text)).read() }

    /**
     * Returns [text], the content of such a file, with [topic] as the first name of [signal]. Everything else in it stays as it is.
     *
     * @throws RulesException if [text] has a mistake, or is written in a way that only a person can change.
     */
    fun withTopic(text: String, signal: String, topic: String): String {
        val written = parse(text).find(signal)
        val made = if (written == null) {
            val before = if (text.isBlank()) "" else text.trimEnd() + "\n\n"
            "$before[[signal]]\nname = ${quotedJson(signal)}\ntopics = [${quotedJson(topic)}]\n"
        } else {
            withFirst(text, signal, topic)
        }
        val isFirst = parse(made).find(signal)?.topics?.first()?.pattern?.text == topic
        if (!isFirst) throw RulesException(1, "The signal “$signal” cannot be changed here; add “$topic” to its topics in an editor.")
        return made
    }

    /** Returns [text] with [topic] before the other topics of [signal]. */
    private fun withFirst(text: String, signal: String, topic: String): String {
        val toml = TomlText(text)
        val table = toml.tables(toml.root(SignalsReader.ROOT), "signal").map { it.first }.first { toml.string(it, "name") == signal }
        val place = checkNotNull(table.inputPositionOf(listOf("topics")))
        val line = (1 until place.line()).fold(0) { at, _ -> text.indexOf('\n', at) + 1 }
        val value = text.indexOf('=', line + place.column() - 1) + 1
        val at = value + text.substring(value).takeWhile { it.isWhitespace() }.length
        if (text[at] == '[') return text.substring(0, at + 1) + "${quotedJson(topic)}, " + text.substring(at + 1)
        // A single name in quotes.
        val end = text.indexOf(text[at], at + 1) + 1
        return text.substring(0, at) + "[${quotedJson(topic)}, ${text.substring(at, end)}]" + text.substring(end)
    }
}

private class SignalsReader(private val toml: TomlText) {
    fun read(): SignalVocabulary {
        val root = toml.root(ROOT)
        val names = HashSet<String>()
        val signals = toml.tables(root, "signal").map { (table, place) ->
            val signal = signal(table, place)
            if (!names.add(signal.name)) toml.fail(toml.placeOf(table, "name"), "There are two signals named “${signal.name}”.")
            signal
        }
        return SignalVocabulary(signals, units(root), toml.tables(root, "linked").map { (table, place) -> linked(table, place) })
    }

    private fun signal(table: TomlTable, place: RulePlace): SignalName {
        toml.requireKnown(table, KEYS, "a signal")
        toml.requireKeys(table, place, listOf("name", "topics"), "signal")
        val name = toml.string(table, "name").orEmpty()
        if (!name[0].isLetter() || !name.all { it.isLetterOrDigit() || it in " _" }) {
            toml.fail(toml.placeOf(table, "name"), "A signal's name begins with a letter and has letters, digits and spaces, not “$name”.")
        }
        val written = toml.string(table, "is") ?: "number"
        val content = SignalContent.entries.find { it.name.lowercase() == written }
            ?: toml.fail(toml.placeOf(table, "is"), "A signal is a “number”, a “condition” or a “text”, not “$written”.")
        return SignalName(
            name = name,
            meaning = toml.string(table, "means").orEmpty(),
            content = content,
            unit = toml.string(table, "unit"),
            topics = topics(table).onEach { requireReading(table, content, it) },
            except = toml.patterns(table, "except", isNeeded = false),
            isMany = toml.isTrue(table, "many"),
            sumOf = toml.string(table, "sum_of"),
            atMost = number(table, "at_most"),
        )
    }

    private fun number(table: TomlTable, key: String): Double? = when (val value = table.get(listOf(key))) {
        null -> null
        is Number -> value.toDouble()
        else -> toml.fail(toml.placeOf(table, key), "“$key” is a number, as in $key = 16.")
    }

    private fun requireReading(table: TomlTable, content: SignalContent, topic: TopicPattern) {
        val reading = topic.unit.takeIf { content == SignalContent.CONDITION } ?: return
        if (flagReadingOf(reading) != null) return
        val mistake = "A condition is read as “not”, “bit 3” or “is TEXT”, not as “$reading”."
        toml.fail(toml.placeOf(table, "topics"), mistake)
    }

    /** Returns names, or pairs of a name and the unit in such logs. For a condition, a name and how it is read. */
    private fun topics(table: TomlTable): List<TopicPattern> {
        val value = table.get(listOf("topics"))
        if (value is String) return listOf(TopicPattern(NamePattern(value), null))
        val mistake = "“topics” is a list of names or pairs, as in topics = [\"Arm/Angle\", [\"Arm/Pos\", \"rad\"]]."
        return (value as? TomlArray)?.toList().orEmpty().map { item ->
            val pair = (item as? TomlArray)?.toList().orEmpty().filterIsInstance<String>()
            when {
                item is String && item.isNotBlank() -> TopicPattern(NamePattern(item), null)
                pair.size == 2 -> TopicPattern(NamePattern(pair[0]), pair[1])
                else -> toml.fail(toml.placeOf(table, "topics"), mistake)
            }
        }.ifEmpty { toml.fail(toml.placeOf(table, "topics"), mistake) }
    }

    private fun units(root: TomlTable): List<NamedUnit> {
        if (!root.contains(listOf("units"))) return emptyList()
        val mistake = "“units” must be a table of name endings and their units: [units]."
        val table = root.get(listOf("units")) as? TomlTable ?: toml.fail(toml.placeOf(root, "units"), mistake)
        return table.keySet().map { NamedUnit(it, toml.string(table, it).orEmpty()) }
    }

    private fun linked(table: TomlTable, place: RulePlace): List<NamePattern> {
        toml.requireKnown(table, setOf("motors"), "linked motors")
        toml.requireKeys(table, place, listOf("motors"), "list of linked motors")
        val motors = toml.strings(table, "motors")
        if (motors.size < 2) {
            toml.fail(toml.placeOf(table, "motors"), "“motors” needs at least two motors that turn together, as in [\"A\", \"B\"].")
        }
        return motors.map(::NamePattern)
    }

    companion object {
        /** The keys of the file. */
        val ROOT = setOf("signal", "units", "linked")
        private val KEYS = setOf("name", "means", "is", "unit", "topics", "except", "many", "sum_of", "at_most")
    }
}
