package badlog.page

import badlog.exporter.HtmlExporter
import badlog.files.gzip
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path

/** Pages that were cut in copying, and browsers that cannot show them. No reader gets an empty window. */
@Tags("InCheck")
internal class BrokenPageSpec : PageSpec({
    fun cut(page: Path, bytes: Int): Path {
        val file = Files.createTempFile("badlog-cut", ".html")
        file.toFile().deleteOnExit()
        return Files.write(file, Files.readAllBytes(page).copyOf(bytes))
    }

    fun changed(page: Path, mark: String, change: (String) -> String): Path {
        val text = Files.readString(page)
        val from = text.indexOf(mark) + mark.length
        val until = text.indexOf("</script>", from)
        val file = Files.createTempFile("badlog-changed", ".html")
        file.toFile().deleteOnExit()
        return Files.writeString(file, text.substring(0, from) + change(text.substring(from, until)) + text.substring(until))
    }

    // Any character of the log's own text, which begins after its start tag.
    fun changedLog(page: Path, place: (text: String) -> Int) = changed(page, "id=\"recording\"") { element ->
        val start = element.indexOf('>') + 1
        val at = start + place(element.substring(start))
        element.replaceRange(at, at + 1, if (element[at] == 'A') "B" else "A")
    }

    val rows = (1..3000).joinToString("", "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"b\"}]}\nTime,b\n") { "$it,${it * 7919 % 1000}\n" }
    val large = "a,b\n" + (1..600_000).joinToString("") { "$it,${it * 7919 % 1000}\n" }

    browserTest("one changed letter of the log is reported, and the readable part is shown without rules") {
        for ((log, name) in listOf(gzip(rows.encodeToByteArray()) to "test.bag.gz", large.encodeToByteArray() to "read-by-workers.csv")) {
            step(name) {
                onPage(changedLog(TestPages.of(log, name, PageAdditions(rules = RuleSet.BUILT_IN))) { it.length * 2 / 3 }, state = "failed") {
                    text shouldContain "This page is not complete"
                    text shouldContain "damaged in copying; export it again."
                    elements(".graph").shouldBeEmpty()
                    click("#show-damaged")
                    awaitState("ready")
                    graphNames.isEmpty() shouldBe false
                    texts(".problem-text").first { "Damaged" in it } shouldContain "No rules ran."
                    texts(".finding").shouldBeEmpty()
                    elements("#download").single().getDomAttribute("title") shouldContain "as much as this damaged page still has"
                }
            }
        }
    }

    browserTest("a page that was cut or changed in copying reports that") {
        step("a page cut inside its program reports that") {
            OpenPage.open(cut(TestPages.of(rows), 100_000), Screen.WIDE, null).use {
                it.await("a word about the cut") { "the file is incomplete" in it.text }
            }
        }
        step("a page cut inside its log, or before its end, reports that, also where several workers read it") {
            for ((log, missing) in listOf(rows to 1000, large to 100)) {
                val page = TestPages.of(log)
                onPage(cut(page, Files.size(page).toInt() - missing), state = "failed") { text shouldContain "This page is not complete" }
            }
        }
        step("a page with a damaged program reports that") {
            val page = changed(TestPages.of(rows), "id=\"packed\">") { it.replaceRange(5000, 5004, it.substring(5000, 5004).reversed()) }
            onPage(page, state = "failed") { text shouldContain "This page is not complete" }
        }
        step("a character of the log that is not base64 is reported by the browser's own decoder") {
            val page = changed(TestPages.of(rows), "id=\"recording\"") { it.replaceRange(500, 501, "!") }
            onPage(page, state = "failed") { text shouldContain "damaged in copying" }
        }
        step("one changed letter is also reported by a browser without workers and base64") {
            val script = "window.Worker = class { constructor() { throw new Error('forbidden') } }; delete Uint8Array.fromBase64"
            onPage(changedLog(TestPages.of(rows)) { it.length / 2 }, script = script, state = "failed") { text shouldContain "damaged in copying" }
        }
        step("a page whose log has lost its last rows is reported, even if its facts have the lower number") {
            val page = changed(TestPages.of(rows), "\"inflatedBytes\":") { it.replaceRange(0, 1, "1") }
            onPage(page, state = "failed") { text shouldContain "damaged in copying" }
        }
    }

    browserTest("damaged attachments and findings are reported, and the recording is shown") {
        step("an attached file is saved only if it is undamaged") {
            val folder = Files.createTempDirectory("badlog-attached")
            val attached = Files.writeString(folder.resolve("notes.txt"), "left motor was hot\n".repeat(50))
            val log = Files.writeString(folder.resolve("test.bag"), rows)
            val page = folder.resolve("page.html").also { HtmlExporter(listOf(attached)).export(log, it) }
            onPage(page) { saved("notes.txt") { click("#attachment-0") } shouldBe Files.readAllBytes(attached) }
            val damaged = changed(page, "class=\"attachment\"") { element ->
                val at = element.indexOf('>') + (element.length - element.indexOf('>')) / 2
                element.replaceRange(at, at + 1, if (element[at] == 'A') "B" else "A")
            }
            onPage(damaged) {
                click("#attachment-0")
                await("a word about the damage") { "Could not be saved" in element("#attachment-0").text }
            }
            folder.toFile().deleteRecursively()
        }
        step("a page whose findings cannot be read shows the recording, and reports them") {
            val bag = stepBag(graphs = 1)
            val page = TestPages.of(bag, additions = PageAdditions(listOf("Twice = Step 1 * 2")))
            OpenPage.open(changed(page, "id=\"packed-additions\">") { it.dropLast(3) }, Screen.WIDE, null).use {
                it.awaitState("ready")
                it.graphNames shouldBe listOf("Step 1")
                it.texts(".problem-text").single() shouldContain "cannot read the findings"
            }
        }
    }

    browserTest("a browser that lacks something shows the page, or gives the reason why it cannot") {
        step("a browser without DecompressionStream gets the names of browsers that can show the page") {
            onPage(TestPages.of(rows), script = "delete window.DecompressionStream", state = "failed") {
                text shouldContain "This browser is too old"
                text shouldContain "Safari 16.4"
            }
        }
        step("a program that fails before it can show anything gives the reason") {
            val page = TestPages.of(stepBag(graphs = 1))
            OpenPage.open(page, Screen.WIDE, "window.matchMedia = undefined").use {
                it.awaitState("failed")
                it.text shouldContain "Something went wrong"
                it.text shouldContain "matchMedia"
            }
        }
        step("a browser without workers shows the page") {
            val script = "window.Worker = class { constructor() { throw new Error('forbidden') } }"
            onPage(TestPages.of(rows), script = script) { graph(graphNames.first()).isDrawn shouldBe true }
        }
        step("a browser without storage and base64, with the language “C” as WebKit has it, shows the page") {
            val script = "Object.defineProperty(window, 'localStorage', {get() { throw new Error('forbidden') }}); delete Uint8Array.fromBase64;" +
                "Object.defineProperty(navigator, 'language', { get: () => 'C', configurable: true })"
            onPage(TestPages.of(stepBag(graphs = 2)), script = script) {
                click("#theme")
                graph("Step 1").isDrawn shouldBe true
                graph("Step 1").hover(0.9)
                graph("Step 1").value("Step 1") shouldBe "1"
            }
        }
    }
})
