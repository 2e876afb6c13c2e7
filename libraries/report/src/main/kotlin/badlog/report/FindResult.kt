package badlog.report

import badlog.catalog.examine.UndefinedTopic
import badlog.catalog.store.QuantitySerializer
import badlog.catalog.store.SpanSerializer
import badlog.core.analysis.Span
import badlog.expression.Outcome
import badlog.expression.Quantity
import badlog.expression.syntax.ExpressionErrorKind
import badlog.files.LogFile
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * The result of a question for one file.
 *
 * @property file the file.
 * @property title the match, according to the log's values; null if they do not name it, or if the file cannot be read.
 * @property reply the reply.
 * @property undefined the virtual topics that could not be calculated.
 * @property isSalvaged whether part of the log is lost, so that the reply covers only the rest.
 */
class FindResult internal constructor(
    val file: LogFile,
    val title: String?,
    val reply: Reply,
    val undefined: List<UndefinedTopic>,
    val isSalvaged: Boolean,
)

/**
 * Returns the mistake in the question that led to [results]; null if it was valid for a log. A missing topic is not a mistake if another
 * log has it. If the question failed for several logs, the mistake that is farthest into the question counts.
 */
fun mistakeIn(results: List<FindResult>): Reply.NotAsked? {
    if (results.any { it.reply is Reply.Answered || it.reply is Reply.LeftOut }) return null
    val refusals = results.map { it.reply }.filterIsInstance<Reply.NotAsked>()
    return mostHelpful(refusals.filter { it.kind != ExpressionErrorKind.UNKNOWN_TOPIC }.ifEmpty { refusals })
}

/** The possible replies to a question for a file. */
@Serializable
sealed interface Reply {
    /**
     * The log has an answer; see [badlog.expression.Answer].
     *
     * @property outcome whether it holds.
     * @property spans the times when it holds, at most the first hundred.
     * @property spanCount the number of times when it holds.
     * @property quantities the numbers that were compared.
     * @property time the time to look at first; NaN if unknown.
     * @property timeUnit the unit of all times; empty if x has none.
     * @property reason the reason for an unknown answer, as a sentence; null if it is known, or if samples are missing.
     * @property implausible topics, each with the number of samples that were left out, since no robot has such values.
     * @property occurrences each occurrence, with the values just before, if the question asks for them; at most the first hundred.
     */
    @Serializable
    class Answered internal constructor(
        val outcome: Outcome,
        val spans: List<
            @Serializable(with = SpanSerializer::class)
            Span,
            >,
        val spanCount: Int,
        @SerialName("figures")
        val quantities: List<
            @Serializable(with = QuantitySerializer::class)
            Quantity,
            >,
        val time: Double,
        val timeUnit: String,
        val reason: String? = null,
        val occurrences: List<Occurrence> = emptyList(),
        val implausible: List<Pair<String, Int>> = emptyList(),
    ) : Reply

    /** An occurrence, see [badlog.expression.Occurrence]. */
    @Serializable
    class Occurrence internal constructor(
        @Serializable(with = SpanSerializer::class)
        val span: Span,
        val before: List<Pair<String, String>>,
    )

    /** The question excludes the log, by its header values or its rank. */
    @Serializable
    object LeftOut : Reply

    /**
     * The question could not be evaluated for this log.
     *
     * @property kind the kind of the error: [UNKNOWN_TOPIC][ExpressionErrorKind.UNKNOWN_TOPIC] if the log lacks the topic.
     * @property topic the wrong part of the question, such as the name of the missing topic.
     * @property message the error, as a sentence.
     * @property pointed the message, the question, and carets below it.
     * @property isOfHeader whether it concerns the header values, rather than topics.
     */
    @Serializable
    class NotAsked internal constructor(
        val kind: ExpressionErrorKind,
        val topic: String,
        val message: String,
        val pointed: String,
        val isOfHeader: Boolean = false,
    ) : Reply {
        /** The position of the error in the question, from 0. */
        internal val place: Int get() = pointed.substringAfterLast('\n').indexOf('^')
    }

    /**
     * The file cannot be read, or is not a log.
     *
     * @property message the reason, as a sentence.
     * @property isNoLog whether it is not a log.
     */
    @Serializable
    class Unreadable internal constructor(val message: String, val isNoLog: Boolean) : Reply
}
