package badlog.report

import badlog.expression.ExpressionError
import badlog.expression.Outcome
import badlog.expression.ParsedQuestion
import badlog.expression.Quantity
import badlog.expression.Question
import badlog.expression.signals.Signals
import badlog.file.LogFile
import badlog.recording.PathName
import badlog.recording.Value
import badlog.rules.BUILT_IN
import badlog.rules.LogShape
import badlog.rules.QuestionNames
import badlog.rules.RuleSet
import badlog.rules.signal.SignalVocabulary
import badlog.rules.signal.toJson
import badlog.terminal.TextTable
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * A table with a row for each log and a column for each of [questions], see `docs/expressions.md`.
 *
 * @param by the names of header values that have columns of their own, and by which the rows are sorted; numbers as numbers.
 * @param condition what must be true of a log's header values, as an expression; null for no condition.
 * @param virtualTopics definitions of topics that the questions may use beside the log's own.
 * @param cache a folder for what was found out before; null for none.
 * @param xTopic the topic to take as x axis, which plain CSV does not name; null for what the log itself says.
 * @param signals what topics are called that the questions name by their meaning.
 */
public class MatchTable(
    public val questions: List<String>,
    public val by: List<String> = emptyList(),
    private val condition: String? = null,
    private val virtualTopics: List<String> = emptyList(),
    private val cache: Path? = null,
    private val xTopic: String? = null,
    signals: SignalVocabulary = RuleSet.BUILT_IN.signals,
) {
    private val usedSignals = signals.namedIn((virtualTopics + questions).joinToString("\n"))
    private val named = NamedTopics(virtualTopics + questions, xTopic, usedSignals)
    private val asked = LruCache<LogShape, Asked>(MAX_SHAPES) { Asked(it) }

    private inner class Asked(shape: LogShape) {
        val names = QuestionNames(usedSignals, shape)
        val questions: List<ParsedQuestion> = this@MatchTable.questions.map { Question.parse(it, names.vocabulary) }
    }

    /** What is wrong with a question whatever a log has; null when nothing seems to be. */
    public val mistake: Reply.NotAsked? = questions.firstNotNullOfOrNull(::errorForEveryLog)?.let(::notAsked)

    @Serializable
    internal class Stored(
        val title: String?,
        val headers: List<String> = emptyList(),
        val cells: List<TableCell> = emptyList(),
        val unreadable: String? = null,
        val isNoLog: Boolean = false,
        val isSalvaged: Boolean = false,
        val isWanted: Boolean = true,
        val mistake: Reply.NotAsked? = null,
    )

    /**
     * Asks each of [files], on all cores.
     *
     * @param progress hears on this thread how many files are done.
     * @return a row for each file, sorted.
     */
    public fun over(files: List<LogFile>, progress: (done: Int, total: Int) -> Unit = { _, _ -> }): List<TableRow> {
        val rows = ArrayList<TableRow>(files.size)
        val parts =
            listOf("table", xTopic.orEmpty(), condition.orEmpty(), usedSignals.toJson()) + questions + "by" + by + "topics" + virtualTopics
        val known = cache?.let { ResultCache(it, parts.joinToString("\n"), Stored.serializer()) }
        runCached(files, known, { file, cores ->
            LogContent.examined(file, virtualTopics, usedSignals, xTopic, named, cores, ::ask)
        }) { file, stored ->
            rows += stored.run { TableRow(file, title, headers, cells, unreadable, isNoLog, isSalvaged, isWanted, mistake) }
            progress(rows.size, files.size)
        }
        return rows.sortedWith { one, other ->
            by.indices.firstNotNullOfOrNull {
                compareHeaders(one.headers.getOrNull(it), other.headers.getOrNull(it)).takeIf { order ->
                    order !=
                        0
                }
            }
                ?: 0
        }
    }

    /** What is wrong with a question of [rows], of which none could be asked. */
    public fun mistakeIn(rows: List<TableRow>): Reply.NotAsked? {
        val wrong = rows.mapNotNull { it.mistake }
        if (wrong.isNotEmpty() && rows.all { it.mistake != null || it.unreadable != null }) return wrong.maxBy { it.place }
        val cells = rows.filter { it.isWanted }.map { it.cells }.filter { it.isNotEmpty() }
        return questions.indices.firstNotNullOfOrNull { column ->
            val refusals = cells.mapNotNull { it[column].refusal }
            if (refusals.size < cells.size) null else refusals.maxByOrNull { it.place }
        }
    }

    private fun ask(content: LogContent): CachedResult<Stored> = when (content) {
        is LogContent.None -> CachedResult(Stored(null, unreadable = content.message, isNoLog = content.isNoLog), content.isNoLog)

        is LogContent.Log -> {
            val asked = asked[LogShape.of(content.view)]
            val values = content.recording.values
            val (wanted, error) = condition?.let { holdsFor(values, it) } ?: (true to null)
            val cells = if (wanted) {
                asked.names.signalsOf(content.view).let { signals ->
                    asked.questions.map { cellOf(it, signals) }
                }
            } else {
                emptyList()
            }
            CachedResult(
                Stored(
                    content.view.title,
                    by.map {
                        headerOf(values, it)
                    },
                    cells,
                    isSalvaged = content.recording.isSalvaged,
                    isWanted = wanted,
                    mistake = error?.let(::notAsked),
                ),
                isLasting = true,
            )
        }
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

    private companion object {
        const val MAX_SHAPES = 64

        /** The value that is called [name], or ends so, whatever the case; empty without one. */
        fun headerOf(values: List<Value>, name: String): String = (
            values.find { it.name == name }
                ?: values.find { it.name.equals(name, true) || PathName.baseNameOf(it.name).equals(name, true) }
            )
            ?.text?.trim().orEmpty()

        fun compareHeaders(one: String?, other: String?): Int {
            val (a, b) = listOf(one, other).map { it?.toDoubleOrNull() }
            return if (a != null && b != null) a.compareTo(b) else one.orEmpty().compareTo(other.orEmpty(), ignoreCase = true)
        }
    }
}

/**
 * A log in a [MatchTable].
 *
 * @property headers the header values by which the table is sorted; empty texts where the log has none.
 * @property cells what each question came to; empty where the log was not asked.
 * @property unreadable why the file cannot be read; null when it can.
 * @property isNoLog whether it is something else than a log.
 * @property isSalvaged whether the log lost something.
 * @property isWanted whether the log meets the table's condition.
 */
public class TableRow internal constructor(
    public val file: LogFile,
    public val title: String?,
    public val headers: List<String>,
    public val cells: List<TableCell>,
    public val unreadable: String?,
    public val isNoLog: Boolean,
    public val isSalvaged: Boolean,
    public val isWanted: Boolean,
    internal val mistake: Reply.NotAsked?,
)

/**
 * What a question to a log came to.
 *
 * @property value the number; 1 and 0 for yes and no; NaN where it is not known, or could not be asked.
 * @property unit its unit, empty for none.
 * @property word “yes” or “no”; empty for a number.
 * @property refusal why it could not be asked; null when it was.
 */
@Serializable
public class TableCell internal constructor(
    public val value: Double,
    public val unit: String,
    public val word: String,
    public val refusal: Reply.NotAsked?,
)

/** [rows] of [table] for a terminal: a line for each log that was asked. */
public fun tableText(table: MatchTable, rows: List<TableRow>): String {
    val asked = rows.filter { it.unreadable == null && it.isWanted }
    val names = shortNames(asked.map { it.file })
    val units = unitsOf(table, asked)
    val columns = listOf(TextTable.Column("Match"), TextTable.Column("File")) + table.by.map { TextTable.Column(it) } +
        table.questions.mapIndexed { i, question -> TextTable.Column(titled(question, units[i]), isNumber = true) }
    val lines = asked.map { row ->
        val file = names.getValue(row.file)
        listOf(row.title ?: file, file) + row.headers +
            row.cells.mapIndexed { i, cell -> textOf(cell, isUnitInTitle = units[i].isNotEmpty()) }
    }
    return TextTable(columns).lines(lines).flatten().joinToString("\n")
}

/** [rows] of [table] as CSV (RFC 4180): exact numbers, an empty cell for none. */
public fun tableCsv(table: MatchTable, rows: List<TableRow>): String {
    val asked = rows.filter { it.unreadable == null && it.isWanted }
    val units = unitsOf(table, asked)
    val head = listOf("Match", "File") + table.by + table.questions.mapIndexed { i, question -> titled(question, units[i]) }
    val lines = asked.map { row -> listOf(row.title.orEmpty(), row.file.path.toString()) + row.headers + row.cells.map { plain(it.value) } }
    return (listOf(head) + lines).joinToString("") { line -> line.joinToString(",", postfix = "\r\n", transform = ::cell) }
}

/** What a row of a [MatchTable] is to other programs. A number that is not known is null. */
@Serializable
public class TableRowJson private constructor(
    private val match: String?,
    private val by: Map<String, String>,
    private val values: Map<String, Double?>,
    private val units: Map<String, String>,
    private val messages: Map<String, String>,
) {
    public constructor(table: MatchTable, row: TableRow) : this(
        match = row.title,
        by = table.by.zip(row.headers).toMap(),
        values = table.questions.zip(row.cells.map { finite(it.value) }).toMap(),
        units = table.questions.zip(row.cells.map { it.unit }).toMap(),
        messages = table.questions.zip(row.cells).mapNotNull { (question, cell) -> cell.refusal?.let { question to it.message } }.toMap(),
    )
}

/** The unit of each column, empty where it has none or several. */
private fun unitsOf(table: MatchTable, rows: List<TableRow>): List<String> = table.questions.indices.map { column ->
    rows.mapNotNull { it.cells.getOrNull(column)?.takeIf { cell -> !cell.value.isNaN() }?.unit }.distinct().singleOrNull().orEmpty()
}

private fun titled(question: String, unit: String) = if (unit.isEmpty()) question else "$question ($unit)"

private fun textOf(cell: TableCell, isUnitInTitle: Boolean): String = when {
    cell.word.isNotEmpty() -> cell.word
    cell.value.isNaN() -> "–"
    else -> timeTextOf(cell.value, if (isUnitInTitle) "" else cell.unit)
}

private fun timeTextOf(value: Double, unit: String) = Quantity("", value, unit, Double.NaN).text
