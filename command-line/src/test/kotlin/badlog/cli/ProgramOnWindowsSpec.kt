package badlog.cli

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.file.Files

private const val LOG = "Größe über alles.bag"

/** What an assistant says: it lists the logs. */
private val CONVERSATION = listOf(
    """{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{},"clientInfo":{"name":"t","version":"1"}}}""",
    """{"jsonrpc":"2.0","method":"notifications/initialized"}""",
    """{"jsonrpc":"2.0","id":2,"method":"tools/call","params":{"name":"list_logs","arguments":{}}}""",
).joinToString("\n", postfix = "\n")

private val WRITTEN = Regex("""\\"written\\":\\"[^"]*\\"""")

/**
 * A machine with badlog in a folder with umlauts and spaces.
 *
 * @param start the words that start its program there.
 */
private class Machine(private val folder: File, private val environment: Map<String, String>, private val start: (List<String>) -> List<String>) {
    /** What is said, with the exit code; the machine's ways of writing line ends and paths are made one. */
    fun answer(arguments: List<String>): String {
        val process = ProcessBuilder(start(arguments)).directory(folder).redirectErrorStream(true)
        process.environment() += environment
        process.environment() += mapOf("LC_ALL" to "C.UTF-8", "XDG_CACHE_HOME" to "$folder/cache", "COLUMNS" to "100")
        val conversation = File(folder, "conversation.txt")
        if (arguments.firstOrNull() == "mcp") process.redirectInput(conversation)
        val started = process.start()
        if (arguments.firstOrNull() != "mcp") started.outputStream.close()
        val said = started.inputStream.readBytes().decodeToString()
        val code = started.waitFor()
        // An assistant hears when a file was written, which is now.
        return said.replace("\r\n", "\n").replace(WRITTEN, "").replace('\\', '/') + "-> $code"
    }

    /** The names of the files that commands have made, and their bytes. */
    fun made(): Map<String, List<Byte>> = folder.walk().onEnter { it.name !in setOf("badlog", "cache") }.filter { it.isFile && it.name != LOG }
        .associate { it.relativeTo(folder).invariantSeparatorsPath to it.readBytes().toList() }
}

/** The whole program under Windows' Java; `./gradlew :command-line:underWine` runs it, not `check`. */
class ProgramOnWindowsSpec : FunSpec({
    val java = System.getProperty("badlog.platforms.java").orEmpty()
    val missing = System.getProperty("badlog.platforms.missing") ?: "run ./gradlew platforms"

    test("every command gives the same answers and files under Windows, in a folder with umlauts and spaces, as here").config(
        enabledOrReasonIf = { if (java.isEmpty()) Enabled.disabled(missing) else Enabled.enabled },
    ) {
        val root = Files.createTempDirectory("badlog-platforms").toFile()
        try {
            fun folderOf(name: String) = File(root, "$name/Prüfung der Größe").apply {
                mkdirs()
                File(System.getProperty("badlog.installed")).copyRecursively(File(this, "badlog"))
                File(this, "badlog/bin/badlog").setExecutable(true)
                File(System.getProperty("badlog.samples"), "practice.bag").copyTo(File(this, LOG))
                File(this, "torn.bag").writeBytes(File(this, LOG).readBytes().copyOf(100_000))
                File(this, "conversation.txt").writeText(CONVERSATION)
                File(this, "mcp.bat").writeText("@type conversation.txt | badlog\\bin\\badlog.bat mcp .\r\n")
            }
            val here = Machine(folderOf("here"), emptyMap()) { listOf("badlog/bin/badlog") + it }
            val wine = mapOf(
                "WINEPREFIX" to System.getProperty("badlog.platforms.wine"),
                "WINEDEBUG" to "-all",
                "WINEDLLOVERRIDES" to "mscoree=;mshtml=",
                "JAVA_HOME" to "Z:" + java.replace('/', '\\'),
                // Otherwise its console has the signs of Western Europe only, and badlog spells out the others, such as “ohm” for Ω.
                "JAVA_OPTS" to "-Dsun.stdout.encoding=UTF-8 -Dsun.stderr.encoding=UTF-8",
            )
            val windows = Machine(folderOf("windows"), wine) { arguments ->
                // Java under Wine cannot read a file or a pipe of this system as its input.
                if (arguments.first() == "mcp") listOf("wine", "cmd", "/c", "mcp.bat") else listOf("wine", "cmd", "/c", "badlog\\bin\\badlog.bat") + arguments
            }
            // Wine makes its drive C, with many words, when it is first started.
            Machine(root, wine) { listOf("wine", "wineboot", "-i") }.answer(emptyList())
            val commands = listOf(
                listOf("info", LOG),
                listOf("info", "--json", LOG),
                listOf("find", LOG, "min(Battery Voltage) < 12"),
                listOf("report", "--out", "Prüfbericht", LOG),
                listOf("export", LOG),
                listOf("convert", LOG, "--out", "gewöhnlich.wpilog"),
                listOf("cut", LOG, "--from", "3", "--to", "5", "--out", "Stück.bag"),
                listOf("recover", "torn.bag"),
                listOf("sql", ".", "SELECT log, topic FROM topics ORDER BY ALL LIMIT 5"),
                listOf("mcp", "."),
            )
            commands.map { it.first() to windows.answer(it) } shouldContainExactly commands.map { it.first() to here.answer(it) }
            val made = here.made()
            made.keys.shouldNotBeEmpty()
            windows.made().keys shouldBe made.keys
            windows.made().filter { (name, bytes) -> made[name] != bytes }.keys shouldBe emptySet()
        } finally {
            root.deleteRecursively()
        }
    }
})
