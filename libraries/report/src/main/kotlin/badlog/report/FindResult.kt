package badlog.report

import badlog.analysis.Span
import badlog.expression.Outcome
import badlog.expression.Quantity
import badlog.expression.syntax.ExpressionErrorKind
import badlog.file.LogFile
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/**
 * What came of a question to one file.
 *
 * @property file the file.
 * @property title what match it is, from its values; null when they do not say or it cannot be read.
 * @property reply what came of it.
 * @property undefined the virtual topics that the log could not be given.
 * @property isSalvaged whether the log lost something, so that the answer is about what is left.
 */
public class FindResult internal constructor(
    public val file: LogFile,
    public val title: String?,
    public val reply: Reply,
    public val undefined: List<UndefinedTopic>,
    public val isSalvaged: Boolean,
)

/** What a question to a file may come to. */
@Serializable
public sealed interface Reply {
    /**
     * The log has an answer; see [badlog.expression.Answer].
     *
     * @property outcome whether it holds.
     * @property spans when it holds, at most the first hundred.
     * @property spanCount how often it holds.
     * @property quantities the numbers that were compared.
     * @property time where to look first; NaN when unknown.
     * @property timeUnit the unit of all times, empty where x has none.
     */
    @Serializable
    public class Answered internal constructor(
        public val outcome: Outcome,
        public val spans: List<
            @Serializable(with = SpanSerializer::class)
            Span,
            >,
        public val spanCount: Int,
        @SerialName("figures")
        public val quantities: List<
            @Serializable(with = QuantitySerializer::class)
            Quantity,
            >,
        public val time: Double,
        public val timeUnit: String,
    ) : Reply

    /**
     * The question could not be asked of this log.
     *
     * @property kind why: [UNKNOWN_TOPIC][ExpressionErrorKind.UNKNOWN_TOPIC] when the log lacks the topic.
     * @property topic what was found wrong in the question: the name of the missing topic.
     * @property message what is wrong, as a sentence.
     * @property pointed the message, the question, and carets below it.
     */
    @Serializable
    public class NotAsked internal constructor(
        public val kind: ExpressionErrorKind,
        public val topic: String,
        public val message: String,
        public val pointed: String,
    ) : Reply

    /**
     * The file cannot be read, or is not a log.
     *
     * @property message why, as a sentence.
     * @property isNoLog whether it is something else than a log.
     */
    @Serializable
    public class Unreadable internal constructor(public val message: String, public val isNoLog: Boolean) : Reply
}
