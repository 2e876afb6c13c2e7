package badlog.report.table

import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.expression.signals.Vocabulary
import kotlinx.serialization.Serializable

/**
 * A statistic of a topic in a [MatchTable].
 *
 * @property topic the name of the topic.
 * @property statistic `min`, `mean` or `max`.
 * @property cell the result.
 */
@Serializable
class TopicCell internal constructor(val topic: String, val statistic: String, val cell: TableCell) {
    /** The title of its column, such as `max(PDP/Current 0)`. */
    val title: String get() = "$statistic($topic)"
}

/** A question for the [statistic] of [topic]. */
internal class TopicQuestion private constructor(val topic: String, val statistic: String, val question: ParsedQuestion) {
    companion object {
        /** Returns the questions for the topic [name] of a log with [vocabulary]. */
        fun of(name: String, vocabulary: Vocabulary): List<TopicQuestion> =
            STATISTICS.map { TopicQuestion(name, it, Question.parse("$it(\"${name.replace("\"", "\"\"")}\")", vocabulary)) }

        private val STATISTICS = listOf("min", "mean", "max")
    }
}
