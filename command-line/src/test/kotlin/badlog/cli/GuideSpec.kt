package badlog.cli

import badlog.cli.computer.Computer
import badlog.cli.fetch.Robots
import badlog.rules.commandWords
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** The width of the terminal that guides show. */
private const val GUIDE_WIDTH = 100

/**
 * Runs the examples of the guides, which build on each other, and compares what they print. A line `…` stands for any lines;
 * besides `badlog`, `head -c SIZE LOG > PART` is understood, which damages a log.
 * With the environment variable `BADLOG_WRITE_GUIDE` those that differ are written anew instead, in full.
 */
@Tags("InCheck")
class GuideSpec : FunSpec({
    val example = Regex("""(?<=```console\n)(.*?)(?=```)""", RegexOption.DOT_MATCHES_ALL)
    val part = Regex("""\$ head -c (\d+) (\S+) > (\S+)""")

    fun run(command: String, robots: Robots): String {
        part.matchEntire(command)?.destructured?.let { (size, log, target) ->
            Path.of(target).writeBytes(Path.of(log).readBytes().copyOf(size.toInt()))
            return "$command\n"
        }
        val ended = badlogOn(Computer(), *commandWords(command.removePrefix("$ badlog ")).toTypedArray(), robots = robots, width = GUIDE_WIDTH)
        return "$command\n${ended.out}${ended.err}"
    }

    fun matches(wanted: String, printed: String): Boolean = Regex(wanted.split("\n…\n").joinToString("\n(?:.*\n)*?") { Regex.escape(it) }).matches(printed)

    fun check(name: String, robots: Robots = Robots.ofSystem()) {
        val guide = ROOT / "docs" / name
        val text = guide.readText()
        val examples = example.findAll(text).map { it.value }.toList()
        examples.shouldNotBeEmpty()
        val printed = examples.map { block -> block.lines().filter { it.startsWith("$ ") }.joinToString("") { run(it, robots) } }
        if (System.getenv("BADLOG_WRITE_GUIDE") != null) {
            val next = printed.iterator()
            guide.writeText(example.replace(text) { found -> next.next().let { if (matches(found.value, it)) found.value else it } })
        } else {
            for ((wanted, was) in examples.zip(printed)) if (!matches(wanted, was)) was shouldBe wanted
        }
    }

    for (name in listOf("command-line.md", "wpilog.md", "cookbook.md", "faq.md", "advantagescope.md", "troubleshooting.md")) {
        test("$name shows the program's output") { check(name) }
    }

    test("fetch.md shows the program's output, beside a robot with two logs") {
        besideRobot { robot, robots ->
            robot.log("match.bag", (SAMPLES / "qualification-42.bag").readBytes(), secondsAgo = 3600)
            robot.log("elevator-bench.csv", (SAMPLES / "elevator-bench.csv").readBytes(), secondsAgo = 20 * 24 * 3600)
            check("fetch.md", robots)
        }
    }
})
