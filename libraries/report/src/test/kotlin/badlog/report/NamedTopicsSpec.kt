package badlog.report

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.LogViewSignals
import badlog.files.ReadOptions
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll

private val FORMS = listOf(
    "max(%s) > 1",
    "%s",
    "%s > 2 for 0.1 s",
    "mean(%s when enabled)",
    "count(changed(%s)) > 3",
    "autonomous and %s > 0",
    "%s == 'HIGH'",
)

/** The ways to write a topic's name. */
private val WRITTEN = listOf<(String) -> String>(
    { it },
    { it.substringAfterLast('/') },
    { it.substringAfter('/') },
    { it.uppercase() },
    { "\"$it\"" },
    { "/$it" },
)

class NamedTopicsSpec : FunSpec({
    val files = listOf("qualification-42.bag", "practice.bag", "elevator-bench.csv").map(::sample)

    val signals = RuleSet.BUILT_IN.signals

    fun answer(recording: Recording, question: String): String {
        val signals = LogViewSignals(LogView.of(recording).withSignals(signals, "log"))
        return when (val parsed = Expression.parse(question, signals.vocabulary)) {
            is ExpressionError -> parsed.pointed()
            is Expression -> parsed.answer(signals).run { "$this $spans $quantities" }
        }
    }

    test("a question has the same answer whether or not the numbers of other topics are read") {
        val wholes = files.associateWith { readRecording(it, LOG_FORMATS) }
        checkAll(120, Arb.element(files), Arb.int(0, 99), Arb.element(FORMS), Arb.element(WRITTEN)) { file, index, form, written ->
            val whole = wholes.getValue(file)
            val question = form.replace("%s", written(whole.topics[index % whole.topics.size].name))
            val partial = readRecording(file, LOG_FORMATS, ReadOptions(sinks = NamedTopics(listOf(question), signals = signals.namedIn(question))))
            answer(partial, question) shouldBe answer(whole, question)
        }
    }

    test("only topics that a question may name are read") {
        val partial = readRecording(files[0], LOG_FORMATS, ReadOptions(sinks = NamedTopics(listOf("min(Battery Voltage) < 7"))))
        partial.topics.count { it.samples.isNotEmpty() } shouldBeLessThan 4
        partial.topics.map { it.counts } shouldBe readRecording(files[0], LOG_FORMATS).topics.map { it.counts }
    }
})
