package badlog.report.rules

import badlog.analysis.LogView
import badlog.expression.Answer
import badlog.expression.LogViewSignals
import badlog.expression.SignalKind
import badlog.expression.Signals
import badlog.expression.Vocabulary
import badlog.report.Remembered
import badlog.report.matchType
import badlog.report.timeText

/** Runs [rules] over one log after another. Safe for several threads. */
internal class RuleRunner(private val rules: RuleSet) {
    private data class Key(val vocabulary: Vocabulary, val timeTopic: String?, val hasClock: Boolean)

    private val programs = Remembered<Key, RuleProgram>(MOST_PROGRAMS) { RuleProgram(rules, it.vocabulary, it.timeTopic, it.hasClock) }

    /** Tells [found] what holds in [view], called [match] in [file], and [asked] of each rule, with the reason
     * where it could not be. */
    fun run(view: LogView, match: String, file: String, found: (Finding) -> Unit, asked: (Rule, RuleProgram.Refusal?) -> Unit) {
        val log = LogViewSignals(view)
        val type = matchType(view.recording.values)
        val clock by lazy { clockOf(view.xAxis) }
        val hasClock = view.xAxis.topic == null && !view.xAxis.isIndex
        for (step in programs[Key(log.vocabulary, view.xAxis.topic?.name, hasClock)].steps) {
            if (!step.rule.isFor(type)) continue
            asked(step.rule, step.refusal)
            for (question in step.questions) {
                val signals = NamedSignals(log, question.named, question.expression.vocabulary) { clock }
                val answer = question.expression.answer(signals)
                if (answer.matches) found(finding(step.rule, question, answer, signals, match, file))
            }
        }
    }

    private fun finding(
        rule: Rule,
        question: RuleProgram.Question,
        answer: Answer,
        signals: Signals,
        match: String,
        file: String,
    ): Finding {
        // What is said of the whole recording holds from its begin to its end.
        val whole = listOfNotNull(signals.range).takeIf { answer.spans.isEmpty() }
        val spans = whole ?: answer.spans
        val time = if (answer.time.isNaN() && spans.isNotEmpty()) spans[0].from else answer.time
        val text = rule.text.filled(
            mapOf(
                "value" to (answer.figures.firstOrNull()?.text ?: textAt(answer.time, question, signals)),
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
            answer.spans.take(MOST_SPANS),
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

    private companion object {
        const val MOST_SPANS = 100

        // Each knows all names of its logs several times over.
        const val MOST_PROGRAMS = 16
    }
}
