package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.analysis.statistics
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File

private val ROOT = File("..")

class LibraryGuideSpec : FunSpec({
    test("the example in docs/library.md runs and finds the stated result") {
        val printed = StringBuilder()

        // The example reads files below the project's root and prints; the functions here replace both.
        @Suppress("ktlint:standard:function-naming")
        fun File(path: String) = ROOT.resolve(path)

        fun println(text: String) {
            printed.appendLine(text)
        }

        val parser = BagParser()
        parser.accept(File("samples/qualification-42.bag").readBytes())
        val recording = parser.finish()
        for (problem in recording.problems) println("line ${problem.line}: ${problem.message}")

        val graphs = LogView.of(recording).folders.flatMap { it.graphs }
        val battery = graphs.first { it.name == "System/Battery Voltage" }.series.first().data
        println("lowest: ${battery.statistics().min} V")

        printed.lines().last { it.isNotEmpty() } shouldBe "lowest: 6.73 V"
    }

    test("the example in docs/library.md is the one that runs here") {
        val example = ROOT.resolve("docs/library.md").readText().substringAfter("```kotlin\n").substringBefore("```")
        val here = File("src/test/kotlin/badlog/samples/LibraryGuideSpec.kt").readLines().map { it.trim() }
        for (line in example.lines().filter { it.isNotBlank() }) here.joinToString("\n") shouldContain line.trim()
    }
})
