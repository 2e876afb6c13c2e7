package badlog.fuzzing

import badlog.core.analysis.LogView
import badlog.core.bag.VARIED_BAG
import badlog.core.bag.parse
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.expression.Expression
import badlog.expression.LogViewSignals
import badlog.expression.Question
import badlog.expression.VirtualTopic
import badlog.expression.signals.Signals
import badlog.rules.RulesException
import badlog.rules.RulesFile
import badlog.rules.SignalsFile

/** Reads JSON, and reads each member again by itself: both results must be the same. */
internal fun readJson(bytes: ByteArray) {
    val text = bytes.decodeToString()
    val members = JsonReader.readObject(text) ?: return
    val again = members.associate { it.key to shape(it.value) }
    for ((key, value) in again) {
        val member = JsonReader.readObject("{\"a\":${members.last { it.key == key }.value.json}}")
        check(member != null && shape(member.single().value) == value) { "The member “$key” is not read alike by itself." }
    }
}

private fun shape(value: JsonValue): String = value.text?.let { "text $it" }
    ?: value.items?.joinToString(",", "[", "]", transform = ::shape)
    ?: value.members?.joinToString(",", "{", "}") { it.key + ":" + shape(it.value) }
    ?: value.json

/** Reads a file of rules and a file of signals; mistakes in them must be reported by a [RulesException]. */
internal fun readToml(bytes: ByteArray) {
    val text = bytes.decodeToString()
    for (read in listOf<(String) -> Unit>({ RulesFile.parse(it) }, { SignalsFile.parse(it) })) {
        try {
            read(text)
        } catch (e: RulesException) {
            check(e.message.orEmpty().isNotBlank()) { "A mistake without a sentence." }
        }
    }
}

private val SIGNALS: Signals by lazy { LogViewSignals(LogView.of(parse(VARIED_BAG))) }

/** Reads the bytes as an expression, a question and a formula, and evaluates the valid ones. */
internal fun readExpression(bytes: ByteArray) {
    val text = bytes.decodeToString()
    val vocabulary = SIGNALS.vocabulary
    val expression = Expression.parse(text, vocabulary)
    if (expression is Expression) {
        expression.answer(SIGNALS)
        expression.series(SIGNALS)
        val printed = expression.toString()
        val again = Expression.parse(printed, vocabulary)
        check(again is Expression && again.toString() == printed) { "“$printed” is read as “$again”." }
    }
    (Question.parse(text, vocabulary) as? Question)?.answer(SIGNALS)
    (VirtualTopic.parse(text, vocabulary) as? VirtualTopic)?.series(SIGNALS)
}
