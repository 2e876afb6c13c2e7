package badlog.page

import badlog.exporter.HtmlExporter
import badlog.exporter.NotesFile
import badlog.protocol.Note
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.Keys
import java.nio.file.Files
import java.nio.file.Path

/** What people wrote in the window, on an exported page. */
internal class NotesSpec : PageSpec({
    fun pageOf(folder: Path, prepare: (log: Path) -> Unit): Path {
        val log = Files.write(folder.resolve("match.bag"), stepBag(graphs = 1))
        prepare(log)
        return folder.resolve("match.html").also { HtmlExporter().export(log, it) }
    }

    browserTest("notes beside a log are listed on its page and lead to their moments") {
        val page = pageOf(tempdir().toPath()) { NotesFile.write(it, listOf(Note(3.0, "hit by 254 </script>"), Note(7.0, "second\nline"))) }
        onPage(page) {
            texts("#notes .note-text") shouldBe listOf("hit by 254 </script>", "second\nline")
            elements("#notes .event-go")[0].click()
            settle()
            texts(".cursor-readout").single() shouldStartWith "3.00"
            3.0 shouldBeIn visibleRange
            graph("Step 1").scrollTo()
            texts(".event-label").first() shouldBe "hit by 254 </script>"
            keepScreenshot("notes")
        }
    }

    browserTest("a search finds notes, and hides the others") {
        val page = pageOf(tempdir().toPath()) { NotesFile.write(it, listOf(Note(3.0, "hit by 254"), Note(7.0, "jammed"))) }
        onPage(page) {
            press("/")
            press("HIT")
            elements(".note-text").filter { it.isDisplayed }.map { it.text } shouldBe listOf("hit by 254")
            texts("#notes header .unit") shouldBe listOf("1 of 2 notes")
            texts(".search-count").single() shouldBe "1 note"
            press(Keys.ESCAPE)
            elements(".note-text").count { it.isDisplayed } shouldBe 2
        }
    }

    browserTest("damaged notes are a problem that the page lists, and nothing else changes") {
        onPage(pageOf(tempdir().toPath()) { Files.writeString(NotesFile.of(it), "{") }) {
            element("#notes").isDisplayed shouldBe false
            text shouldContain "notes in match.bag.notes.json are damaged"
            graphNames shouldBe listOf("Step 1")
        }
    }

    browserTest("a log without notes has no list of them") {
        onPage(TestPages.of(stepBag(graphs = 1))) { element("#notes").isDisplayed shouldBe false }
    }
})
