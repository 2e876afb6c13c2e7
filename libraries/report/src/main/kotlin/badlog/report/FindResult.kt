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

/**
 * What is wrong with the question itself, of which [results] came; a topic that a log lacks is not a mistake as long as another has it.
 * Where several logs refused it, the one that understood most of it tells.
 */
public fun mistakeIn(results: List<FindResult>): Reply.NotAsked? {
    if (results.any { it.reply is Reply.Answered || it.reply is Reply.LeftOut }) return null
    val refusals = results.map { it.reply }.filterIsInstance<Reply.NotAsked>()
    return refusals.filter { it.kind != ExpressionErrorKind.UNKNOWN_TOPIC }.ifEmpty { refusals }.maxByOrNull { it.place }
}

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
     * @property reason why it is not known, as a sentence; null where it is known, or where samples are missing.
     * @property occurrences each time that it happened, with what was just before, where the question asks for that; at most the first hundred.
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
        public val reason: String? = null,
        public val occurrences: List<Occurrence> = emptyList(),
    ) : Reply

    /** One time that something happened, see [badlog.expression.Occurrence]. */
    @Serializable
    public class Occurrence internal constructor(
        @Serializable(with = SpanSerializer::class)
        public val span: Span,
        public val before: List<Pair<String, String>>,
    )

    /** The question leaves the log out, by its header values or its rank. */
    @Serializable
    public object LeftOut : Reply

    /**
     * The question could not be asked of this log.
     *
     * @property kind why: [UNKNOWN_TOPIC][ExpressionErrorKind.UNKNOWN_TOPIC] when the log lacks the topic.
     * @property topic what was found wrong in the question: the name of the missing topic.
     * @property message what is wrong, as a sentence.
     * @property pointed the message, the question, and carets below it.
     * @property isOfHeader whether the header values were asked, rather than topics.
     */
    @Serializable
    public class NotAsked internal constructor(
        public val kind: ExpressionErrorKind,
        public val topic: String,
        public val message: String,
        public val pointed: String,
        public val isOfHeader: Boolean = false,
    ) : Reply {
        /** How far the log understood the question. */
        internal val place: Int get() = pointed.substringAfterLast('\n').indexOf('^')
    }

    /**
     * The file cannot be read, or is not a log.
     *
     * @property message why, as a sentence.
     * @property isNoLog whether it is something else than a log.
     */
    @Serializable
    public class Unreadable internal constructor(public val message: String, public val isNoLog: Boolean) : Reply
}
