package badlog.window.benchmark

import badlog.window.app.ViewerScreen
import badlog.window.app.warmUpGraphs
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

/**
 * The result of opening a bag.
 *
 * @property seconds the time from the request to the picture of the first graphs.
 * @property megabytes the peak memory of the whole process as the system counts it; NaN if the system does not report it.
 */
internal class Opening(val seconds: Double, val megabytes: Double)

/** Opens the bag that the first argument names in an existing window, and prints the time and memory it needed. */
internal fun main(args: Array<String>) {
    val file = Path.of(args[0])
    OffScreenWindow { viewer -> ViewerScreen(viewer) }.use { window ->
        window.measure { true }
        // The window does the same after its first frame.
        val warmUp = window.viewer.scope.launch { warmUpGraphs(window.folders) }
        window.measure { warmUp.isCompleted }
        val millis = window.measure({ window.viewer.loader.open(file) }) {
            window.viewer.current.recording != null &&
                window.viewer.graphs.plots.areReady(window.viewer.compared.drawn, window.viewer.view.viewport.visible)
        }
        val peak = peakMegabytes()
        if (args.size > 1) window.save(Path.of(args[1]))
        println("opened ${millis / 1e3} $peak")
    }
    System.exit(0)
}

/** Opens [file] in a Java process of its own, with as much memory as the window has. */
internal fun measureOpening(file: Path, picture: Path): Opening {
    val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
    val options = System.getProperty("badlog.viewer.options").split(' ')
    val process = ProcessBuilder(
        listOf(java) + options +
            listOf(
                "-cp",
                System.getProperty("java.class.path"),
                "badlog.window.benchmark.OpeningBenchmarkKt",
                file.toString(),
                picture.toString(),
            ),
    ).redirectError(ProcessBuilder.Redirect.INHERIT).start()
    val output = process.inputStream.bufferedReader().readText()
    check(process.waitFor() == 0) { "The window could not open $file: $output" }
    val words = output.lines().first { it.startsWith("opened ") }.split(' ')
    return Opening(words[1].toDouble(), words[2].toDouble())
}

private fun peakMegabytes(): Double {
    val status = Path.of("/proc/self/status")
    if (!Files.exists(status)) return Double.NaN
    val line = Files.readAllLines(status).firstOrNull { it.startsWith("VmHWM:") } ?: return Double.NaN
    return line.filter { it.isDigit() }.toDouble() / 1000
}
