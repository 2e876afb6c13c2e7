package badlog.window.benchmark

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.fileSize
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** Measures the window, and writes the results to the file that the first argument names. The second may name a folder of bags. */
fun main(args: Array<String>) {
    val report = Path.of(args[0])
    val bags = args.getOrElse(1) { "" }
    val pictures = Path.of("build", "pictures")
    val paths = measurePathFrames(pictures)
    val frames = measureFrames(pictures)
    val openings = if (bags.isEmpty()) emptyList() else openingsOf(Path.of(bags), pictures)
    val blocks = measureChoiceBlocks()
    val list = measureListBlocks(pictures.resolve("list.png"))
    val live = measureLiveFrames()
    val text = reportOf(frames, paths, blocks, list, live, openings)
    Files.writeString(report, text)
    println(text)
    println("Written to $report")
    System.exit(0)
}

private fun openingsOf(folder: Path, pictures: Path): List<Pair<Path, List<Opening>>> =
    folder.listDirectoryEntries().filter { it.extension == "bag" }.sortedBy { it.fileSize() }.map { file ->
        file to List(OPENINGS) { measureOpening(file, pictures.resolve("${file.name}.png")) }
    }

private fun reportOf(
    frames: List<FrameTimes>,
    paths: List<FrameTimes>,
    blocks: List<FrameTimes>,
    list: List<FrameTimes>,
    live: List<FrameTimes>,
    openings: List<Pair<Path, List<Opening>>>,
): String = buildString {
    val system = listOf("os.name", "os.arch").joinToString(" ") { System.getProperty(it) }
    val command = "./gradlew :desktop-viewer:benchmark" + if (openings.isEmpty()) "" else " -PbenchmarkBags=DIR"
    appendLine("# Benchmarks of the viewer")
    appendLine()
    appendLine("Made by `$command` on ${Runtime.getRuntime().availableProcessors()} cores")
    appendLine("($system, Java ${System.getProperty("java.version")}): the window's own graphs, 1600×900, drawn off screen by software.")
    appendLine("Machines are noisy: compare ratios within one run, not figures of two.")
    appendLine()
    appendLine("## A frame, with ten graphs of a million samples each")
    appendLine()
    appendLine("The time from the change to the picture with the new data, including the work on other threads than the window's.")
    appendLine()
    appendTimes(frames)
    appendLine()
    appendLine("## A frame, with the path of a million poses and its plan of as many")
    appendLine()
    appendTimes(paths)
    appendLine()
    appendLine("## The longest block, with a log of a million rows, five formulas, and another log compared")
    appendLine()
    appendLine("For how long the window's thread is busy at most without a break, from a choice to the picture of its result.")
    appendLine()
    appendTimes(blocks)
    appendLine()
    appendLine("## The longest block in a table of 1,000 logs")
    appendLine()
    appendTimes(list)
    appendLine()
    appendLine("## Live: from the disk to the picture")
    appendLine()
    appendLine(
        "A WPILOG of 50 topics grows by 50 rows a second; how long after a row was written its picture is there, by the size of the log.",
    )
    appendLine()
    appendTimes(live, "size")
    if (openings.isEmpty()) return@buildString
    appendLine()
    appendLine("## Opening")
    appendLine()
    appendLine("From asking for the file to the picture of its first graphs, in a fresh window; the median of $OPENINGS.")
    appendLine()
    appendLine("| bag | size | first graphs | peak memory of the process |")
    appendLine("|---|---|---|---|")
    for ((file, runs) in openings) {
        val seconds = runs.map { it.seconds }.sorted()[runs.size / 2]
        val memory = runs.maxOf { it.megabytes }
        val megabytes = "%.1f MB".format(file.fileSize() / 1e6)
        appendLine("| ${file.name} | $megabytes | ${"%.2f s".format(seconds)} | ${"%.0f MB".format(memory)} |")
    }
}

private fun StringBuilder.appendTimes(frames: List<FrameTimes>, what: String = "change") {
    appendLine("| $what | median | 95th percentile | slowest | of |")
    appendLine("|---|---|---|---|---|")
    for (times in frames) {
        val figures = listOf(50, 95, 100).joinToString(" | ") { "%.1f ms".format(times.percentile(it)) }
        appendLine("| ${times.name} | $figures | ${times.millis.size} |")
    }
}

private const val OPENINGS = 3
