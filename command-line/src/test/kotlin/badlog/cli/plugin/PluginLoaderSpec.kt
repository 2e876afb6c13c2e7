package badlog.cli.plugin

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.Ended
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.net.URL
import java.nio.file.Files
import java.nio.file.Path
import java.util.Collections
import java.util.Enumeration
import java.util.concurrent.TimeUnit
import kotlin.io.path.div
import kotlin.io.path.fileSize
import kotlin.io.path.name
import kotlin.io.path.readLines

@Tags("InCheck")
class PluginLoaderSpec : FunSpec({
    test("the class path of the program has only the listed jars, since each costs time at every start") {
        val wanted = Path.of("../../src/test/resources/class-path.txt").readLines().filter { it.isNotEmpty() && !it.startsWith('#') }
        namesIn(LIBRARIES) shouldContainExactly wanted
    }

    test("a part has its own libraries, but not those of the program") {
        val part = namesIn(LIBRARIES / PluginLoader.FOLDER)
        part shouldContain "assistant"
        part.filter { it.startsWith("kotlin-stdlib") || it.startsWith("kotlinx-serialization") } shouldContainExactly emptyList()
        // Two of the same would not know each other's classes.
        jarsIn(LIBRARIES / PluginLoader.FOLDER).map { it.name }.filter { it in jarsIn(LIBRARIES).map { jar -> jar.name } } shouldContainExactly emptyList()
    }

    test("the installed program loads a part when it is called, and prints nothing but the protocol") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val process = program("mcp", folder.toString())
            val out = process.inputReader()
            process.outputWriter().use { toServer ->
                fun ask(message: String): String {
                    toServer.write(message + "\n")
                    toServer.flush()
                    return out.readLine()
                }
                val hello = ask(
                    """{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-06-18","capabilities":{},"clientInfo":{"name":"a test","version":"1"}}}""",
                )
                Json.parseToJsonElement(hello).jsonObject.getValue("result").jsonObject.getValue("serverInfo").jsonObject.getValue("name").jsonPrimitive.content shouldBe "badlog"
                toServer.write("""{"jsonrpc":"2.0","method":"notifications/initialized"}""" + "\n")
                // A line that is not a message is lost alone.
                ask("hello?") shouldContain "-32700"
                val answer = ask("""{"jsonrpc":"2.0","id":2,"method":"tools/call","params":{"name":"list_logs","arguments":{}}}""")
                Json.parseToJsonElement(answer).jsonObject.getValue("id").jsonPrimitive.content shouldBe "2"
                answer shouldContain "a.bag"
            }
            out.readLines() shouldContainExactly emptyList()
            process.waitFor(2, TimeUnit.MINUTES) shouldBe true
            process.exitValue() shouldBe 0
            process.errorReader().readText() shouldNotContain "\tat "
        }
    }

    test("the installed program draws charts with a part that has copies of Java's classes") {
        inFolder { folder ->
            val process = program("report", SAMPLES.toString(), "--out", (folder / "report").toString(), "--charts", "--no-cache")
            process.inputReader().readText() shouldContain "Qualification 42"
            process.errorReader().readText() shouldNotContain "\tat "
            process.waitFor() shouldBe ExitCode.SALVAGED.code
            (folder / "report/charts/battery.png").fileSize() shouldBeGreaterThan 10_000
            (folder / "report/charts/battery.svg").fileSize() shouldBeGreaterThan 5_000
        }
    }

    test("an installed program without the part says how to get it, and runs all other commands") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val own = jarsIn(LIBRARIES).single { it.name.startsWith("command-line") }
            val copy = Files.copy(own, folder / own.name)
            val jars = listOf(copy) + (jarsIn(LIBRARIES) - own)
            val without = programOf(jars, "mcp", folder.toString())
            without.errorReader().readText() shouldContain "badlog mcp needs badlog's part “season”, but the folder ${folder / "season"} is missing"
            without.waitFor() shouldBe ExitCode.NOTHING.code
            val converted = programOf(jars, "convert", log.toString(), "--to", "parquet")
            converted.errorReader().readText() shouldContain "badlog convert --to parquet needs badlog's part “season”"
            converted.waitFor() shouldBe ExitCode.NOTHING.code
            val charts = programOf(jars, "report", log.toString(), "--out", (folder / "report").toString(), "--charts")
            charts.errorReader().readText() shouldContain "badlog report --charts needs badlog's part “season”"
            charts.waitFor() shouldBe ExitCode.NOTHING.code
            val info = programOf(jars, "info", log.toString())
            info.inputReader().readText() shouldContain "Speed"
            info.waitFor() shouldBe ExitCode.WHOLE.code
            programOf(jars, "help").inputReader().readText() shouldContain "  mcp "
        }
    }

    test("a part that is incomplete is reported as one that is missing") {
        inFolder { folder ->
            (folder / PluginLoader.FOLDER).with("broken.jar", "no jar")
            val ended = badlogWith(PluginLoader(WithoutServices, folder / PluginLoader.FOLDER), "mcp", folder.toString())
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "is missing or incomplete"
        }
    }

    test("mcp refuses a missing folder and a file") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val nowhere = folder / "nowhere"
            for ((path, reason) in listOf(nowhere to "There is no file or folder $nowhere", log to "$log is a file, not a folder")) {
                val ended = badlog("mcp", path)
                ended.code shouldBe ExitCode.NOTHING
                ended.err shouldContain reason
            }
        }
    }
})

private fun program(vararg arguments: String) = ProcessBuilder(javaCommand(*arguments)).start()

private fun programOf(jars: List<Path>, vararg arguments: String) = ProcessBuilder(javaCommand(jars, arguments.toList())).start()

private fun badlogWith(parts: PluginLoader, vararg arguments: String): Ended {
    val out = ByteArrayOutputStream()
    val err = ByteArrayOutputStream()
    val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(err, true, "UTF-8"), false)
    val code = Badlog(console, parts = parts).run(arguments.toList())
    return Ended(code, out.toString(Charsets.UTF_8), err.toString(Charsets.UTF_8))
}

/** The classes of the tests, which have the part among them, without what says so. */
private object WithoutServices : ClassLoader(PluginLoaderSpec::class.java.classLoader) {
    override fun getResources(name: String): Enumeration<URL> = if (name.startsWith("META-INF/services/badlog")) Collections.emptyEnumeration() else super.getResources(name)
}
