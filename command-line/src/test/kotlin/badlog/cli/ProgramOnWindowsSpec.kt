package badlog.cli

import badlog.core.platform.LimitedRun
import badlog.core.platform.Wine
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.nio.file.Files

private const val LOG = "Größe über alles.bag"

/** Windows takes no longer paths of programs that do not ask for it in a way of their own. */
private const val OLD_LIMIT = 260
private val DEEP = List(12) { "ein Ordner mit langem Namen $it" }.joinToString("/")

/** The commands for both machines, one after the other: a later command also sees the files of earlier ones. */
private val COMMANDS = listOf(
    listOf("info", LOG),
    listOf("info", "--json", LOG),
    listOf("find", LOG, "min(Battery Voltage) < 12"),
    listOf("find", LOG, "count(\"Superstructure/State\" == 'IDLE')"),
    listOf("report", "--out", "Prüfbericht", LOG),
    listOf("export", LOG),
    listOf("convert", LOG, "--out", "gewöhnlich.wpilog"),
    listOf("cut", LOG, "--from", "3", "--to", "5", "--out", "$DEEP/Stück.bag"),
    listOf("info", "$DEEP/Stück.bag"),
    listOf("recover", "torn.bag"),
    listOf("lake", LOG, "--out", "Tabellen"),
    listOf("sql", "Tabellen", "SELECT log, \"System/Battery Voltage\".min AS lowest FROM match_statistics WHERE number < 5"),
    listOf("sql", ".", "SELECT log, topic FROM topics ORDER BY ALL LIMIT 5"),
    listOf("mcp", "."),
)

/** The messages of an assistant that lists the logs. */
private val CONVERSATION = listOf(
    """{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{},"clientInfo":{"name":"t","version":"1"}}}""",
    """{"jsonrpc":"2.0","method":"notifications/initialized"}""",
    """{"jsonrpc":"2.0","id":2,"method":"tools/call","params":{"name":"list_logs","arguments":{}}}""",
).joinToString("\n", postfix = "\n")

/** Java under Wine can read a file as its input only if Wine itself has opened that. */
private const val MCP_SCRIPT = "@call badlog\\bin\\badlog.bat mcp . < conversation.txt\r\n"

