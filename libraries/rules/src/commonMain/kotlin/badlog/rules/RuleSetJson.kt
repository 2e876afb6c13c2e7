package badlog.rules

import badlog.core.json.JsonMember
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Severity
import badlog.rules.cause.CauseGraph
import badlog.rules.standing.PROVEN_TRUST
import badlog.rules.standing.Standing
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonArray
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.fromJson
import badlog.signals.vocabulary.patterns
import badlog.signals.vocabulary.patternsJson
import badlog.signals.vocabulary.toJson

/**
 * Returns these rules as a line of JSON, with everything that decides their findings in a log. Every page contains that line, so reasons
 * are omitted; the guide has them.
 *
 * @param haveChecklist whether to add the parts that pages do not show: the items of the checklist, and the sentences of silent rules.
 */
fun RuleSet.toJson(haveChecklist: Boolean = false): String = jsonObject(
    "aliases" to jsonList(aliases, ::aliasJson),
    "rules" to jsonArray(rules) { ruleJson(it, haveChecklist) },
    "signals" to signals.toJson(),
    "causes" to causes.toJson(),
    "comparisons" to jsonList(comparisons, ::comparisonJson),
    "devices" to jsonList(devices.devices, ::deviceJson),
)

/** Returns the rules in [text], or null if [RuleSet.toJson] did not write it. */
fun RuleSet.Companion.fromJson(text: String): RuleSet? = fromJson(JsonReader.readObject(text))

/** Returns the rules in an object with [members], or null if [RuleSet.toJson] did not write it, or [members] is null. */
fun RuleSet.Companion.fromJson(members: List<JsonMember>?): RuleSet? = try {
    val json = JsonFields(members)
    val signals = json.find("signals")?.let { SignalVocabulary.fromJson(it) } ?: throw UnreadableJsonException()
    val causes = json.find("causes")?.let(CauseGraph::fromJson) ?: CauseGraph.NONE
    val devices = DeviceNames(json.list("devices", ::deviceOf))
    val comparisons = json.list("comparisons", ::comparisonOf)
    RuleSet(json.list("aliases", ::aliasOf), json.list("rules", ::ruleOf), signals, causes, comparisons, devices)
} catch (_: UnreadableJsonException) {
    null
}

private fun aliasJson(alias: Alias): String = jsonObject(
    "name" to quotedJson(alias.name),
    "names" to patternsJson(alias.names),
    "unit" to alias.unit?.let(::quotedJson),
)

private fun aliasOf(value: JsonValue): Alias {
    val json = JsonFields(value.members)
    return Alias(json.string("name"), json.patterns("names"), json.optional("unit"))
}

private fun ruleJson(rule: Rule, hasChecklist: Boolean): String = jsonObject(
    "name" to quotedJson(rule.name),
    "severity" to quotedJson(rule.severity.name.lowercase()),
    "when" to quotedJson(rule.condition),
    "text" to quotedJson(rule.text.source).takeIf { hasChecklist || rule.standing != Standing.SILENT },
    "only" to textsJson(rule.only),
    "each" to rule.each?.let(::choiceJson),
    "next" to textJson(rule.next).takeIf { hasChecklist || rule.standing != Standing.SILENT },
    "show" to textsJson(rule.show),
    "unless" to textsJson(rule.unless),
    "eachText" to "true".takeIf { rule.isForEachText },
    "needs" to textsJson(rule.needs.map { it.name }),
    "aboutProgram" to "true".takeIf { rule.isBuiltIn && rule.isForSimulations },
    "once" to "true".takeIf { rule.isOncePerEvent },
    "trust" to trustJson(rule.trust),
    "checklist" to if (hasChecklist) textJson(rule.checklist) else null,
    "place" to rule.place?.let { placeJson(it, rule.condition) },
)

private fun ruleOf(value: JsonValue): Rule {
    val json = JsonFields(value.members)
    val condition = json.string("when")
    return Rule(
        name = json.string("name"),
        severity = severityOf(json.string("severity")),
        condition = condition,
        text = textOf(json.optional("text").orEmpty()),
        only = json.strings("only"),
        each = json.find("each")?.let(::choiceOf),
        place = json.find("place")?.let { placeOf(it, condition) },
        next = json.optional("next").orEmpty(),
        show = json.strings("show"),
        unless = json.strings("unless"),
        isForEachText = json.isTrue("eachText"),
        needs = LogEdge.entries.filter { it.name in json.strings("needs") },
        checklist = json.optional("checklist").orEmpty(),
        isAboutProgram = json.isTrue("aboutProgram"),
        isOncePerEvent = json.isTrue("once"),
        trust = json.trust(),
    )
}

/** Returns the severity called [name], regardless of case. */
internal fun severityOf(name: String): Severity =
    Severity.entries.find { it.name.equals(name, ignoreCase = true) } ?: throw UnreadableJsonException()

/** Returns the text parsed from [source], which may contain only the placeholders [places]. */
internal fun textOf(source: String, places: List<String> = RuleText.PLACES): RuleText = try {
    RuleText.parse(source, places)
} catch (_: RuleText.Mistake) {
    throw UnreadableJsonException()
}

/** Returns [trust] as JSON; null for [PROVEN_TRUST], the default. */
internal fun trustJson(trust: Double): String? = trust.takeIf { it < PROVEN_TRUST }?.toString()

/** Returns the trust that [trustJson] wrote. */
internal fun JsonFields.trust(): Double =
    find("trust")?.json?.let { it.toDoubleOrNull() ?: throw UnreadableJsonException() } ?: PROVEN_TRUST

private fun choiceJson(choice: TopicChoice): String = when (choice) {
    is TopicsByName -> jsonObject(
        "names" to patternsJson(choice.patterns),
        "except" to patternsJson(choice.except),
        "unit" to choice.unit?.let(::quotedJson),
    )

    is TopicsOfSignal -> jsonObject(
        "signal" to quotedJson(choice.signal),
        "with" to textsJson(choice.with),
        "linked" to "true".takeIf { choice.isLinked },
        "ids" to "true".takeIf { choice.hasIds },
    )
}

private fun choiceOf(value: JsonValue): TopicChoice {
    val json = JsonFields(value.members)
    val signal = json.optional("signal") ?: return TopicsByName(json.patterns("names"), json.patterns("except"), json.optional("unit"))
    return TopicsOfSignal(signal, json.strings("with"), json.isTrue("linked"), json.isTrue("ids"))
}

// Most conditions are alone on their lines, so these lines need not be written twice.
private fun placeJson(place: RulePlace, condition: String): String = jsonObject(
    "number" to place.lineNumber.toString(),
    "line" to place.line.takeIf { it != usualLine(condition) }?.let(::quotedJson),
    "column" to place.column.toString(),
    "isLiteral" to "true".takeIf { place.literal != null },
)

private fun usualLine(condition: String) = "when = ${quotedJson(condition)}"

private fun placeOf(value: JsonValue, condition: String): RulePlace {
    val json = JsonFields(value.members)
    val line = json.optional("line") ?: usualLine(condition)
    return RulePlace(json.number("number"), line, json.number("column"), condition.takeIf { json.isTrue("isLiteral") })
}

private fun textJson(text: String) = if (text.isEmpty()) null else quotedJson(text)

private fun textsJson(texts: List<String>) = jsonList(texts, ::quotedJson)
