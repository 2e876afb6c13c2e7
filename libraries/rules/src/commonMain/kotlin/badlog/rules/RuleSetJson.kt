package badlog.rules

import badlog.json.JsonMember
import badlog.json.JsonReader
import badlog.json.JsonValue
import badlog.json.quotedJson
import badlog.recording.Severity

/** These rules as a line of JSON, which says all there is to know of them: equal texts are equal rules. */
public fun RuleSet.toJson(): String = "{\"aliases\":${array(aliases, ::aliasJson)},\"rules\":${array(rules, ::ruleJson)}}"

/** The rules that [text] is of, or null when [RuleSet.toJson] did not write it. */
public fun RuleSet.Companion.fromJson(text: String): RuleSet? = try {
    val json = Fields(JsonReader.readObject(text))
    RuleSet(json.list("aliases", ::aliasOf), json.list("rules", ::ruleOf))
} catch (_: UnreadableRules) {
    null
}

private fun aliasJson(alias: Alias): String =
    "{\"name\":${quotedJson(alias.name)},\"names\":${patternsJson(alias.names)}${optional("unit", alias.unit)}}"

private fun aliasOf(value: JsonValue): Alias {
    val json = Fields(value.members)
    return Alias(json.string("name"), json.patterns("names"), json.optional("unit"))
}

private fun ruleJson(rule: Rule): String {
    val each = rule.each?.let { ",\"each\":${choiceJson(it)}" }.orEmpty()
    return "{\"name\":${quotedJson(rule.name)},\"severity\":\"${rule.severity.name.lowercase()}\",\"when\":${quotedJson(rule.condition)}," +
        "\"text\":${quotedJson(rule.text.source)},\"only\":${array(rule.only, ::quotedJson)}$each," +
        "\"place\":${placeJson(rule.place, rule.condition)}}"
}

private fun ruleOf(value: JsonValue): Rule {
    val json = Fields(value.members)
    val severity = json.string("severity")
    val condition = json.string("when")
    return Rule(
        name = json.string("name"),
        severity = Severity.entries.find { it.name.lowercase() == severity } ?: throw UnreadableRules(),
        condition = condition,
        text = json.text("text"),
        only = json.list("only") { it.text ?: throw UnreadableRules() },
        each = json.find("each")?.let(::choiceOf),
        place = placeOf(json.find("place"), condition),
    )
}

private fun choiceJson(choice: TopicChoice): String =
    "{\"names\":${patternsJson(choice.patterns)},\"except\":${patternsJson(choice.except)}${optional("unit", choice.unit)}}"

private fun choiceOf(value: JsonValue): TopicChoice {
    val json = Fields(value.members)
    return TopicChoice(json.patterns("names"), json.patterns("except"), json.optional("unit"))
}

// Most conditions stand alone on their lines, which need not be written twice.
private fun placeJson(place: RulePlace, condition: String): String {
    val line = optional("line", place.line.takeIf { it != usualLine(condition) })
    return "{\"number\":${place.lineNumber}$line,\"column\":${place.column},\"isLiteral\":${place.literal != null}}"
}

private fun usualLine(condition: String) = "when = ${quotedJson(condition)}"

private fun placeOf(value: JsonValue?, condition: String): RulePlace {
    val json = Fields(value?.members)
    val isLiteral = json.find("isLiteral")?.json == "true"
    val line = json.optional("line") ?: usualLine(condition)
    return RulePlace(json.number("number"), line, json.number("column"), condition.takeIf { isLiteral })
}

private fun patternsJson(patterns: List<NamePattern>) = array(patterns) { quotedJson(it.text) }

private fun optional(key: String, text: String?) = if (text == null) "" else ",\"$key\":${quotedJson(text)}"

private fun <T> array(items: List<T>, json: (T) -> String) = items.joinToString(",", "[", "]", transform = json)

private class UnreadableRules : Exception()

/** The members of an object that has to be there. */
private class Fields(members: List<JsonMember>?) {
    private val values = (members ?: throw UnreadableRules()).associate { it.key to it.value }

    fun find(key: String): JsonValue? = values[key]

    fun string(key: String): String = optional(key) ?: throw UnreadableRules()

    fun optional(key: String): String? = values[key]?.text

    fun number(key: String): Int = values[key]?.json?.toIntOrNull() ?: throw UnreadableRules()

    fun <T> list(key: String, read: (JsonValue) -> T): List<T> = (values[key]?.items ?: throw UnreadableRules()).map(read)

    fun patterns(key: String): List<NamePattern> = list(key) { NamePattern(it.text ?: throw UnreadableRules()) }

    fun text(key: String): RuleText = try {
        RuleText.parse(string(key))
    } catch (_: RuleText.Mistake) {
        throw UnreadableRules()
    }
}
