package badlog.rules

import badlog.expression.Expression
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.recording.Severity
import badlog.rules.figure.ComparedSignal
import badlog.rules.signal.SignalVocabulary
import org.tomlj.TomlTable
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Reads a file of rules that name topics by [signals]. Throws [RulesException] at the first mistake.
 *
 * @param isBuiltIn whether the file is badlog's own, in which nobody looks for a mistake.
 */
internal class RulesReader(private val source: String, private val signals: SignalVocabulary, private val isBuiltIn: Boolean = false) {
    private val toml = TomlText(source)

    fun read(): RulesFile {
        val root = toml.root(setOf("extends", "off", "limits", "aliases", "rule", "hook", "cause", "leads_to"))
        val own = rules(root, emptyMap())
        val inherited = inherited(root)
        // Causes and effects speak of rules by their names, whoever wrote these.
        val causes = causeGraphOf(toml, root).let { if (isBuiltIn) it else RuleSet.BUILT_IN.causes.after(it) }
        val taken = own.mapTo(HashSet()) { it.name }
        return RulesFile(RuleSet(aliases(root), inherited.filter { it.name !in taken } + own, signals, causes), hooks(root), source)
    }

    /** The built-in rules where the file goes on from them, with its limits and without those that it switches off. */
    private fun inherited(root: TomlTable): List<Rule> {
        val extends = toml.string(root, "extends")
        if (extends != null &&
            extends != DEFAULT
        ) {
            toml.fail(toml.placeOf(root, "extends"), "A file of rules extends “$DEFAULT”, not “$extends”.")
        }
        if (listOf("extends", "off", "limits").none { root.contains(listOf(it)) }) return emptyList()
        val off = toml.optionalStrings(root, "off").toSet()
        val limits = limits(root)
        val rules = RulesReader(resource(RulesFile.NAME), signals, isBuiltIn = true).rules(limits)
        val groups = rules.mapTo(HashSet()) { it.group }
        val names = rules.mapTo(HashSet()) { it.name }
        off.find { it !in names && it !in groups }
            ?.let { toml.fail(toml.placeOf(root, "off"), "There is no built-in rule or group “$it”; docs/rules.md lists them.") }
        limits.keys.find { it !in names }?.let { name ->
            val table = root.get(listOf("limits")) as TomlTable
            toml.fail(toml.placeOf(table, name, isKey = true), "There is no built-in rule “$name”; docs/rules.md lists them.")
        }
        return rules.filter { it.name !in off && it.group !in off }
    }

    /** The rules of the file with other [limits], by the rules' names. */
    fun rules(limits: Map<String, Map<String, Double>>): List<Rule> = rules(toml.root(setOf("rule", "cause", "leads_to")), limits)

    private fun limits(root: TomlTable): Map<String, Map<String, Double>> {
        if (!root.contains(listOf("limits"))) return emptyMap()
        val table = root.get(listOf("limits")) as? TomlTable ?: toml.fail(toml.placeOf(root, "limits"), "“limits” is a table: [limits].")
        return table.keySet().associateWith { name ->
            limitsOf(table.get(listOf(name))) ?: toml.fail(
                toml.placeOf(table, name, isKey = true),
                "Limits are numbers by their names, as in \"Low battery\" = { volts = 6.5 }.",
            )
        }
    }

    private fun limitsOf(value: Any?): Map<String, Double>? {
        val table = value as? TomlTable ?: return null
        return table.keySet().associateWith { (table.get(listOf(it)) as? Number ?: return null).toDouble() }
    }

    private fun aliases(root: TomlTable): List<Alias> {
        if (!root.contains(listOf("aliases"))) return emptyList()
        val table =
            root.get(listOf("aliases")) as? TomlTable ?: toml.fail(toml.placeOf(root, "aliases"), "“aliases” is a table: [aliases].")
        return table.keySet().map { name ->
            if (!isUsable(name)) {
                toml.fail(
                    toml.placeOf(table, name),
                    "“$name” cannot be an alias; use letters, digits and _, but not a word of the language.",
                )
            }
            val value = table.get(listOf(name))
            if (value is TomlTable) {
                toml.requireKnown(value, setOf("names", "unit"), "an alias")
                Alias(name, toml.patterns(value, "names", isNeeded = true), toml.string(value, "unit"))
            } else {
                Alias(name, toml.patterns(table, name, isNeeded = true), null)
            }
        }
    }

