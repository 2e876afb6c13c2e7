package badlog.report.table

import badlog.catalog.examine.LogContent
import badlog.catalog.examine.UndefinedTopic
import badlog.catalog.folder.FolderBatteries
import badlog.catalog.store.CachedResult
import badlog.catalog.store.ResultCache
import badlog.core.recording.NumberSinks
import badlog.exporter.BADLOG_VERSION
import badlog.expression.ExpressionError
import badlog.expression.Outcome
import badlog.expression.ParsedQuestion
import badlog.expression.Question
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.files.LogFile
import badlog.files.ReadOptions
import badlog.report.HookFailure
import badlog.report.NamedTopics
import badlog.report.Reply
import badlog.report.askedQuestion
import badlog.report.commonFolderOf
import badlog.report.errorForEveryLog
import badlog.report.holdsFor
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import badlog.report.mostHelpful
import badlog.report.notAsked
import badlog.report.runCached
import badlog.report.withAnyX
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.LogShape
import badlog.signals.QuestionNames
import badlog.signals.ShapeCache
import badlog.signals.battery.batteryNameIn
import badlog.signals.match.matchInName
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.toJson
import kotlinx.serialization.Serializable
import kotlinx.serialization.Transient
import java.nio.file.Path

/**
 * A table with a row for each log. It has a column for each of [questions] (see `docs/expressions.md`), three columns for each topic of
 * [only], and one for each value from [hooks].
 *
 * @param by the names of header values with columns of their own. Rows are sorted by them, numbers as numbers.
 * @param hooks programs to run for each log.
 * @param condition the condition for a log's header values, as an expression; null for none.
 * @param virtualTopics definitions of topics that the questions may use beside the log's own.
 * @param cache a folder for cached results; null for none. Results of hooks are not cached, because their dependencies are unknown.
 * @param xTopic the topic to use as x axis, which plain CSV does not name; null for the log's own.
 * @param signals the names of topics that the questions refer to by their meaning.
 * @param only the topics with columns for their lowest, mean and highest values.
 */
