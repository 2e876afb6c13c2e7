package badlog.report

import badlog.catalog.examine.LogContent
import badlog.catalog.examine.UndefinedTopic
import badlog.catalog.store.CachedResult
import badlog.catalog.store.ResultCache
import badlog.core.recording.ProblemKind
import badlog.exporter.BADLOG_VERSION
import badlog.expression.Answer
import badlog.expression.ExpressionError
import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.files.LogFile
import badlog.files.LogMaker
import badlog.files.ReadOptions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.LogShape
import badlog.signals.QuestionNames
import badlog.signals.ShapeCache
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.toJson
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * A question about many logs: an expression, see `docs/expressions.md`.
 *
 * @param question the expression.
 * @param virtualTopics definitions of topics that the question may use beside the log's own, such as `Power = Voltage * Current`.
 * @param cache a folder for cached results, so that an unchanged file is not read again; null for none.
 * @param xTopic the topic to use as x axis, which plain CSV does not name; null for the log's own.
 * @param signals the names of topics that the question refers to by their meaning.
 * @param maker makes one log from a file that contains several; null if such files are not read.
 */
class Find(
    private val question: String,
    private val virtualTopics: List<String> = emptyList(),
    private val cache: Path? = null,
    private val xTopic: String? = null,
    private val signals: SignalVocabulary = RuleSet.BUILT_IN.signals,
    private val maker: LogMaker? = null,
) {
    private val clauses = QuestionClauses.of(question)
    private val usedSignals = signals.namedIn((virtualTopics + clauses.question).joinToString("\n"))
    private val named = NamedTopics(virtualTopics + clauses.question, xTopic, usedSignals)
    private val asked = ShapeCache(MAX_SHAPES) { ShapeQuestion(it) }

    private inner class ShapeQuestion(shape: LogShape) {
        val names = QuestionNames(usedSignals, shape)
        val question: ParsedQuestion = askedQuestion(clauses.question, shape, names, signals)
    }

    /** The mistake in the question that is the same for every log, such as an unclosed parenthesis. Null if none is certain. */
    val mistake: Reply.NotAsked? =
        listOfNotNull(clauses.question, clauses.condition).firstNotNullOfOrNull(::errorForEveryLog)?.let { notAsked(it) }

    @Serializable
    internal class StoredReply(
        val title: String?,
        val reply: Reply,
        val undefined: List<UndefinedTopic> = emptyList(),
        val isSalvaged: Boolean = false,
    )

    /**
     * Evaluates the question for each of [files], on all cores. If the question has a [mistake], that is the reply for each, and
     * no file is read.
     *
     * @param progress called on this thread with the number of files done.
     * @param each receives each result on this thread, as soon as it and all previous ones are available. An exception from it or
     *   from [progress] stops the work and is passed on.
     * @return all results, in the order of [files].
     * @throws InterruptedException if the thread was interrupted.
     */
    fun over(
        files: List<LogFile>,
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
        each: (FindResult) -> Unit = {},
    ): List<FindResult> {
        val results = ArrayList<FindResult>(files.size)
        val key = "$BADLOG_VERSION\nfind, and what was left out, in matches\n${virtualTopics.joinToString(
            "\n",
        )}\n\n${xTopic.orEmpty()}\n${usedSignals.toJson()}\n$question"
        val known = cache?.let { ResultCache(it, key, StoredReply.serializer()) }
        val advance = { progress(results.size, files.size) }
        runCached(files, known, ::ask, advance) { file, stored ->
            val result = FindResult(file, stored.title, stored.reply, stored.undefined, stored.isSalvaged)
            results += result
            if (clauses.count == null) each(result)
            advance()
        }
        val ranked = clauses.count?.let { ranked(results, it) } ?: return results
        ranked.forEach(each)
        return ranked
    }

    /** Returns the [count] lowest or highest of [results], in this order. Then come all without an answer; the others are left out. */
    private fun ranked(results: List<FindResult>, count: Int): List<FindResult> {
        val (found, others) = results.partition { isFound(it) && !valueOf(it).isNaN() }
        val sorted = found.sortedBy { if (clauses.isLowest) valueOf(it) else -valueOf(it) }
        val left = sorted.drop(count).map { it.run { FindResult(file, title, Reply.LeftOut, undefined, isSalvaged) } }
        return sorted.take(count) + left + others
    }

    private fun valueOf(result: FindResult) = (result.reply as? Reply.Answered)?.quantities?.firstOrNull()?.value ?: Double.NaN

    private fun ask(file: LogFile, cores: Int): CachedResult<StoredReply> {
        if (mistake != null) return CachedResult(StoredReply(null, mistake), isLasting = false)
        val options = ReadOptions(sinks = named, cores = cores, maker = maker)
        return LogContent.examined(file, virtualTopics, usedSignals, { it.withAnyX(xTopic, file.path) }, options, work = ::ask)
    }

    private fun ask(content: LogContent): CachedResult<StoredReply> = when (content) {
        is LogContent.None -> CachedResult(
            StoredReply(null, Reply.Unreadable(content.why.message, content.why.isLasting)),
            content.why.isLasting,
        )

        is LogContent.Log -> {
            val (isWanted, mistake) = clauses.condition?.let { holdsFor(content.recording.values, it) } ?: (true to null)
            val reply = if (mistake != null) {
                mistake
            } else if (!isWanted) {
                Reply.LeftOut
            } else {
                val asked = asked[content.view]
                when (val question = asked.question) {
                    is ExpressionError -> notAsked(question)
                    is Question -> asked.names.signalsOf(content.view).let { answered(question.answer(it), it.implausible) }
                }
            }
            CachedResult(
                StoredReply(content.view.title, reply, content.undefined, content.recording.isSalvaged),
                // Whoever asks again learns again which logs of a match are left out.
                isLasting = content.recording.problems.none { it.kind == ProblemKind.LOG_LEFT_OUT },
            )
        }
    }

    private companion object {
        const val MAX_SPANS = 100
        const val MAX_SHAPES = 64

        fun answered(answer: Answer, implausible: Map<String, Int>) = Reply.Answered(
            answer.outcome,
            answer.spans.take(MAX_SPANS),
            answer.times,
            answer.quantities,
            answer.time,
            answer.timeUnit,
            answer.reason,
            answer.occurrences.take(MAX_SPANS).map { Reply.Occurrence(it.span, it.before) },
            implausible.toList(),
        )
    }
}

internal fun notAsked(error: ExpressionError, isOfHeader: Boolean = false): Reply.NotAsked =
    Reply.NotAsked(error.kind, error.text.substring(error.from, error.until), error.message, error.pointed(), isOfHeader)
