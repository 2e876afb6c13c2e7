package badlog.formats.conformance

import badlog.core.recording.Recording
import badlog.formats.LOG_FORMATS
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

/** The logs that readers in all languages must read alike, see conformance/README.md. Gradle runs the tests of a module in the module's folder. */
private val LOGS: List<File> =
    File("conformance").listFiles { file -> file.extension != "json" && file.extension != "md" }.orEmpty().sorted()

/** The variable of the environment with which the expectations are written anew. */
private const val WRITE = "BADLOG_WRITE_CONFORMANCE"

private fun read(file: File): Recording {
    val bytes = file.readBytes()
    val parser = LOG_FORMATS.first { it.matches(bytes, minOf(it.signatureSize, bytes.size)) }.parser(keepSamples = true)
    parser.accept(bytes)
    return parser.finish()
}

class LogCorpusSpec : FunSpec({
    test("each log of the corpus is read as its JSON says") {
        LOGS.size shouldBeGreaterThan 20
        for (log in LOGS) {
            val json = logJson(read(log))
            val expected = File("${log.path}.json")
            if (System.getenv(WRITE) != null) expected.writeText(json)
            // Not compared with a matcher, which would print thousands of lines.
            withClue(log.name) { (expected.readText() == json) shouldBe true }
        }
    }

    test("each expectation has its log") {
        val expectations = File("conformance").list().orEmpty().filter { it.endsWith(".json") }
        expectations.sorted() shouldBe LOGS.map { "${it.name}.json" }.sorted()
    }
})
