package badlog.cli

import badlog.cli.computer.Computer
import badlog.cli.console.Console
import badlog.files.inFolder
import badlog.files.terminal.displayWidth
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlin.io.path.div

/** A log of a match with a long name, in which each number has many digits. */
private val LONG = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A/Very Long Name Of A Topic/In A Folder","unit":"m/s"}],""" +
    """"values":[{"name":"Event Name","value":"The Regional Championship Of Long Names"},{"name":"Match Type","value":"Qualification"},{"name":"Match Number","value":"42"}]}""" +
    "\nTime,A\n" + (0..500).joinToString("") { "${it / 50.0},${if (it == 250) "-123456.7" else "987654.3"}\n" }

private const val RULE = "[[rule]]\nname='R'\nseverity='warning'\nwhen='In A Folder < 0'\ntext='{topic} was {value} at {time}, which is why this text is long enough for two lines of any width.'\n"

class TableWidthSpec : FunSpec({
    /** What comes above the sentences that sum up a table. */
    fun tableOf(text: String) = text.substringBefore("\n\nFound in").substringBefore("\n\n0 errors").trimEnd().lines()

    val topic = "In A Folder"
    val values = listOf("min($topic)", "max($topic)", "mean($topic)", "duration($topic > 0)", "count($topic < 0)").flatMap { listOf("--value", it) }

    for (width in listOf(60, 80, 100, 200)) {
        test("no line of a table is longer than a terminal of $width columns, and values are whole") {
            inFolder { folder ->
                for (name in listOf("a.bag", "a folder with a long name/qualification-42-of-the-regional.bag")) folder.with(name, LONG)
                folder.with("badlog-rules.toml", RULE)
                fun run(vararg arguments: Any) = badlogOn(Computer(), *arguments, width = width).out
                val tables = mapOf(
                    "find" to run("find", folder, "min($topic)", "--no-cache"),
                    "report" to run("report", folder, "--no-cache"),
                    "table" to run("table", folder, *values.toTypedArray(), "--by", "Match Number", "--no-cache"),
                    "info" to run("info", folder),
                    "topics" to run("info", folder / "a.bag", "--topics"),
                    "attributes" to run("info", folder / "a.bag", "--attributes"),
                    "signals" to run("info", SAMPLES / "practice.bag", "--signals"),
                    "sql" to run("sql", folder, "SELECT title, log, 123456789 AS a, 2.3456789 AS b, TIMESTAMP '2026-03-14 10:41:07' AS start, 987654321 AS c FROM matches"),
                    "samples" to run("info", SAMPLES / "qualification-42.bag", "--topics"),
                )
                for ((name, text) in tables) {
                    val lines = tableOf(text).filter { !it.startsWith(folder.toString()) }
                    lines.filter { displayWidth(it) > width }.map { "$name: $it" }.shouldBeEmpty()
                }
                for ((name, value) in mapOf("find" to "-123457 m/s", "report" to "-123500 m/s", "table" to "-123457")) {
                    tables.getValue(name).replace(Regex("\\s+"), " ") shouldContain value
                }
                for (value in listOf("123456789", "2.3456789", "2026-03-14T10:41:07", "987654321")) tables.getValue("sql") shouldContain value
                tables.getValue("topics") shouldContain "-123500 … 987700"
                tables.getValue("samples") shouldContain "-28.99 … 11.32"
            }
        }
    }

    test("output for another program is neither shortened nor broken into lines") {
        inFolder { folder ->
            val log = folder.with("a folder with a long name/qualification-42-of-the-regional-championship-of-long-names.bag", LONG)
            folder.with("badlog-rules.toml", RULE)
            for (arguments in listOf(arrayOf("find", folder, "min($topic)", "--no-cache"), arrayOf("report", folder, "--no-cache"))) {
                val out = badlogOn(Computer(), *arguments, width = Console.UNLIMITED).out
                out shouldContain "${log.fileName}"
                out shouldNotContain "…"
            }
        }
    }
})
