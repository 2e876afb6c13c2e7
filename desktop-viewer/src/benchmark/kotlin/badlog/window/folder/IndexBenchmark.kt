package badlog.window.folder

import badlog.files.FolderScan
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import java.io.IOException
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.DurationUnit
import kotlin.time.TimeSource
import kotlin.time.measureTime

/**
 * Measures the index of the folder that `args[0]` names, with an empty cache and then with the filled one. Each run has a process of its
 * own, as when the viewer starts. `args[1]` is the folder of the filled cache; only the second process gets it.
 */
fun main(args: Array<String>) {
    val folder = Path.of(args[0]).toAbsolutePath().normalize()
    if (args.size > 1) {
        measure("warm, first in its process", folder, Path.of(args[1]))
        repeat(2) { measure("warm, again", folder, Path.of(args[1])) }
    } else {
        val home = Files.createTempDirectory("index-benchmark")
        try {
            measure("cold", folder, home)
            ProcessBuilder(sameProcess() + listOf(folder.toString(), home.toString())).inheritIO().start().waitFor()
        } finally {
            home.toFile().deleteRecursively()
        }
    }
    measureLooks(folder)
}

/** Returns the command that starts this program the way it was started, without its arguments. */
private fun sameProcess(): List<String> {
    val java = ManagementFactory.getRuntimeMXBean()
    return listOf(Path.of(System.getProperty("java.home"), "bin", "java").toString()) + java.inputArguments +
        listOf("-cp", java.classPath, "badlog.window.folder.IndexBenchmarkKt")
}

private fun measureLooks(folder: Path) {
    val looks = List(50) { measureTime { FolderScan.of(folder) } }.sorted()
    println("a look at the folder: ${looks[25].toString(DurationUnit.MILLISECONDS, 1)} (median of 50)")
}

private fun measure(name: String, folder: Path, home: Path) = runBlocking {
    val cpu = ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean::class.java)
    val cpuBefore = cpu.processCpuTime
    val began = TimeSource.Monotonic.markNow()
    val indexing = Indexing(folder, home)
    val job = launch(Dispatchers.Default) { indexing.run() }
    while (!indexing.hasLooked || indexing.queue.state().waiting > 0) delay(1)
    val took = began.elapsedNow().toString(DurationUnit.MILLISECONDS)
    val entries = indexing.queue.state().entries
    val cpuMillis = (cpu.processCpuTime - cpuBefore) / 1_000_000
    println("$name: ${entries.size} logs, ${entries.sumOf { it.summary.topics.size }} topics in $took, $cpuMillis ms of processor time")
    println("  most memory of the process so far: ${peakMegabytes()} MB")
    measureFindings(indexing)
    job.cancelAndJoin()
}

/** Measures the rules, which run over all logs as soon as these are listed. Logs in which nothing happens are left out. */
private suspend fun measureFindings(indexing: Indexing) {
    val before = indexing.queue.state().entries.count { it.found != null }
    val began = TimeSource.Monotonic.markNow()
    while (indexing.queue.state().entries.any { it.isReadable && !it.isGray && it.found == null }) delay(20)
    val found = indexing.queue.state().entries.count { it.found != null } - before
    val took = began.elapsedNow()
    val each = (took / maxOf(found, 1)).toString(DurationUnit.MILLISECONDS)
    println("  findings of $found logs in ${took.toString(DurationUnit.SECONDS, 1)}, $each each")
    println("  most memory of the process so far: ${peakMegabytes()} MB")
}

/** Returns the peak memory of the process in megabytes, as Linux counts it; null on other systems. */
private fun peakMegabytes(): Int? = try {
    Files.readAllLines(Path.of("/proc/self/status")).first { it.startsWith("VmHWM") }.filter { it.isDigit() }.toInt() / 1024
} catch (_: IOException) {
    null
}
