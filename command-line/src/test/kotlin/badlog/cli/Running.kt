package badlog.cli

import badlog.cli.command.ExitCode
import badlog.cli.computer.Computer
import badlog.cli.console.Console
import badlog.cli.fetch.Robots
import badlog.cli.text.LINE_WIDTH
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogWriter
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import java.io.ByteArrayOutputStream
import java.io.InputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import kotlin.io.path.div
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.outputStream
import kotlin.io.path.writeBytes

/** The samples, copied to where tests run. */
internal val SAMPLES: Path = Path.of("samples")

/** The project's own folder. */
internal val ROOT: Path = Path.of("../../..")

/** A small whole bag, with an event and the robot enabled from 0.02 to 0.06. */
internal val BAG: String = """
    {"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Speed","unit":"m/s","attrs":[]},{"name":"Enabled"},{"name":"Log","attrs":["log"]}],"values":[{"name":"Match Number","value":"42"}]}
    Time,Speed,Enabled,Log
    0,1.5,false,
    0.02,2.5,true,go
    0.04,3.5,true,
    0.06,,true,stop
    0.08,5.5,false,

""".trimIndent()

/** The same bag after a loss of power in its last row. */
internal val CUT_BAG: String = BAG.dropLast(9)

/** The output and exit code of the program. */
internal class Ended(val code: ExitCode, val out: String, val err: String) {
    /** Each line of the output as a JSON object. */
    val json: List<JsonObject> get() = out.lines().filter { it.isNotEmpty() }.map { Json.parseToJsonElement(it).jsonObject }
}

/** Runs `badlog` with [arguments], and makes sure that it meets no defect of its own. */
internal fun badlog(vararg arguments: Any): Ended = badlogBeside(Robots.ofSystem(), *arguments)

/** The same where [robots] are in the network. */
internal fun badlogBeside(robots: Robots, vararg arguments: Any): Ended = badlogOn(Computer(), *arguments, robots = robots)

/** The same on another [computer]. */
internal fun badlogOn(
    computer: Computer,
    vararg arguments: Any,
    robots: Robots = Robots.ofSystem(),
    input: InputStream = InputStream.nullInputStream(),
    width: Int = LINE_WIDTH,
): Ended {
    val out = ByteArrayOutputStream()
    val err = ByteArrayOutputStream()
    val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(err, true, "UTF-8"), false, width = width)
    val code = Badlog(console, input, robots = robots, computer = computer).run(arguments.map { it.toString() })
    err.toString(Charsets.UTF_8) shouldNotContain "\tat "
    err.toString(Charsets.UTF_8) shouldNotContain "defect"
    out.toString(Charsets.UTF_8) shouldNotContain "defect"
    return Ended(code, out.toString(Charsets.UTF_8), err.toString(Charsets.UTF_8))
}

/** The same with `--json`: nothing is said but JSON. */
internal fun badlogJson(vararg arguments: Any): Ended = badlog(*arguments, "--json").also { if (it.json.isNotEmpty()) it.err shouldBe "" }

/** A file [name] in this folder, with [content]. */
internal fun Path.with(name: String, content: String): Path = with(name, content.encodeToByteArray())

/** A file [name] in this folder, with [content]. */
internal fun Path.with(name: String, content: ByteArray): Path = (this / name).apply {
    Files.createDirectories(parent)
    writeBytes(content)
}

/** The names of all files in this folder, hidden ones too. */
internal fun Path.names(): List<String> = listDirectoryEntries().map { it.name }.sorted()

/** [text] compressed. */
internal fun gzip(text: String): ByteArray {
    val out = ByteArrayOutputStream()
    GZIPOutputStream(out).use { it.write(text.encodeToByteArray()) }
    return out.toByteArray()
}

/** The sample [name] as a WPILOG in this folder, without its damage. */
internal fun Path.sampleLog(name: String): Path = (this / "$name.wpilog").apply {
    outputStream().use { out ->
        WpilogWriter(readRecording(SAMPLES / name, LOG_FORMATS)).write { bytes, size -> out.write(bytes, 0, size) }
    }
}