class MatchTable(
    val questions: List<String>,
    val by: List<String> = emptyList(),
    private val hooks: List<HookRunner> = emptyList(),
    private val condition: String? = null,
    private val virtualTopics: List<String> = emptyList(),
    private val cache: Path? = null,
    private val xTopic: String? = null,
    private val signals: SignalVocabulary = RuleSet.BUILT_IN.signals,
    private val only: List<NamePattern> = emptyList(),
) {
    private val usedSignals = signals.namedIn((virtualTopics + questions).joinToString("\n"))

    // A hook receives everything in the log.
    private val sinks = if (hooks.isEmpty()) neededTopics() else NumberSinks.RECORDING
    private val asked = ShapeCache(MAX_SHAPES) { ShapeQuestions(it) }

    private inner class ShapeQuestions(shape: LogShape) {
        val names = QuestionNames(usedSignals, shape)
        val questions: List<ParsedQuestion> = this@MatchTable.questions.map { askedQuestion(it, shape, names, signals) }
        val topics: List<TopicQuestion> = shape.vocabulary.signals
            .filter { signal -> signal.kind == SignalKind.NUMBER && only.any { it.matches(signal.name) } }
            .flatMap { signal -> TopicQuestion.of(signal.name, names.vocabulary) }
    }

    private fun neededTopics(): NumberSinks {
        val named = NamedTopics(virtualTopics + questions, xTopic, usedSignals)
        return NumberSinks { name, attributes -> if (only.any { it.matches(name) }) null else named.of(name, attributes) }
    }

    /** The first mistake, in a question or the condition, that is the same for every log; null if none is certain. */
    val mistake: Reply.NotAsked? =
        (questions + listOfNotNull(condition)).firstNotNullOfOrNull(::errorForEveryLog)?.let { notAsked(it) }

    @Serializable
    internal class StoredRow(
        val title: String?,
        val headers: List<String> = emptyList(),
        val cells: List<TableCell> = emptyList(),
        val topics: List<TopicCell> = emptyList(),
        val unreadable: String? = null,
        val isNoLog: Boolean = false,
        val isSalvaged: Boolean = false,
        val isWanted: Boolean = true,
        val mistake: Reply.NotAsked? = null,
        val undefined: List<UndefinedTopic> = emptyList(),
        val match: String? = null,
        @Transient val hooks: List<HookOutcome> = emptyList(),
    )

    /**
     * Evaluates the questions for each of [files], on all cores.
     *
     * @param folders the folders in which they were found.
     * @param complain called with the reason, as a sentence, if a file about batteries is not used.
     * @param progress called on this thread with the number of files done.
     * @return a row for each file, sorted.
     */
    fun over(
        files: List<LogFile>,
        folders: List<Path> = emptyList(),
        complain: (String) -> Unit = {},
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
    ): List<TableRow> {
        val rows = ArrayList<TableRow>(files.size)
        val parts =
            listOf(
                BADLOG_VERSION,
                "table",
                xTopic.orEmpty(),
                condition.orEmpty(),
                usedSignals.toJson(),
            ) + questions + "by" + by + "topics" + virtualTopics +
                "only" +
                only.map { it.text }
        val known = cache?.takeIf { hooks.isEmpty() }?.let { ResultCache(it, parts.joinToString("\n"), StoredRow.serializer()) }
        val batteries = if (by.any(::isBattery)) {
            FolderBatteries.of(files.map { it.path }, commonFolderOf(files, folders))
        } else {
            FolderBatteries.NONE
        }
        batteries.problems.forEach(complain)
        val examine = { file: LogFile, cores: Int ->
            val options = ReadOptions(sinks = sinks, cores = cores)
            LogContent.examined(file, virtualTopics, usedSignals, { it.withAnyX(xTopic, file.path) }, options) { ask(it, file.name) }
        }
        val advance = { progress(rows.size, files.size) }
        runCached(files, known, examine, advance) { file, stored ->
            val battery = batteries.usedFor(listOf(file.path), stored.match ?: matchInName(file.name).match)
            rows += rowOf(file, stored, by.zip(stored.headers) { name, header -> if (isBattery(name)) battery ?: header else header })
            advance()
        }
        return rows.sortedWith { one, other ->
            by.indices.map { compareHeaders(one.headers.getOrNull(it), other.headers.getOrNull(it)) }.firstOrNull { it != 0 } ?: 0
        }
    }

    /** Returns the mistake in a question that failed for all [rows]; null if there is none. */
    fun mistakeIn(rows: List<TableRow>): Reply.NotAsked? {
        val wrong = rows.mapNotNull { it.mistake }
        if (wrong.isNotEmpty() && rows.all { it.mistake != null || it.unreadable != null }) return mostHelpful(wrong)
        val cells = rows.filter { it.isWanted }.map { it.cells }.filter { it.isNotEmpty() }
        return questions.indices.firstNotNullOfOrNull { column ->
            val refusals = cells.mapNotNull { it[column].refusal }
            if (refusals.size < cells.size) null else mostHelpful(refusals)
        }
    }

    private fun rowOf(file: LogFile, stored: StoredRow, headers: List<String>): TableRow {
        val found = stored.hooks.flatMap { hook -> hook.result?.values.orEmpty().map { (name, text) -> HookValue(hook.hook, name, text) } }
        val failures = stored.hooks.mapNotNull { hook -> hook.failure?.let { HookFailure(hook.hook, it.message) } }
        return stored.run {
            TableRow(file, title, headers, cells, topics, found, failures, unreadable, isNoLog, isSalvaged, isWanted, undefined, mistake)
        }
    }

    private fun ask(content: LogContent, name: String): CachedResult<StoredRow> = when (content) {
        is LogContent.None -> CachedResult(
            StoredRow(null, unreadable = content.why.message, isNoLog = content.why.isLasting),
            content.why.isLasting,
        )

        is LogContent.Log -> CachedResult(ask(content, name), isLasting = true)
    }

    private fun ask(log: LogContent.Log, name: String): StoredRow {
        val values = log.recording.values
        val (isWanted, mistake) = condition?.let { holdsFor(values, it) } ?: (true to null)
        val asked = asked[log.view]
        val signals = asked.names.signalsOf(log.view)
        return StoredRow(
            log.view.title,
            by.map { if (isBattery(it)) batteryNameIn(log.recording, usedSignals).orEmpty() else headerOf(values, it) },
            cells = if (isWanted) asked.questions.map { cellOf(it, signals) } else emptyList(),
            topics = if (isWanted) asked.topics.map { TopicCell(it.topic, it.statistic, cellOf(it.question, signals)) } else emptyList(),
            isSalvaged = log.recording.isSalvaged,
            isWanted = isWanted,
            mistake = mistake,
            undefined = log.undefined,
            match = usedSignals.matchOf(log.recording, name).match,
            hooks = if (isWanted) hooks.map { HookOutcome.of(it, log.recording) } else emptyList(),
        )
    }

    private fun cellOf(question: ParsedQuestion, signals: Signals): TableCell = when (question) {
        is ExpressionError -> TableCell(Double.NaN, "", "", notAsked(question))

        is Question -> {
            val answer = question.answer(signals)
            val quantity = answer.quantities.firstOrNull()
            when (answer.outcome) {
                Outcome.NO_QUESTION -> TableCell(quantity?.value ?: Double.NaN, quantity?.unit.orEmpty(), "", null)
                Outcome.HOLDS -> TableCell(1.0, "", "yes", null)
                Outcome.FAILS -> TableCell(0.0, "", "no", null)
                Outcome.UNKNOWN -> TableCell(Double.NaN, "", "", null)
            }
        }
    }

    companion object {
        /**
         * The name of the column with the battery that was in the robot. The battery is named in the log, or in the team's file beside it.
         */
        const val BATTERY: String = "battery"
        private const val MAX_SHAPES = 64

        private fun isBattery(by: String) = by.equals(BATTERY, ignoreCase = true)
    }
}
