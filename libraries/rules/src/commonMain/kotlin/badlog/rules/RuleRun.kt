package badlog.rules

import badlog.analysis.LogView
import badlog.expression.Answer
import badlog.expression.LogViewSignals
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals

/** The rules of a program on their way over [view], which was read from a file called [file]. */
internal class RuleRun(view: LogView, private val file: String) {
    private val log = LogViewSignals(view)
    private val match = view.title ?: file
    private val clock by lazy { clockOf(view.xAxis) }

    /** What comes of asking [step]. */
    fun ask(step: RuleProgram.Step): AskedRule = AskedRule(step.rule, step.questions.mapNotNull { find(step.rule, it) }, step.refusal)

    private fun find(rule: Rule, question: RuleProgram.Question): Finding? {
        val signals = NamedSignals(log, question.named, question.expression.vocabulary) { clock }
        val answer = question.expression.answer(signals)
        return if (answer.matches) finding(rule, question, answer, signals) else null
    }

    private fun finding(rule: Rule, question: RuleProgram.Question, answer: Answer, signals: Signals): Finding {
        // What is said of the whole recording holds from its start to its end.
        val whole = listOfNotNull(signals.range).takeIf { answer.spans.isEmpty() }
        val spans = whole ?: answer.spans
        val time = if (answer.time.isNaN() && spans.isNotEmpty()) spans[0].from else answer.time
        val text = rule.text.filled(
            mapOf(
                "value" to (answer.quantities.firstOrNull()?.text ?: textAt(answer.time, question, signals)),
                "time" to timeText(time, answer.timeUnit),
                "match" to match,
                "file" to file,
                "topic" to question.topic.orEmpty(),
                "count" to (if (whole == null) answer.times else whole.size).toString(),
                "duration" to timeText(spans.sumOf { it.width }, answer.timeUnit),
            ),
        )
        return Finding(
            rule.name,
            rule.severity,
            question.topic,
            text,
            answer.time,
            answer.spans.take(Finding.MAX_SPANS),
            answer.times,
            answer.timeUnit,
        )
    }

    /** What the first text of [question] is at [time]; empty without one. */
    private fun textAt(time: Double, question: RuleProgram.Question, signals: Signals): String {
        val name = question.expression.topics.firstOrNull { topic ->
            val kind = signals.vocabulary.signals.first { it.name == topic }.kind
            kind == SignalKind.EVENT || kind == SignalKind.STATE
        } ?: return ""
        val series = signals.series(name)
        val at = series.x.indices.lastOrNull { series.x[it] <= time && !series.y[it].isNaN() } ?: return ""
        return signals.states(name)[series.y[at].toInt()]
    }
}