    private fun isUsable(name: String): Boolean {
        if (name in RuleProgram.RESERVED || !name.all { it.isLetterOrDigit() || it == '_' }) return false
        val alone = Expression.parse("$name > 0", Vocabulary(listOf(Signal(name, SignalKind.NUMBER, ""))))
        return alone is Expression && alone.topics == listOf(name)
    }

    private fun rules(root: TomlTable, limits: Map<String, Map<String, Double>>): List<Rule> {
        val names = HashSet<String>()
        return toml.tables(root, "rule").map { (table, place) ->
            val rule = rule(table, place, limits)
            if (!names.add(rule.name)) toml.fail(toml.placeOf(table, "name"), "There are two rules named “${rule.name}”.")
            rule
        }
    }

    private fun hooks(root: TomlTable): List<HookCommand> = toml.tables(root, "hook").map { (table, place) ->
        toml.requireKnown(table, setOf("name", "command", "seconds"), "a hook")
        toml.requireKeys(table, place, listOf("command"), "hook")
        val command = toml.string(table, "command").orEmpty()
        val words = try {
            commandWords(command)
        } catch (e: IllegalArgumentException) {
            toml.fail(toml.placeOf(table, "command"), e.message.orEmpty())
        }
        val seconds = when (val value = table.get(listOf("seconds"))) {
            null -> null
            is Number -> value.toDouble().seconds
            else -> Duration.ZERO
        }
        if (seconds?.isPositive() == false) {
            toml.fail(toml.placeOf(table, "seconds"), "“seconds” is a number above 0: how long the hook may take.")
        }
        HookCommand(words, toml.string(table, "name"), seconds)
    }

    private fun rule(table: TomlTable, place: RulePlace, others: Map<String, Map<String, Double>>): Rule {
        toml.requireKnown(table, KEYS, "a rule")
        val isComparison = table.contains(listOf("compare"))
        toml.requireKeys(table, place, listOf("name", "severity", if (isComparison) "limits" else "when", "text"), "rule")
        val name = toml.string(table, "name").orEmpty()
        val severity = toml.string(table, "severity").orEmpty()
        val limits = Limits(table, others[name].orEmpty())
        return Rule(
            name = name,
            severity = Severity.entries.find { it.name.lowercase() == severity }
                ?: toml.fail(toml.placeOf(table, "severity"), "A severity is “error”, “warning” or “note”, not “$severity”."),
            condition = limits.filled(toml.string(table, "when").orEmpty()),
            text = text(table, limits, if (isComparison) RuleText.PLACES_COMPARED else RuleText.PLACES),
            only = toml.optionalStrings(table, "only"),
            each = each(table),
            place = if (isBuiltIn) null else toml.placeOf(table, if (isComparison) "compare" else "when"),
            group = toml.string(table, "group").orEmpty(),
            reason = toml.string(table, "why").orEmpty(),
            next = toml.string(table, "next").orEmpty(),
            show = toml.optionalStrings(table, "show"),
            unless = toml.optionalStrings(table, "unless"),
            isForEachText = toml.isTrue(table, "each_text"),
            compares = if (isComparison) comparison(table, limits) else null,
        )
    }

