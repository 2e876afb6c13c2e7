package badlog.cli.sql

import badlog.cli.console.Console
import badlog.cli.plugin.SqlColumn
import badlog.cli.plugin.SqlSession
import badlog.cli.text.counted
import badlog.files.terminal.TextTable
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** The form of printed answers. */
internal enum class AnswerForm {
    /** A table; for long answers, its beginning. */
    TEXT {
        override fun print(session: SqlSession, sql: String, console: Console) {
            var columns = emptyList<SqlColumn>()
            val rows = ArrayList<List<String>>()
            var isCut = false
            session.query(sql, { columns = it }) { row ->
                isCut = rows.size == MAX_ROWS
                if (!isCut) rows += row.map(::textOf)
                !isCut
            }
            val shown = columns.mapIndexed { i, it ->
                val most = if (i == columns.lastIndex) Int.MAX_VALUE else MAX_WIDTH
                TextTable.Column(it.name, most, it.isNumber, it.isNumber || TIME_TYPES.any(it.type::startsWith))
            }
            // The first column usually names the row.
            val table = TextTable(shown, console.width, repeated = if (shown.size > 1) 1 else 0)
            for (line in table.text(rows)) console.say(line)
            if (isCut) console.warn("Only the first ${counted(MAX_ROWS.toLong(), "row")} are shown; --csv prints all.")
        }
    },

    /** CSV with titles. */
    CSV {
        override fun print(session: SqlSession, sql: String, console: Console) =
            session.query(sql, { columns -> console.say(columns.joinToString(",") { csvOf(it.name) }) }) { row ->
                console.say(row.joinToString(",") { csvOf(textOf(it)) })
                !console.isOutClosed
            }
    },

    /** An object for each row. */
    JSON {
        override fun print(session: SqlSession, sql: String, console: Console) {
            var names = emptyList<String>()
            session.query(sql, { columns -> names = columns.map { it.name } }) { row ->
                console.say("${JsonObject(names.zip(row).toMap())}")
                !console.isOutClosed
            }
        }
    }, ;

    /** Prints the answer to [sql]. */
    abstract fun print(session: SqlSession, sql: String, console: Console)

    internal companion object {
        private const val MAX_ROWS = 1000
        private const val MAX_WIDTH = 60

        /** Moments and lengths of time are values, as numbers are. */
        private val TIME_TYPES = listOf("TIME", "DATE", "INTERVAL")

        /** Returns [value] for people: empty for null. */
        fun textOf(value: JsonElement): String = when (value) {
            is JsonNull -> ""
            is JsonPrimitive -> value.content.removeSuffix(".0")
            else -> "$value"
        }

        private fun csvOf(text: String) = if (text.any { it in ",\"\r\n" }) "\"${text.replace("\"", "\"\"")}\"" else text
    }
}
