package badlog.exporter.program

import badlog.exporter.BAG
import badlog.exporter.HtmlExporter
import io.kotest.matchers.string.shouldNotContain
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.name
import kotlin.io.path.writeText

/** The result of a run of the program. */
internal class Ended(val code: ExitCode, out: String, val err: String, val opened: List<Path>) {
    val lines = out.lines().filter { it.isNotEmpty() }
}

/** Returns an exporter that makes pages, but fails unexpectedly for a file with this [name]. */
private fun failingOn(name: String) = { attachments: List<Path>, compared: List<Path> ->
    val exporter = HtmlExporter(attachments, compared)
    val export: Export = { input, page, additions, progress ->
        check(input.name != name) { "Out of cheese\n+++" }
        exporter.export(input, page, additions, progress)
    }
    export
}

/** Runs the program. The file [failsOn] causes a defect in its exporter; [canOpen] is whether a browser can be started. */
internal fun run(vararg arguments: Any, canOpen: Boolean = true, failsOn: String = ""): Ended {
    val out = ByteArrayOutputStream()
    val err = ByteArrayOutputStream()
    val opened = ArrayList<Path>()
    val program = BadlogHtml(PrintStream(out), PrintStream(err), false, failingOn(failsOn)) { page ->
        opened.add(page)
        canOpen
    }
    val code = program.run(arguments.map { it.toString() })
    err.toString() shouldNotContain "\tat "
    return Ended(code, out.toString(), err.toString(), opened)
}

/** Writes a file into this folder. */
internal fun Path.with(name: String, content: String = BAG): Path = (this / name).apply { writeText(content) }