    private fun comparison(table: TomlTable, limits: Limits): Comparison {
        listOf("when", "each", "except", "unit", "show", "unless", "each_text", "only").find { table.contains(listOf(it)) }
            ?.let { toml.fail(toml.placeOf(table, it, isKey = true), "A rule that compares logs has no “$it”.") }
        val compared = toml.strings(table, "compare")
        compared.find { ComparedSignal.of(it) == null }?.let {
            val known = ComparedSignal.ALL.joinToString { it.signal }
            toml.fail(toml.placeOf(table, "compare"), "There are no figures of “$it” to compare; there are those of: $known.")
        }
        val (deviations, percent, findings, others) = Comparison.LIMITS.map { name ->
            limits.numbers[name]?.takeIf { it >= 0 }
                ?: toml.fail(
                    toml.placeOf(table, "limits"),
                    "A rule that compares logs has these limits: ${Comparison.LIMITS.joinToString()}.",
                )
        }
        return Comparison(compared, deviations, percent, findings.toInt(), maxOf(others.toInt(), Comparison.FEWEST_OTHERS))
    }

    /** The numbers of a rule in [table] that its `when` and `text` have in braces, or those of [others] instead. */
    private inner class Limits(table: TomlTable, others: Map<String, Double>) {
        val numbers: Map<String, Double>

        init {
            val value = table.get(listOf("limits"))
            val own = if (value == null) {
                emptyMap()
            } else {
                limitsOf(value)
                    ?: toml.fail(toml.placeOf(table, "limits"), "“limits” are numbers by their names, as in limits = { volts = 7 }.")
            }
            val taken = own.keys.find { it in RuleText.PLACES && !table.contains(listOf("compare")) }
            if (taken != null) toml.fail(toml.placeOf(table, "limits"), "“$taken” cannot be a limit, for it is a place in texts.")
            val unknown = others.keys.find { it !in own }
            if (unknown != null) {
                val known = own.keys.joinToString().ifEmpty { "none" }
                throw RulesException(1, "The rule “${toml.string(table, "name")}” has no limit “$unknown”; there are: $known.")
            }
            numbers = own + others
        }

        fun filled(text: String): String = numbers.entries.fold(text) { filled, (name, number) -> filled.replace("{$name}", plain(number)) }
    }

    private fun plain(number: Double) = number.toBigDecimal().stripTrailingZeros().toPlainString()

    private fun each(table: TomlTable): TopicChoice? {
        if (!table.contains(listOf("each"))) {
            return listOf("except", "unit").firstOrNull { table.contains(listOf(it)) }
                ?.let { toml.fail(toml.placeOf(table, it), "“$it” says which topics “each” means; without “each” it has no meaning.") }
        }
        val value = table.get(listOf("each"))
        if (value !is TomlTable) {
            return TopicsByName(toml.patterns(table, "each", true), toml.patterns(table, "except", false), toml.string(table, "unit"))
        }
        toml.requireKnown(value, setOf("signal", "with", "linked"), "“each”")
        val names = listOfNotNull(toml.string(value, "signal")) + toml.optionalStrings(value, "with")
        val unknown = names.find { signals.find(it)?.isMany != true }
        if (unknown != null || !value.contains(listOf("signal"))) {
            toml.fail(
                toml.placeOf(table, "each"),
                "“each” names a signal of many topics, as in each = { signal = \"channel current\" }" +
                    if (unknown == null) "." else "; “$unknown” is none.",
            )
        }
        return TopicsOfSignal(names[0], names.drop(1), toml.isTrue(value, "linked"))
    }

    private fun text(table: TomlTable, limits: Limits, places: List<String>): RuleText = try {
        // {others} is a place there, with the word for what they are.
        val text = toml.string(table, "text").orEmpty()
        RuleText.parse(if (places === RuleText.PLACES) limits.filled(text) else text, places)
    } catch (mistake: RuleText.Mistake) {
        val place = toml.placeOf(table, "text")
        throw RulesException(place.lineNumber, place.pointed(mistake.message, mistake.from, mistake.until))
    }

    private companion object {
        /** What the built-in rules are called. */
        const val DEFAULT = "default"
        val KEYS = setOf(
            "name", "severity", "when", "text", "only", "each", "except", "unit", "group", "why", "next", "limits", "show", "unless",
            "each_text", "compare",
        )
    }
}
