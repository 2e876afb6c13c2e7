package badlog.report.table

import badlog.catalog.examine.UndefinedTopic
import badlog.files.LogFile
import badlog.report.HookFailure
import badlog.report.Reply
import kotlinx.serialization.Serializable

/**
 * A log in a [MatchTable].
 *
 * @property headers the header values that sort the table; empty texts if the log has none.
 * @property cells the result of each question; empty if the log was excluded.
 * @property topics the statistics of the topics that the table summarizes, in the order of the log.
 * @property hookValues the values from the hooks.
 * @property hookFailures the hooks that failed for it.
 * @property unreadable why the file cannot be read; null if it can.
 * @property isNoLog whether it is something other than a log.
 * @property isSalvaged whether data of the log is lost.
 * @property isWanted whether the log meets the table's condition.
 * @property undefined the virtual topics that could not be calculated.
 */
class TableRow internal constructor(
    val file: LogFile,
    val title: String?,
    val headers: List<String>,
    val cells: List<TableCell>,
    val topics: List<TopicCell>,
    val hookValues: List<HookValue>,
    val hookFailures: List<HookFailure>,
    val unreadable: String?,
    val isNoLog: Boolean,
    val isSalvaged: Boolean,
    val isWanted: Boolean,
    val undefined: List<UndefinedTopic>,
    internal val mistake: Reply.NotAsked?,
)

/**
 * The result of a question for a log.
 *
 * @property value the number; 1 and 0 for yes and no; NaN if it is not known, or the question failed.
 * @property unit its unit; empty for none.
 * @property word “yes” or “no”; empty for a number.
 * @property refusal why the question failed; null if it did not.
 */
@Serializable
class TableCell internal constructor(val value: Double, val unit: String, val word: String, val refusal: Reply.NotAsked?)

/**
 * A value that a hook returned for a log.
 *
 * @property hook the name of the hook.
 * @property name the name of the value.
 * @property text the text, or the number as text.
 */
class HookValue internal constructor(val hook: String, val name: String, val text: String)

/**
 * A column of the values of a hook.
 *
 * @property title the name of the value, with the name of its hook if several hooks have such a value.
 */
internal class HookColumn private constructor(private val hook: String, private val name: String, val title: String) {
    /** Its text in [row]; null if there is none. */
    fun textIn(row: TableRow): String? = row.hookValues.find { it.hook == hook && it.name == name }?.text

    companion object {
        /** Returns a column of a hook's values in [rows], in order of first appearance. */
        fun of(rows: List<TableRow>): List<HookColumn> {
            val columns = rows.flatMap { row -> row.hookValues.map { it.hook to it.name } }.distinct()
            val hooks = columns.groupBy({ it.second }, { it.first })
            return columns.map { (hook, name) -> HookColumn(hook, name, if (hooks.getValue(name).size > 1) "$name ($hook)" else name) }
        }
    }
}
