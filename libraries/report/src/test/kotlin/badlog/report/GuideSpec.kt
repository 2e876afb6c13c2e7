package badlog.report

import badlog.rules.RulesException
import badlog.rules.RulesFile
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

private val BLOCK = Regex("```([a-z-]+) ?(.*)\n((?:.*\n)*?)```")

class GuideSpec : FunSpec({
    test("each example in docs/rules.md is what the program prints; BADLOG_WRITE_GUIDE rewrites them") {
        val file = File(ROOT, "docs/rules.md")
        val guide = file.readText()
        val written = BLOCK.findAll(guide).associate { it.groupValues[1] to it.groupValues[3] }
        val asItIs = BLOCK.replace(guide) { block ->
            val (kind, argument, content) = block.destructured
            val shown = when (kind) {
                "find" -> findText(Find(argument).over(SAMPLES))
                "report" -> reportText(Report().over(SAMPLES))
                "report-of-these-rules" -> reportText(Report(RulesFile.parse(written.getValue("rules")).rules).over(SAMPLES))
                "mistake" -> shouldThrow<RulesException> { RulesFile.parse(written.getValue("mistaken-rules")) }.message
                else -> content
            }
            "```$kind${if (argument.isEmpty()) "" else " $argument"}\n${shown.trimEnd('\n')}\n```"
        }
        if (System.getenv("BADLOG_WRITE_GUIDE") != null) file.writeText(asItIs) else guide shouldBe asItIs
    }
})
