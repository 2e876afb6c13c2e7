package badlog.cli

import badlog.cli.command.ExitCode
import badlog.core.python.TestPython
import badlog.files.LogFile
import badlog.files.inFolder
import badlog.report.Find
import badlog.report.Reply
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.math.abs

private val PYTHON = TestPython("pandas", "pandas")

/** The questions of the cookbook that pandas answers, too. */
@Tags("InCheck")
class CookbookSpec : FunSpec({
    fun numberOf(question: String, log: Path): Double = (Find(question).over(listOf(LogFile.of(log))).single().reply as Reply.Answered).quantities.first().value

    test("badlog and pandas answer the cookbook's questions alike, for rows and for a log of changes").config(enabledOrReasonIf = PYTHON.isHere) {
        val bag = SAMPLES / "qualification-42.bag"
        val script = ROOT / "command-line/src/test/python/cookbook.py"
        val python = PYTHON.running(script.toString(), bag.toString())
        val wanted = Json.parseToJsonElement(python.inputStream.readAllBytes().decodeToString()).jsonObject
        python.waitFor() shouldBe 0
        wanted.size shouldBeGreaterThanOrEqual 20
        inFolder { folder ->
            val changes = folder / "changes.wpilog"
            badlog("convert", bag, "--to", "wpilog", "--changes-only", "--out", changes).code shouldBe ExitCode.WHOLE
            for ((question, value) in wanted) {
                val number = value.jsonPrimitive.double
                withClue("$question of rows") { numberOf(question, bag) shouldBe (number plusOrMinus 1e-9 + 1e-7 * abs(number)) }
                // Samples are counted as logged; times of a WPILOG are whole microseconds.
                if ("sample_" in question) continue
                withClue("$question of changes") { numberOf(question, changes) shouldBe (number plusOrMinus 2e-5 + 2e-4 * abs(number)) }
            }
        }
    }

    test("the questions for pandas are in the cookbook") {
        val guide = (ROOT / "docs/cookbook.md").toFile().readText()
        val script = (ROOT / "command-line/src/test/python/cookbook.py").toFile().readText()
        val asked = Regex("^    \"(.*)\": ", RegexOption.MULTILINE).findAll(script).map { it.groupValues[1] }.filter { "$it" in guide }
        asked.count() shouldBeGreaterThanOrEqual 20
    }
})
