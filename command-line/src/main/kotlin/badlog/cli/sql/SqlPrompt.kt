package badlog.cli.sql

import badlog.cli.console.Console
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SqlSession
import java.io.InputStream

/** Reads queries, each ended by a semicolon or the end of the input, and prints their answers. A mistake ends only its own query. */
internal class SqlPrompt(private val session: SqlSession, private val form: AnswerForm, private val console: Console) {
    /** Answers the queries in [input], until its end, or a line `exit` or `quit`. */
    fun run(input: InputStream) {
        val query = StringBuilder()
        for (line in input.bufferedReader().lineSequence()) {
            if (query.isBlank() && line.trim().removeSuffix(";").lowercase() in ENDS) return
            query.appendLine(line)
            if (!line.trimEnd().endsWith(';')) continue
            answer(query.toString())
            query.clear()
            if (console.isOutClosed) return
        }
        if (query.isNotBlank()) answer(query.toString())
    }

    private fun answer(sql: String) = try {
        form.print(session, sql.trim(), console)
    } catch (e: SeasonException) {
        console.warn(e.message)
    }

    private companion object {
        val ENDS = setOf("exit", "quit")
    }
}
