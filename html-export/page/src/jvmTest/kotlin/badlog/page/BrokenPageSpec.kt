package badlog.page

import badlog.protocol.PageAdditions
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path

/** Pages that were cut in copying, and browsers that cannot show them. Nobody is left with an empty window. */
internal class BrokenPageSpec : PageSpec({
    fun cut(page: Path, bytes: Int): Path {
        val file = Files.createTempFile("badlog-cut", ".html")
        file.toFile().deleteOnExit()
        return Files.write(file, Files.readAllBytes(page).copyOf(bytes))
    }

    browserTest("a browser without DecompressionStream learns which one can show the page") {
        onPage(TestPages.ofSample("practice.bag"), script = "delete window.DecompressionStream", state = "failed") {
            text shouldContain "This browser is too old"
            text shouldContain "Safari 16.4"
        }
    }

    browserTest("a browser whose language is none shows the page, as WebKit in the language C") {
        val script = "Object.defineProperty(navigator, 'language', { get: () => 'C', configurable: true })"
        onPage(TestPages.of(stepBag(graphs = 1)), script = script) { graph("Step 1").isDrawn shouldBe true }
    }

    browserTest("a program that fails before it can show anything says why") {
        val page = TestPages.of(stepBag(graphs = 1))
        OpenPage.open(page, Screen.WIDE, "window.matchMedia = undefined").use {
            it.awaitState("failed")
            it.text shouldContain "Something went wrong"
            it.text shouldContain "matchMedia"
        }
    }

    browserTest("a page cut inside its program says so") {
        OpenPage.open(cut(TestPages.ofSample("practice.bag"), 100_000), Screen.WIDE, null).use {
            it.await("a word about the cut") { "the file is incomplete" in it.text }
        }
    }

    for ((place, bytesOf) in mapOf<String, (Path) -> Long>("inside its log" to { Files.size(it) - 1000 }, "before its end" to { Files.size(it) - 100 })) {
        for (log in listOf((1..3000), (1..600_000)).map { rows -> rows.joinToString("") { "$it,2.5\n" } }) {
            browserTest("a page of ${log.length} bytes cut $place says so") {
                val page = TestPages.of("a,b\n$log")
                onPage(cut(page, bytesOf(page).toInt()), state = "failed") { text shouldContain "This page is not complete" }
            }
        }
    }

    fun changed(page: Path, mark: String, change: (String) -> String): Path {
        val text = Files.readString(page)
        val from = text.indexOf(mark) + mark.length
        val until = text.indexOf("</script>", from)
        val file = Files.createTempFile("badlog-changed", ".html")
        file.toFile().deleteOnExit()
        return Files.writeString(file, text.substring(0, from) + change(text.substring(from, until)) + text.substring(until))
    }

    val damages = mapOf<String, (String) -> String>(
        "a changed letter" to { it.replaceRange(5000, 5004, it.substring(5000, 5004).reversed()) },
        "a letter that is none" to { it.replaceRange(5000, 5001, " ") },
        "a missing half" to { it.take(it.length / 2) },
    )
    for ((damage, change) in damages) {
        browserTest("a page whose program has $damage says so") {
            val page = changed(TestPages.of(stepBag(graphs = 1)), "id=\"packed\">", change)
            onPage(page, state = "failed") { text shouldContain "This page is not complete" }
        }
    }

    browserTest("a page whose findings cannot be read shows the recording, and says so") {
        val bag = stepBag(graphs = 1)
        val page = TestPages.of(bag, additions = PageAdditions(listOf("Twice = Step 1 * 2")))
        OpenPage.open(changed(page, "id=\"packed-additions\">") { it.dropLast(3) }, Screen.WIDE, null).use {
            it.awaitState("ready")
            it.graphNames shouldBe listOf("Step 1")
            it.texts(".problem-text").single() shouldContain "cannot read the findings"
        }
    }

    browserTest("a browser that allows no worker shows the page all the same") {
        val script = "window.Worker = class { constructor() { throw new Error('forbidden') } }"
        onPage(TestPages.ofSample("practice.bag"), script = script) { graph(graphNames.first()).isDrawn shouldBe true }
    }

    browserTest("a browser that keeps nothing shows the page all the same") {
        val script = "Object.defineProperty(window, 'localStorage', {get() { throw new Error('forbidden') }})"
        onPage(TestPages.of(stepBag(graphs = 2)), script = script) {
            click("#theme")
            graph("Step 1").isDrawn shouldBe true
        }
    }

    browserTest("a browser that does not decode base64 by itself shows the same values") {
        onPage(TestPages.of(stepBag(graphs = 1)), script = "delete Uint8Array.fromBase64") {
            graph("Step 1").hover(0.9)
            graph("Step 1").value("Step 1") shouldBe "1"
        }
    }
})
