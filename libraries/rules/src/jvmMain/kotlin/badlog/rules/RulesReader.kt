package badlog.rules

import badlog.core.recording.Severity
import badlog.expression.Expression
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.rules.number.ComparedSignal
import badlog.rules.standing.PROVEN_TRUST
import badlog.rules.standing.UNCOUNTED_TRUST
import badlog.signals.DERIVED_NAMES
import badlog.signals.vocabulary.SignalVocabulary
import org.tomlj.TomlTable
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Reads a file of rules that refer to topics by [signals]. Throws [RulesException] at the first mistake.
 *
 * @param isBuiltIn whether the file is badlog's own: users need not look for a mistake in it.
 * @param trust returns the trust in a built-in rule from its name and the hash of its text.
 */
internal class RulesReader(
    private val source: String,
    private val signals: SignalVocabulary,
    private val isBuiltIn: Boolean = false,
    private val trust: (name: String, hash: String) -> Double = ::countedTrust,
) {
    private val toml = TomlText(source)

    fun read(): RulesFile {
        val root = toml.root(setOf("extends", "off", "limits", "aliases", "rule", "comparison", "hook", "cause", "leads_to"))
        val own = read(root, emptyMap())
        val inherited = inherited(root)
        // Causes and effects refer to rules by name, whoever wrote them.
        val causes = causeGraphOf(toml, root).let { if (isBuiltIn) it else RuleSet.BUILT_IN.causes.after(it) }
        val taken = own.names
        val rules = inherited.rules.filter { it.name !in taken } + own.rules
        val comparisons = inherited.comparisons.filter { it.name !in taken } + own.comparisons
        return RulesFile(RuleSet(aliases(root), rules, signals, causes, comparisons), hooks(root), source)
    }

    /** The rules and comparisons of a file. */
    private class Parts(val rules: List<Rule>, val comparisons: List<ComparisonRule>) {
        val names get() = rules.mapTo(HashSet()) { it.name } + comparisons.map { it.name }
        val groups get() = rules.mapTo(HashSet()) { it.group } + comparisons.map { it.group }
    }

    /** Returns the built-in rules if the file extends them, with its limits, and without those that it disables. */
    private fun inherited(root: TomlTable): Parts {
        val extends = toml.string(root, "extends")
        if (extends != null && extends != DEFAULT) {
            toml.fail(toml.placeOf(root, "extends"), "“extends” can only be “$DEFAULT”, not “$extends”.")
        }
        if (listOf("extends", "off", "limits").none { root.contains(listOf(it)) }) return Parts(emptyList(), emptyList())
        val off = toml.optionalStrings(root, "off").toSet()
        val limits = limits(root)
        val parts = RulesReader(resource(RulesFile.NAME), signals, isBuiltIn = true).readWith(limits)
        val (names, groups) = parts.names to parts.groups
        off.find { it !in names && it !in groups }
            ?.let { toml.fail(toml.placeOf(root, "off"), "There is no built-in rule or group “$it”; docs/rules.md lists them.") }
        limits.keys.find { it !in names }?.let { name ->
            val table = root.get(listOf("limits")) as TomlTable
            toml.fail(toml.placeOf(table, name, isKey = true), "There is no built-in rule “$name”; docs/rules.md lists them.")
        }
        return Parts(
            parts.rules.filter { it.name !in off && it.group !in off },
            parts.comparisons.filter { it.name !in off && it.group !in off },
        )
    }

    /** Returns the content of the file with other [limits], given by the rules' names. */
    private fun readWith(limits: Map<String, Map<String, Double>>): Parts =
        read(toml.root(setOf("rule", "comparison", "cause", "leads_to")), limits)

    private fun limits(root: TomlTable): Map<String, Map<String, Double>> {
        if (!root.contains(listOf("limits"))) return emptyMap()
        val table = root.get(listOf("limits")) as? TomlTable
            ?: toml.fail(toml.placeOf(root, "limits"), "“limits” must be a table: [limits].")
        return table.keySet().associateWith { name ->
            limitsOf(table.get(listOf(name))) ?: toml.fail(
                toml.placeOf(table, name, isKey = true),
                "Limits are names with numbers, as in \"Low battery\" = { volts = 6.5 }.",
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
            root.get(listOf("aliases")) as? TomlTable ?: toml.fail(toml.placeOf(root, "aliases"), "“aliases” must be a table: [aliases].")
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

    private fun read(root: TomlTable, limits: Map<String, Map<String, Double>>): Parts {
        val names = HashSet<String>()
        fun <T> all(key: String, read: (TomlTable, RulePlace) -> T) = toml.tables(root, key).map { (table, place) ->
            val name = toml.string(table, "name")
            if (name != null && !names.add(name)) toml.fail(toml.placeOf(table, "name"), "There are two rules named “$name”.")
            read(table, place)
        }
        return Parts(
            all("rule") { table, place -> rule(table, place, limits) },
            all("comparison") { table, place -> comparison(table, place, limits) },
        )
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
        toml.requireKeys(table, place, listOf("name", "severity", "when", "text"), "rule")
        val name = toml.string(table, "name").orEmpty()
        val limits = Limits(table, others[name].orEmpty(), RuleText.PLACES)
        val trust = trustIn(table, hasOwnLimits = name in others)
        return Rule(
            name = name,
            severity = severity(table, trust),
            condition = limits.filled(toml.string(table, "when").orEmpty()),
            text = text(table, limits, RuleText.PLACES),
            only = toml.optionalStrings(table, "only"),
            each = each(table),
            place = if (isBuiltIn) null else toml.placeOf(table, "when"),
            group = toml.string(table, "group").orEmpty(),
            reason = toml.string(table, "why").orEmpty(),
            next = toml.string(table, "next").orEmpty(),
            show = toml.optionalStrings(table, "show"),
            unless = toml.optionalStrings(table, "unless"),
            isForEachText = toml.isTrue(table, "each_text"),
            needs = needs(table),
            checklist = toml.string(table, "checklist").orEmpty(),
            isAboutProgram = toml.isTrue(table, "about_program"),
            isOncePerEvent = toml.isTrue(table, "once"),
            trust = trust,
        )
    }

    /** Returns the trust in the rule of [table]. Whoever sets one of its limits wants to hear it, also if it is silent. */
    private fun trustIn(table: TomlTable, hasOwnLimits: Boolean): Double {
        if (!isBuiltIn) return PROVEN_TRUST
        val counted = trust(toml.string(table, "name").orEmpty(), hashOf(table))
        return if (hasOwnLimits) maxOf(counted, UNCOUNTED_TRUST) else counted
    }

    private fun needs(table: TomlTable): List<LogEdge> {
        val value = table.get(listOf("whole"))
        if (value == null || value is Boolean) return if (value == true) LogEdge.entries else emptyList()
        return LogEdge.entries.filter { it.name.lowercase() == value }.ifEmpty {
            toml.fail(toml.placeOf(table, "whole"), "“whole” is true, “start” or “end”: the parts of a log that the rule needs.")
        }
    }

    /** Returns the severity in [table]; a built-in rule has it once it is proven. */
    private fun severity(table: TomlTable, trust: Double): Severity {
        val severity = toml.string(table, "severity").orEmpty()
        val own = Severity.entries.find { it.name.lowercase() == severity }
            ?: toml.fail(toml.placeOf(table, "severity"), "A severity is “error”, “warning” or “note”, not “$severity”.")
        return if (trust < PROVEN_TRUST) Severity.NOTE else own
    }

    private fun comparison(table: TomlTable, place: RulePlace, others: Map<String, Map<String, Double>>): ComparisonRule {
        toml.requireKnown(table, COMPARISON_KEYS, "a comparison")
        toml.requireKeys(table, place, listOf("name", "severity", "of", "limits", "text"), "comparison")
        val signals = toml.strings(table, "of")
        signals.find { ComparedSignal.of(it) == null }?.let { signal ->
            val known = ComparedSignal.ALL.joinToString { it.signal }
            toml.fail(toml.placeOf(table, "of"), "“$signal” cannot be compared; use one of: $known.")
        }
        val name = toml.string(table, "name").orEmpty()
        val limits = Limits(table, others[name].orEmpty(), ComparisonRule.PLACES - ComparisonRule.LIMITS.toSet())
        val trust = trustIn(table, hasOwnLimits = name in others)
        val (deviations, percent, findings, fewest) = ComparisonRule.LIMITS.map { limit ->
            limits.numbers[limit]?.takeIf { it >= 0 }
                ?: toml.fail(toml.placeOf(table, "limits"), "A comparison has these limits: ${ComparisonRule.LIMITS.joinToString()}.")
        }
        return ComparisonRule(
            name = name,
            severity = severity(table, trust),
            group = toml.string(table, "group").orEmpty(),
            next = toml.string(table, "next").orEmpty(),
            text = text(table, null, ComparisonRule.PLACES),
            signals = signals,
            deviations = deviations,
            percent = percent,
            findings = findings.toInt(),
            others = maxOf(fewest.toInt(), ComparisonRule.MIN_OTHERS),
            trust = trust,
        )
    }

    /** The limits of a rule in [table], which its `when` and `text` have in braces; [others] override them. */
    private inner class Limits(table: TomlTable, others: Map<String, Double>, places: List<String>) {
        val numbers: Map<String, Double>

        init {
            val value = table.get(listOf("limits"))
            val own = if (value == null) {
                emptyMap()
            } else {
                limitsOf(value)
                    ?: toml.fail(toml.placeOf(table, "limits"), "“limits” must be names with numbers, as in limits = { volts = 7 }.")
            }
            val taken = own.keys.find { it in places }
            if (taken != null) toml.fail(toml.placeOf(table, "limits"), "“$taken” cannot be a limit, because it is a placeholder in texts.")
            val unknown = others.keys.find { it !in own }
            if (unknown != null) {
                val known = own.keys.joinToString().ifEmpty { "none" }
                throw RulesException(1, "The rule “${toml.string(table, "name")}” has no limit “$unknown”; its limits are: $known.")
            }
            numbers = own + others
        }

        fun filled(text: String): String = numbers.entries.fold(text) { filled, (name, number) -> filled.replace("{$name}", plain(number)) }
    }

    private fun plain(number: Double) = number.toBigDecimal().stripTrailingZeros().toPlainString()

    private fun each(table: TomlTable): TopicChoice? {
        if (!table.contains(listOf("each"))) {
            return listOf("except", "unit").firstOrNull { table.contains(listOf(it)) }
                ?.let { toml.fail(toml.placeOf(table, it), "“$it” selects topics for “each”, which is missing; add “each”.") }
        }
        val value = table.get(listOf("each"))
        if (value !is TomlTable) {
            return TopicsByName(toml.patterns(table, "each", true), toml.patterns(table, "except", false), toml.string(table, "unit"))
        }
        toml.requireKnown(value, setOf("signal", "with", "linked", "ids"), "“each”")
        val names = listOfNotNull(toml.string(value, "signal")) + toml.optionalStrings(value, "with")
        val unknown = names.find { signals.find(it)?.isMany != true && it !in DERIVED_NAMES }
        if (unknown != null || !value.contains(listOf("signal"))) {
            toml.fail(
                toml.placeOf(table, "each"),
                "“each” needs a signal of many topics, as in each = { signal = \"channel current\" }" +
                    if (unknown == null) "." else "; “$unknown” is not one.",
            )
        }
        return TopicsOfSignal(names[0], names.drop(1), toml.isTrue(value, "linked"), toml.isTrue(value, "ids"))
    }

    private fun text(table: TomlTable, limits: Limits?, places: List<String>): RuleText = try {
        val text = toml.string(table, "text").orEmpty()
        RuleText.parse(limits?.filled(text) ?: text, places)
    } catch (mistake: RuleText.Mistake) {
        val place = toml.placeOf(table, "text")
        throw RulesException(place.lineNumber, place.pointed(mistake.message, mistake.from, mistake.until))
    }

    private companion object {
        /** The name of the built-in rules. */
        const val DEFAULT = "default"
        val KEYS = setOf(
            "name", "severity", "when", "text", "only", "each", "except", "unit", "group", "why", "next", "limits", "show", "unless",
            "each_text", "whole", "checklist", "about_program", "once",
        )
        val COMPARISON_KEYS = setOf("name", "severity", "of", "text", "group", "why", "next", "limits")
    }
}
