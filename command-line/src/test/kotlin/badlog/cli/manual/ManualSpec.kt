package badlog.cli.manual

import badlog.cli.badlog
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.maps.shouldContainKey
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.io.File
import java.io.IOException

private val OPTION = Regex("^  (?:-\\w, )?(--[a-z-]+)", RegexOption.MULTILINE)

@Tags("InCheck")
class ManualSpec : FunSpec({
    val pages = manual()

    test("each command has a manual page, and badlog's lists them") {
        for (name in badlogCommand().registeredSubcommandNames()) {
            pages shouldContainKey "man/man1/badlog-$name.1"
            pages.getValue("man/man1/badlog.1") shouldContain "\\fBbadlog $name\\fR"
        }
    }

    test("a page has each option of the help, and the exit codes") {
        for (name in listOf("cut", "convert", "fetch", "report")) {
            val options = OPTION.findAll(badlog("help", name).out).map { it.groupValues[1] }.toList()
            options.contains("--help") shouldBe true
            val page = pages.getValue("man/man1/badlog-$name.1")
            options.filterNot { "\\fB${it.replace("-", "\\-")}\\fR" in page }.shouldBeEmpty()
            page shouldContain ".SH EXAMPLES\nbadlog $name "
            page shouldContain ".SH EXIT STATUS\n0 success"
        }
    }

    test("a page is plain ASCII, whatever quotes and names the help has") {
        for ((path, page) in pages) {
            page.filter { it.code > 126 } shouldBe ""
            page.lines().filter { it.startsWith("'") || (it.startsWith(".") && it.substringBefore(' ') !in listOf(".TH", ".SH", ".TP", ".PP")) }.shouldBeEmpty()
            page shouldNotContain "\u001b"
            path.endsWith(".1") shouldBe true
        }
    }

    test("groff formats each page without a warning").config(
        enabledOrReasonIf = { if (warningsOf(".TH A 1\n") != null) Enabled.enabled else Enabled.disabled("groff is not installed") },
    ) {
        for (page in pages.values) warningsOf(page) shouldBe ""
    }

    test("completions know the commands and options of three shells") {
        val scripts = completions()
        scripts.keys shouldBe setOf("completions/badlog.bash", "completions/badlog.zsh", "completions/badlog.fish")
        for (script in scripts.values) for (word in listOf("recover", "changes-only")) script shouldContain word
    }
})

/** The messages of groff about [page]; null without groff. */
private fun warningsOf(page: String): String? = try {
    val file = File.createTempFile("page", ".1").apply { writeText(page) }
    val process = ProcessBuilder("groff", "-man", "-Tutf8", "-ww", "$file").redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
    process.errorStream.readAllBytes().decodeToString().also {
        process.waitFor()
        file.delete()
    }
} catch (_: IOException) {
    null
}
