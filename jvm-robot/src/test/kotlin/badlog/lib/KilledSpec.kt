package badlog.lib

import badlog.core.recording.Severity
import badlog.core.waiting.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.property.PropertyTesting
import java.io.File
import java.nio.ByteBuffer
import java.util.concurrent.Executors
import kotlin.random.Random

/** The number of robots that are killed: some in each build, 200 by `thoroughTest`. */
private val KILLS = PropertyTesting.defaultIterationCount / 5

/** The largest number of rows, roughly, that a robot has logged when it is killed. */
private const val MAX_ROWS = 1000L

/** The header, the names of the topics, then the first row. */
private const val FIRST_ROW_LINE = 3

@Tags("InCheck")
class KilledSpec : FunSpec({
    test("after killing $KILLS robots within their loops, each file has every row for which log() returned") {
        inFolder { folder ->
            val pool = Executors.newFixedThreadPool(2)
            val kills = List(KILLS) { number -> pool.submit<String?> { killOne(folder, number) } }
            pool.shutdown()
            kills.mapNotNull { it.get() }.shouldBeEmpty()
        }
    }
})

/** Kills a robot, and returns the first fault of its log; null if there is none. */
private fun killOne(folder: File, number: Int): String? {
    val compress = number % 2 == 1
    val returned = File(folder, "$number.returned")
    val path = File(folder, "$number.bag")
    val process = ProcessBuilder(childCommand(listOf(path.path, "100000000", "$compress", returned.path)))
        .redirectErrorStream(true).redirectOutput(File(folder, "$number.txt")).start()
    val enough = Random(number).nextLong(1, MAX_ROWS)
    eventually("row $enough of robot $number") { rowsReturned(returned) >= enough || !process.isAlive }
    process.destroyForcibly().waitFor()

    val rows = rowsReturned(returned)
    val file = if (compress) File("$path.gz") else path
    val recording = recordingIn(if (compress) inflated(file.readBytes()) else file.readBytes())
    val samples = recording.topics.firstOrNull()?.samples ?: DoubleArray(0)
    val whole = (0 until rows.toInt()).all { it < samples.size && samples[it] == it.toDouble() }
    val output = File(folder, "$number.txt").readText()
    listOf(file, path, returned).forEach(File::delete)
    // Only the row with an unfinished call of log() may be cut, and nothing before it.
    val lost = recording.problems.filter { it.severity == Severity.ERROR && (it.line ?: 0) < FIRST_ROW_LINE + rows }
    return if (rows > 0 && whole && lost.isEmpty() && output.isEmpty()) {
        null
    } else {
        "robot $number: $rows rows returned, ${samples.size} found, ${recording.problems}, output: $output"
    }
}

private fun rowsReturned(file: File): Long = if (file.length() < Long.SIZE_BYTES) 0 else ByteBuffer.wrap(file.readBytes()).getLong()
