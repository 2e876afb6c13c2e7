package badlog.expression

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.LogView
import badlog.core.analysis.ModeTopics
import badlog.expression.signals.Signals
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.io.File

private val ROOT = generateSequence(File("").absoluteFile) { it.parentFile }.first { File(it, "docs/expressions.md").exists() }

/** Returns the output of [expression], with each line indented. */
private fun printed(expression: String, signals: Signals): String = when (val result = Question.parse(expression, signals.vocabulary)) {
    is Question -> result.answer(signals).run { listOf(toString()) + occurrences.map(::printed) }.joinToString("\n")
    is ExpressionError -> result.pointed()
}.lines().joinToString("\n") { "    $it" }

private fun printed(occurrence: Occurrence) = "at ${readable(occurrence.span.from)} s, before: " + occurrence.before.joinToString { (name, text) -> "$name: $text" }

/** With the environment variable `BADLOG_WRITE_GUIDE` the guide is rewritten. */
class GuideSpec : FunSpec({
    test("each example in docs/expressions.md gives the output below it") {
        var signals: Signals = readRecording(File(ROOT, "samples/qualification-42.bag").toPath(), LOG_FORMATS).let { recording ->
            val modes = ModeTopics(FlagTopic("System/Enabled", FlagReading.Truth), FlagTopic("System/Autonomous", FlagReading.Truth))
            LogViewSignals(LogView.of(recording).identified(null, modes))
        }
        val guide = File(ROOT, "docs/expressions.md").readText()
        val blocks = Regex("```(expression|question|virtual-topic)\n(.*?)```", RegexOption.DOT_MATCHES_ALL)
        val asItIs = blocks.replace(guide) { block ->
            val (kind, content) = block.destructured
            val written = content.lines().filter { it.isNotEmpty() && !it.startsWith("    ") }
            val lines = written.map { line ->
                if (kind != "virtual-topic") return@map line + "\n" + printed(line, signals)
                signals = signals.with(VirtualTopic.parse(line, signals.vocabulary) as VirtualTopic)
                line
            }
            "```$kind\n${lines.joinToString("\n")}\n```"
        }
        if (System.getenv("BADLOG_WRITE_GUIDE") != null) File(ROOT, "docs/expressions.md").writeText(asItIs) else guide shouldBe asItIs
    }
})
