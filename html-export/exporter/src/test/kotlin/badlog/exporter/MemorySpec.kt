package badlog.exporter

import badlog.files.inFolder
import badlog.rules.RulesFile
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File
import java.util.zip.GZIPOutputStream
import kotlin.io.path.div
import kotlin.io.path.outputStream
import kotlin.io.path.writeText

@Tags("InCheck")
class MemorySpec : FunSpec({
    val row = "0.02,1.2345,2.3456,-3.4567\n".encodeToByteArray()

    fun exportIn(heap: String, gzips: Boolean, rules: String = ""): Int = inFolder { folder ->
        if (rules.isNotEmpty()) (folder / RulesFile.NAME).writeText(rules)
        val input = folder / "large.bag"
        input.outputStream().buffered().let { if (gzips) GZIPOutputStream(it) else it }.use { out ->
            out.write("Time,A,B,C\n".encodeToByteArray())
            repeat(MEGABYTES * 1_000_000 / row.size) { out.write(row) }
        }
        val java = File(System.getProperty("java.home"), "bin/java").path
        ProcessBuilder(java, heap, "-cp", System.getProperty("java.class.path"), "badlog.exporter.program.MainKt", "$input")
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start()
            .waitFor()
    }

    test("memory does not grow with the file") {
        exportIn("-Xmx24m", gzips = false) shouldBe 0
    }

    test("memory does not grow with the rules, which the page runs and the exporter does not") {
        val rules = List(50) { number ->
            "[[rule]]\nname = \"$number\"\nseverity = \"note\"\neach = [\"*\"]\nwhen = \"topic > $number for 1 s\"\ntext = \"t\"\n"
        }
        exportIn("-Xmx24m", gzips = false, rules.joinToString("")) shouldBe 0
    }

    test("memory does not grow with the inflated size of a compressed file") {
        exportIn("-Xmx24m", gzips = true) shouldBe 0
    }
})

private const val MEGABYTES = 60