/** An assistant receives when a file was written, which is now. */
private val WRITTEN = Regex("""\\"written\\":\\"[^"]*\\"""")

/** A folder with umlauts and spaces that has badlog, a log, and a torn one. */
private fun folderIn(root: File) = File(root, "Prüfung der Größe").apply {
    mkdirs()
    File(System.getProperty("badlog.installed")).copyRecursively(File(this, "badlog"))
    File(this, "badlog/bin/badlog").setExecutable(true)
    File(System.getProperty("badlog.samples"), "practice.bag").copyTo(File(this, LOG))
    File(this, "torn.bag").writeBytes(File(this, LOG).readBytes().copyOf(100_000))
    File(this, "conversation.txt").writeText(CONVERSATION)
    File(this, "mcp.bat").writeText(MCP_SCRIPT)
}

/** What Wine itself says now and then, on a busy machine, of faults that Java handles. */
private val SAID_BY_WINE = Regex("(?m)^wine: .*\n")

/** The output, with the exit code; line ends and paths are written alike for both machines. */
private fun saidBy(run: LimitedRun) = run.text.replace("\r\n", "\n").replace(SAID_BY_WINE, "").replace(WRITTEN, "").replace('\\', '/') + "-> ${run.code}"

/** The names of the files that commands have made in [folder], and their bytes. Tables are left out, since they hold paths and times. */
private fun madeIn(folder: File): Map<String, List<Byte>> = folder.walk().onEnter { it.name !in setOf("badlog", "cache", "Tabellen") }.filter { it.isFile && it.name != LOG }
    .associate { it.relativeTo(folder).invariantSeparatorsPath to it.readBytes().toList() }

/** The whole program under Windows' Java; `./gradlew :command-line:platforms` runs it, not `check`. */
class ProgramOnWindowsSpec : FunSpec({
    val java = System.getProperty("badlog.platforms.java").orEmpty()
    val enabled = if (java.isEmpty()) Enabled.disabled(System.getProperty("badlog.platforms.missing") ?: "run ./gradlew platforms") else Enabled.enabled

    val root = Files.createTempDirectory("badlog-platforms").toFile()
    val here by lazy { folderIn(File(root, "here")) }
    val windows by lazy { folderIn(File(root, "windows")) }
    val wine = lazy { Wine() }
    afterSpec {
        if (wine.isInitialized()) wine.value.close()
        root.deleteRecursively()
    }

    fun variables(folder: File) = mapOf("LC_ALL" to "C.UTF-8", "COLUMNS" to "100", "XDG_CACHE_HOME" to "$folder/cache")

    fun answerHere(arguments: List<String>): String {
        val input = if (arguments.first() == "mcp") File(here, "conversation.txt") else null
        return saidBy(LimitedRun.of(listOf("badlog/bin/badlog") + arguments, variables(here), here, input))
    }

    fun answerOfWindows(arguments: List<String>): String {
        val script = when {
            arguments.first() == "mcp" -> listOf("mcp.bat")
            arguments.first().endsWith(".bat") -> arguments
            else -> listOf("badlog\\bin\\badlog.bat") + arguments
        }
        val variables = variables(windows) + mapOf(
            "JAVA_HOME" to "Z:" + java.replace('/', '\\'),
            // Otherwise its console has the characters of Western Europe only. For the others, badlog writes words, such as “ohm” for Ω.
            "JAVA_OPTS" to "-Dsun.stdout.encoding=UTF-8 -Dsun.stderr.encoding=UTF-8",
            "LOCALAPPDATA" to "Z:" + "$windows/cache".replace('/', '\\'),
        )
        return saidBy(wine.value.run(listOf("wine", "cmd", "/c") + script, variables, windows))
    }

    for (command in COMMANDS) {
        test("badlog.bat answers as badlog does here: ${command.joinToString(" ").take(60)}").config(enabledOrReasonIf = { enabled }) {
            val said = answerHere(command)
            // A command that fails on both machines alike would compare nothing.
            (said.substringAfterLast("-> ") in setOf("0", "3")) shouldBe true
            answerOfWindows(command) shouldBe said
        }
    }

    test("the files that these commands have made have the same names and bytes, also beyond 260 characters").config(enabledOrReasonIf = { enabled }) {
        val made = madeIn(here)
        made.keys shouldContainAll listOf("Prüfbericht/index.html", "gewöhnlich.wpilog", "$DEEP/Stück.bag")
        ("$windows/$DEEP/Stück.bag".length > OLD_LIMIT) shouldBe true
        val others = madeIn(windows)
        others.keys shouldBe made.keys
        others.filter { (name, bytes) -> made[name] != bytes }.keys shouldBe emptySet()
    }

    test("quoted wildcards, which no shell expands on Windows, name files").config(enabledOrReasonIf = { enabled }) {
        val said = answerHere(listOf("info", "--only", "*battery voltage", "torn.bag", "torn.recovered.bag"))
        answerOfWindows(listOf("info", "--only", "*battery voltage", "torn*.bag")) shouldBe said
    }

    test("a path with Windows' prefix for long paths is the same log").config(enabledOrReasonIf = { enabled }) {
        val path = "Z:$windows/$DEEP/Stück.bag".replace('/', '\\')
        answerOfWindows(listOf("info", "--json", "\\\\?\\$path")) shouldBe answerOfWindows(listOf("info", "--json", path))
    }

    test("a file that another program has open is not replaced: a sentence has the reason, and no other file is left beside it").config(enabledOrReasonIf = { enabled }) {
        File(windows, "held.bat").writeText("@call badlog\\bin\\badlog.bat cut torn.bag --from 1 --to 2 --force --out held.bag > held.bag\r\n")
        answerOfWindows(listOf("held.bat")) shouldContain "held.bag cannot be replaced: it is read-only, or another program has it open"
        File(windows, "held.bag").length() shouldBe 0
        windows.listFiles().orEmpty().map { it.name }.filter { it.startsWith(".") } shouldBe emptyList()
    }
})
