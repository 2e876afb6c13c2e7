package badlog.core.conformance

import kotlin.math.abs

/** The expectation in the corpus's form: canonical JSON, so that texts can be compared. */
internal fun expectationJson(description: String, expectation: Expectation): String = buildString {
    append("{\n  \"description\": ").append(quoted(description)).append(",\n")
    append("  \"format\": ").append(quoted(expectation.format.id)).append(",\n")
    appendList("values", expectation.values) { "{\"name\": ${quoted(it.name)}, \"value\": ${quoted(it.text)}}" }
    appendList("topics", expectation.topics, ::topicJson)
    append("  \"rowCount\": ").append(expectation.rowCount).append(",\n")
    appendList("problems", sorted(expectation.problems), ::problemJson)
    appendList("attributeProblems", sorted(expectation.attributeProblems), ::problemJson)
    setLength(length - ",\n".length)
    append("\n}\n")
}

private fun <T> StringBuilder.appendList(key: String, items: List<T>, json: (T) -> String) {
    append("  \"").append(key).append("\": [")
    items.joinTo(this, ",") { "\n    ${json(it)}" }
    append(if (items.isEmpty()) "],\n" else "\n  ],\n")
}

private fun topicJson(topic: ExpectedTopic): String {
    val counts = topic.counts
    val members = listOf(
        "\"name\": ${quoted(topic.name)}",
        "\"unit\": ${quoted(topic.unit)}",
        "\"attributes\": ${jsonArray(topic.attributes, ::quoted)}",
        "\"kind\": ${quoted(topic.kind.name.lowercase())}",
        "\"counts\": {\"numbers\": ${counts.numbers}, \"notFinite\": ${counts.notFinite}, " +
            "\"truthValues\": ${counts.truthValues}, \"texts\": ${counts.texts}, \"empty\": ${counts.empty}}",
        "\"samples\": ${jsonArray(topic.samples, ::sampleJson)}",
        "\"texts\": ${jsonArray(topic.texts) { (row, text) -> "[$row, ${quoted(text)}]" }}",
    )
    return members.joinToString(",", "{", "\n    }") { "\n      $it" }
}

private fun <T> jsonArray(items: List<T>, json: (T) -> String): String = items.joinToString(", ", "[", "]", transform = json)

private fun problemJson(problem: ExpectedProblem): String = "{\"kind\": \"${problem.kind}\", \"line\": ${problem.line}, \"topic\": ${problem.topic?.let(::quoted)}}"

/** Ordered by line, those without one last; then by kind, then by topic. */
private fun sorted(problems: List<ExpectedProblem>): List<ExpectedProblem> = problems.sortedWith(compareBy({ it.line ?: Int.MAX_VALUE }, { it.kind.name }, { it.topic ?: "" }))

private fun sampleJson(sample: Double?): String = when {
    sample == null -> "null"
    sample.isFinite() -> numberJson(sample)
    else -> quoted(sample.toString())
}

/** The number with the fewest digits, as JavaScript writes it, on every platform. */
internal fun numberJson(number: Double): String {
    val sign = if (number < 0 || 1 / number < 0) "-" else ""
    val text = abs(number).toString().lowercase()
    val mantissa = text.substringBefore('e')
    val digits = mantissa.replace(".", "").trimStart('0')
    val leadingZeros = mantissa.replace(".", "").length - digits.length
    val exponent = text.substringAfter('e', "0").removePrefix("+").toInt()
    val point = mantissa.substringBefore('.').length + exponent - leadingZeros
    val significant = digits.trimEnd('0')
    return sign + when {
        significant.isEmpty() -> if (sign.isEmpty()) "0" else "0.0"
        point > 21 || point < -5 -> scientific(significant, point - 1)
        point <= 0 -> "0." + "0".repeat(-point) + significant
        significant.length <= point -> significant.padEnd(point, '0')
        else -> significant.take(point) + "." + significant.drop(point)
    }
}

private fun scientific(digits: String, exponent: Int): String {
    val fraction = if (digits.length > 1) "." + digits.drop(1) else ""
    return "${digits[0]}${fraction}e${if (exponent < 0) "" else "+"}$exponent"
}

private fun quoted(text: String): String = buildString {
    append('"')
    for (char in text) {
        when {
            char == '"' || char == '\\' -> append('\\').append(char)
            char == '\n' -> append("\\n")
            char == '\r' -> append("\\r")
            char < ' ' || char > '~' -> append("\\u").append(char.code.toString(16).padStart(4, '0'))
            else -> append(char)
        }
    }
    append('"')
}
