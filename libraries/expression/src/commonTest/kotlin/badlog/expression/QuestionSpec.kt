package badlog.expression

import badlog.core.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private val X = doubleArrayOf(0.0, 1.0, 2.0, 3.0, 4.0)

private val SIGNALS = SampleSignals(
    mapOf(
        Signal("PDP/Current 0", SignalKind.NUMBER, "A") to Series(X, doubleArrayOf(1.0, 2.0, 40.0, 4.0, 3.0)),
        Signal("PDP/Current 1", SignalKind.NUMBER, "A") to Series(X, doubleArrayOf(5.0, 70.0, 80.0, 6.0, 5.0)),
        Signal("PDP/Voltage", SignalKind.NUMBER, "V") to Series(X, doubleArrayOf(12.0, 8.0, 6.0, 11.0, 12.0)),
        Signal("Low", SignalKind.CONDITION) to Series(X, doubleArrayOf(0.0, 0.0, 1.0, 0.0, 1.0)),
        Signal("State", SignalKind.STATE) to Series(X, doubleArrayOf(0.0, 1.0, 1.0, 0.0, 2.0)),
    ),
    texts = mapOf("State" to listOf("IDLE", "SCORING", "it's done")),
    rows = X,
)

private fun answer(text: String) = when (val question = Question.parse(text, SIGNALS.vocabulary)) {
    is Question -> question.answer(SIGNALS)
    is ExpressionError -> throw AssertionError(question.pointed())
}

class QuestionSpec : FunSpec({
    val answers = mapOf(
        "max(PDP/Voltage)" to "max(PDP/Voltage) = 12 V at 0 s",
        "max(\"PDP/Current *\") by topic" to "PDP/Current 0 = 40 A at 2 s, PDP/Current 1 = 80 A at 2 s",
        "max(\"Current *\") by topic" to "PDP/Current 0 = 40 A at 2 s, PDP/Current 1 = 80 A at 2 s",
        "\"PDP/Current *\" > 60 by topic" to "yes, PDP/Current 1 = 80 A at 2 s, from 1 s to 3 s",
        "\"PDP/Current *\" > 90 by topic" to "no",
        "total by State" to "IDLE = 2 s at 0 s, SCORING = 2 s at 1 s, it's done = 0 s at 4 s",
        "count by State" to "IDLE = 2 at 0 s, SCORING = 1 at 1 s, it's done = 1 at 4 s",
        "max(PDP/Current 1) by State" to "IDLE = 6 A at 3 s, SCORING = 80 A at 2 s, it's done = 5 A at 4 s",
        "total(PDP/Voltage < 9) by State" to "IDLE = 0 s, SCORING = 2 s at 1 s, it's done = 0 s",
        "max(PDP/Current 0) - min(PDP/Current 0) by State" to "IDLE = 3 A, SCORING = 38 A, it's done = 0 A",
        "mean(PDP/Voltage) by Low" to "true = 6 V, false = 10.3333 V",
    )
    for ((text, answer) in answers) test("the answer to $text is “$answer”") { answer(text).toString() shouldBe answer }

    test("each occurrence has the values just before it") {
        answer("each(Low, PDP/Voltage, State, PDP/Current 0 > 30, max(PDP/Voltage))").run {
            outcome shouldBe Outcome.HOLDS
            occurrences.map { it.span.from } shouldBe listOf(2.0, 4.0)
            occurrences[0].before shouldBe
                listOf("PDP/Voltage" to "8 V", "State" to "SCORING", "PDP/Current 0 > 30" to "false", "max(PDP/Voltage)" to "12 V")
            occurrences[1].before.map { it.second } shouldBe listOf("11 V", "IDLE", "false", "12 V")
        }
        answer("each(PDP/Voltage > 11, State)").occurrences[0].before shouldBe listOf("State" to "no value")
        answer("each(PDP/Voltage > 99)").occurrences shouldBe emptyList()
    }

    val mistakes = mapOf(
        "max(\"PDP/Curent *\") by topic" to ("\"PDP/Curent *\"" to "No topic matches “PDP/Curent *”; * matches anything, ? one character."),
        "max(PDP/Voltage) by topic" to ("topic" to "“by topic” needs a name with * in double quotes, as in max(\"PDP/Current *\") by topic."),
        "max(PDP/Voltage) by Stat" to ("Stat" to "“Stat” is not a topic of this log. Did you mean “State”?"),
        "max(PDP/Voltage) by PDP/Voltage" to ("PDP/Voltage" to "“PDP/Voltage” is a number; “by” needs a signal with states, or “topic”."),
        "max(PDP/Voltge) by State" to ("PDP/Voltge" to "“PDP/Voltge” is not a topic of this log. Did you mean “PDP/Voltage”?"),
        "PDP/Voltage by State" to ("PDP/Voltage" to "“by State” needs one number for the whole log before it, as in max(x) by State."),
        "each(PDP/Voltage, State)" to ("PDP/Voltage, State" to "each needs a condition that changes over time, such as x > 0."),
        "each(Low, Stat)" to ("Stat" to "“Stat” is not a topic of this log. Did you mean “State”?"),
        "max(PDP/Voltage) buy State" to ("buy" to "“buy” is not expected here; an operator such as + or < may follow, or the end."),
    )
    for ((text, mistake) in mistakes) {
        test("“$text” is a mistake at “${mistake.first}”") {
            val error = Question.parse(text, SIGNALS.vocabulary) as ExpressionError
            error.message shouldBe mistake.second
            error.text.substring(error.from, error.until) shouldBe mistake.first
        }
    }
})
