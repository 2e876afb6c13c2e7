package badlog.cli

import badlog.report.hook.commandWords
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Runs the examples of the guide, which build on each other, and compares what they print. A line `…` stands for any lines.
 * With the environment variable `BADLOG_WRITE_GUIDE` those that differ are written anew instead, in full.
 */
class GuideSpec : FunSpec({
    val guide = ROOT / "docs/command-line.md"
    val example = Regex("""(?<=```console\n)(.*?)(?=```)""", RegexOption.DOT_MATCHES_ALL)

    fun run(command: String): String {
        val ended = badlog(*commandWords(command.removePrefix("$ badlog ")).toTypedArray())
        return "$command\n${ended.out}${ended.err}"
    }

    fun matches(wanted: String, printed: String): Boolean =
        Regex(wanted.split("\n…\n").joinToString("\n(?:.*\n)*?") { Regex.escape(it) }).matches(printed)

    test("what the guide shows is what the program prints") {
        val text = guide.readText()
        val examples = example.findAll(text).map { it.value }.toList()
        examples.shouldNotBeEmpty()
        val printed = examples.map { block -> block.lines().filter { it.startsWith("$ ") }.joinToString("", transform = ::run) }
        if (System.getenv("BADLOG_WRITE_GUIDE") != null) {
            val next = printed.iterator()
            guide.writeText(example.replace(text) { found -> next.next().let { if (matches(found.value, it)) found.value else it } })
        } else {
            for ((wanted, was) in examples.zip(printed)) if (!matches(wanted, was)) was shouldBe wanted
        }
    }
})
