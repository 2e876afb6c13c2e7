package badlog.rules

/** These rules as a line of JSON, which says all there is to know of them: equal texts are equal rules. */
public fun RuleSet.toJson(): String = "{\"aliases\":${array(aliases, ::aliasJson)},\"rules\":${array(rules, ::ruleJson)}}"

private fun aliasJson(alias: Alias): String {
    val unit = alias.unit?.let { ",\"unit\":${quoted(it)}" }.orEmpty()
    return "{\"name\":${quoted(alias.name)},\"names\":${patternsJson(alias.names)}$unit}"
}

private fun ruleJson(rule: Rule): String {
    val only = if (rule.only.isEmpty()) "" else ",\"only\":${array(rule.only, ::quoted)}"
    val each = rule.each?.let { ",\"each\":${choiceJson(it)}" }.orEmpty()
    return "{\"name\":${quoted(rule.name)},\"severity\":\"${rule.severity.name.lowercase()}\",\"when\":${quoted(rule.condition)}," +
        "\"text\":${quoted(rule.text.source)}$only$each,\"place\":${placeJson(rule.place)}}"
}

private fun choiceJson(choice: TopicChoice): String {
    val unit = choice.unit?.let { ",\"unit\":${quoted(it)}" }.orEmpty()
    return "{\"names\":${patternsJson(choice.patterns)},\"except\":${patternsJson(choice.except)}$unit}"
}

private fun placeJson(place: RulePlace): String =
    "{\"number\":${place.lineNumber},\"line\":${quoted(place.line)},\"column\":${place.column},\"isLiteral\":${place.literal != null}}"

private fun patternsJson(patterns: List<NamePattern>) = array(patterns) { quoted(it.text) }

private fun <T> array(items: List<T>, json: (T) -> String) = items.joinToString(",", "[", "]", transform = json)

private fun quoted(text: String): String = buildString(text.length + 2) {
    append('"')
    for (char in text) {
        when {
            char == '"' || char == '\\' -> append('\\').append(char)
            char < ' ' || char.isSurrogate() -> append("\\u").append(char.code.toString(16).padStart(4, '0'))
            else -> append(char)
        }
    }
    append('"')
}
