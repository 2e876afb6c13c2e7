package badlog.cli.console

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.CUT_BAG
import badlog.cli.badlog
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import kotlin.io.path.div

class TerminalColorsSpec : FunSpec({
    fun colors(isTerminal: Boolean = true, system: String = "Linux", vararg variables: Pair<String, String>) = TerminalColors.of(isTerminal, system, variables.toMap()::get)

    fun isColored(colors: TerminalColors) = '\u001b' in colors.result("  error    cut")

    test("a terminal with colors gets them unless NO_COLOR is set") {
        isColored(colors()) shouldBe true
        isColored(colors(isTerminal = false)) shouldBe false
        isColored(colors(true, "Linux", "NO_COLOR" to "1")) shouldBe false
        isColored(colors(true, "Linux", "NO_COLOR" to "")) shouldBe true
        isColored(colors(true, "Linux", "TERM" to "dumb")) shouldBe false
        isColored(colors(true, "Windows 10")) shouldBe false
        isColored(colors(true, "Windows 10", "WT_SESSION" to "1")) shouldBe true
    }

    test("severities and titles are colored at their place, other words are not") {
        val colors = colors()
        colors.result("  error    The file is cut.") shouldBe "  \u001b[31merror\u001b[0m    The file is cut."
        colors.result("   92.4092 s  warning  PDP/Current 0 was above 50 A.") shouldBe "   92.4092 s  \u001b[33mwarning\u001b[0m  PDP/Current 0 was above 50 A."
        colors.result("              next     See which channels drew most.") shouldContain "\u001b[2mnext\u001b[0m"
        colors.result("TOPIC  UNIT  KIND") shouldBe "\u001b[1mTOPIC  UNIT  KIND\u001b[0m"
        for (line in listOf("", "1 error, 2 warnings", "Match Number      42", "  An error    in a text", "error")) colors.result(line) shouldBe line
    }

    test("the output has the same words with and without colors, and JSON has no colors") {
        inFolder { folder ->
            val log = folder.with("a.bag", CUT_BAG)
            fun printed(vararg arguments: String): String {
                val out = ByteArrayOutputStream()
                val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(out, true, "UTF-8"), true, outColors = colors(), errColors = colors())
                Badlog(console).run(listOf(*arguments))
                return out.toString(Charsets.UTF_8)
            }
            printed("info", "$log") shouldContain "\u001b[31merror\u001b[0m"
            printed("info", "$log").replace(Regex("\u001b\\[\\d+m"), "") shouldBe badlog("info", log).out
            printed("info", "$log", "--json") shouldNotContain "\u001b"
            printed("info", "${folder / "none.bag"}") shouldContain "\u001b[31mThere is no file"
            printed("info", "${folder.with("b\u001b[31m.bag", BAG)}").substringBefore('\n') shouldNotContain "\u001b[31m"
        }
    }
})
