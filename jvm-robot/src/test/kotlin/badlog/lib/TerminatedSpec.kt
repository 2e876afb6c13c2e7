package badlog.lib

import badlog.core.waiting.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import java.io.File
import java.nio.ByteBuffer
import java.util.zip.GZIPInputStream

/** Whether the system can ask a program to end by a signal, before it is killed a second later. Windows has no such signal. */
private val HAS_SIGNALS = !System.getProperty("os.name").startsWith("Windows")

@Tags("InCheck")
class TerminatedSpec : FunSpec({
    for (isCompressed in listOf(false, true)) {
        val kind = if (isCompressed) "gzipped" else "plain"

        test("a robot ended by a signal leaves a $kind log with every row and its end").config(enabled = HAS_SIGNALS) {
            inFolder { folder ->
                val returned = File(folder, "returned")
                val path = File(folder, "a.bag")
                val command = childCommand(listOf(path.path, "100000000", "$isCompressed", returned.path))
                val process = ProcessBuilder(command).redirectErrorStream(true).redirectOutput(File(folder, "output")).start()
                eventually("the robot's first 500 rows") { rowsThatReturned(returned) > 500 }
                // Later calls may come after the log was closed, while the program still runs.
                val before = rowsThatReturned(returned)
                process.destroy()
                process.waitFor()
                val bytes = if (isCompressed) {
                    // Throws unless the stream has its end and its checksum.
                    GZIPInputStream(File("$path.gz").inputStream()).use { it.readBytes() }
                } else {
                    path.readBytes()
                }
                val recording = recordingIn(bytes)
                val rows = recording.topics.first().samples.map { it.toLong() }
                rows.size.toLong() shouldBeGreaterThanOrEqual before
                rows shouldBe rows.indices.map { it.toLong() }
                recording.problems.filter { it.line != null }.shouldBeEmpty()
                // The program's loop may run for a moment after its log was closed.
                File(folder, "output").readLines().filterNot { it.endsWith("is ignored, because the log was closed.") }.shouldBeEmpty()
            }
        }
    }
})

private fun rowsThatReturned(file: File): Long = if (file.length() < Long.SIZE_BYTES) 0 else ByteBuffer.wrap(file.readBytes()).getLong()
