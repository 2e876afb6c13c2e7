package badlog.expression

import badlog.analysis.LogView
import badlog.expression.signals.Signals
import badlog.file.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

private val ROOT = generateSequence(File("").absoluteFile) { it.parentFile }.first { File(it, "docs/expressions.md").exists() }

/** What [expression] prints, each line indented. */
private fun printed(expression: String, signals: Signals): String = when (val result = Expression.parse(expression, signals.vocabulary)) {
    is Expression -> result.answer(signals).toString()
    is ExpressionError -> result.pointed()
}.lines().joinToString("\n") { "    $it" }

class GuideSpec : FunSpec({
    test("each example in docs/expressions.md gives what stands below it") {
        var signals: Signals = LogViewSignals(LogView.of(readRecording(File(ROOT, "samples/qualification-42.bag").toPath(), LOG_FORMATS)))
        val guide = File(ROOT, "docs/expressions.md").readText()
        val blocks = Regex("```(expression|virtual-topic)\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
        val asItIs = blocks.replace(guide) { block ->
            val (kind, content) = block.destructured
            val written = content.lines().filter { it.isNotEmpty() && !it.startsWith("    ") }
            val lines = written.map { line ->
                if (kind == "expression") return@map line + "\n" + printed(line, signals)
                signals = signals.with(VirtualTopic.parse(line, signals.vocabulary) as VirtualTopic)
                line
            }
            "```$kind\n${lines.joinToString("\n")}\n```"
        }
        guide shouldBe asItIs
    }
})
