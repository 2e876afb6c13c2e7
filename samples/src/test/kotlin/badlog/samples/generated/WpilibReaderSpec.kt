package badlog.samples.generated

import badlog.core.python.TestPython
import badlog.core.recording.TopicKind
import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.nio.file.Files

private val PYTHON = TestPython("wpiutil.log", "robotpy-wpiutil")

/** Returns the output of WPILib's reader in robotpy for a log. */
private fun linesOf(bytes: ByteArray): List<List<String>> {
    val file = Files.createTempFile("match", ".wpilog")
    try {
        Files.write(file, bytes)
        val process = PYTHON.running("../libraries/formats/src/jvmTest/python/read_wpilog.py", file.toString())
        val lines = process.inputStream.bufferedReader().readLines().map { it.split('\t') }
        process.waitFor() shouldBe 0
        return lines
    } finally {
        Files.delete(file)
    }
}

@Tags("InProve")
class WpilibReaderSpec : FunSpec({
    for (naming in Naming.entries.filterNot { it.isBag }) {
        test("WPILib's reader finds the same samples in logs of ${naming.id}").config(enabledOrReasonIf = PYTHON.isHere) {
            val match = MatchGenerator(7).faulty(naming, FAULTS.first(), 1.0)
            val lines = linesOf(match.bytes)
            val starts = lines.filter { it[0] == "start" }.associate { it[1] to it[2] }
            val found = lines.filter { it[0] == "data" && it[2] == "double" }.groupBy({ it[1] }, { java.lang.Double.parseDouble(it[4]) })
            val topics = recordingOf(match).topics.filter { it.type == "double" && it.kind == TopicKind.NUMERIC }
            topics.size shouldBeGreaterThan 20
            for (topic in topics) withClue(topic.name) { found.getValue(topic.name) shouldBe topic.samples.toList() }
            val structs = starts.filter { it.value.startsWith("struct:") }.map { it.value.removePrefix("struct:").removeSuffix("[]") }
            for (struct in structs) starts["/.schema/struct:$struct"] shouldBe "structschema"
        }
    }
})
