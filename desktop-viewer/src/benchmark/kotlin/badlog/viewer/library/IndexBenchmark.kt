package badlog.viewer.library

import badlog.viewer.library.index.IndexCache
import badlog.viewer.library.index.Indexing
import java.io.IOException
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.DurationUnit
import kotlin.time.TimeSource
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking

/** Measures the index of the folder that `args[0]` names: with an empty cache, then with the cache that this filled. */
fun main(args: Array<String>) {
    val folder = Path.of(args[0]).toAbsolutePath().normalize()
    val home = Files.createTempDirectory("index-benchmark")
    try {
        measure("cold", folder, home)
        repeat(3) { measure("warm", folder, home) }
        println("peak memory of the process: ${peakMegabytes()} MB")
    } finally {
        home.toFile().deleteRecursively()
    }
}

private fun measure(name: String, folder: Path, home: Path) = runBlocking {
    val cpu = ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean::class.java)
    val cpuBefore = cpu.processCpuTime
    val began = TimeSource.Monotonic.markNow()
    val indexing = Indexing(folder, IndexCache(home, folder))
    val job = launch(Dispatchers.Default) { indexing.run() }
    while (!indexing.hasLooked || indexing.queue.state().waiting > 0) delay(1)
    val took = began.elapsedNow().toString(DurationUnit.MILLISECONDS)
    val entries = indexing.queue.state().entries
    println("$name: ${entries.size} logs, ${entries.sumOf { it.topics.size }} topics in $took, ${(cpu.processCpuTime - cpuBefore) / 1_000_000} ms of CPU")
    job.cancelAndJoin()
}

/** What the system has counted, as Linux tells it; elsewhere it is not known. */
private fun peakMegabytes(): Int? = try {
    Files.readAllLines(Path.of("/proc/self/status")).first { it.startsWith("VmHWM") }.filter { it.isDigit() }.toInt() / 1024
} catch (_: IOException) {
    null
}
