package badlog.architecture

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import java.io.File

/** Tests that all tests wait for conditions and have the tag of a round. */
class TestRoundsSpec : FunSpec({
    val tests = sourcesUnder(ROOT).filter { it.isTest }.map { it.path }.filterNot { it.endsWith("TestRoundsSpec.kt") }

    test("no test sleeps or measures time, except for the listed ones") {
        val timed = tests.filter { TIME.containsMatchIn(File(ROOT, it).readText()) && "/measure/" !in it }.map { it.substringAfterLast('/') }
        // Remove a file from the list when its test no longer needs time.
        timed.sorted() shouldContainExactly (MAY_USE_TIME + STILL_USE_TIME).sorted()
    }

    test("a tag is the name of a round, so that each spec is in a round") {
        tests.flatMap { path -> TAG.findAll(File(ROOT, path).readText()).map { "$path: ${it.groupValues[1]}" } }
            .filterNot { it.endsWith(": \"InCheck\"") || it.endsWith(": \"InProve\"") }.shouldBeEmpty()
    }
})

private val ROOT = File("../..").canonicalFile
private val TIME = Regex("""Thread\.sleep|\bdelay\(|nanoTime|currentTimeMillis|measureTime|elapsedNow|markNow""")
private val TAG = Regex("""@Tags\(([^)]*)\)""")

/** The function that waits for all tests, and a real double click. */
private val MAY_USE_TIME = listOf("Eventually.kt", "RealWindow.kt")

private val STILL_USE_TIME = listOf(
    "KilledWorkerSpec.kt",
    "LocalCluster.kt",
    "VendordepProof.kt",
    "ViewerProof.kt",
    "WindowOnScreen.kt",
)
