package badlog.page

import badlog.exporter.HtmlExporter
import badlog.exporter.NotesFile
import badlog.viewer.choices.note.Note
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
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(3.0, "hit by 254 </script>"), Note(7.0, "second\nline")), read = emptyList()) }
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

    browserTest("a key marks the moment of the cursor, without a dialog, and says where") {
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(3.0, "hit by 254")), read = emptyList()) }
        onPage(page) {
            elements("#notes .event-go")[0].click()
            press("M")
            press("M")
            texts("#notes .note-text") shouldBe listOf("hit by 254", "Mark 1", "Mark 2")
            texts(".notice p").single() shouldStartWith "Marked at 3.00"
            element("#note-dialog").isDisplayed shouldBe false
        }
    }

    browserTest("a search finds notes, and hides the others") {
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(3.0, "hit by 254"), Note(7.0, "jammed")), read = emptyList()) }
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
        onPage(pageOf(tempdir().toPath()) { Files.writeString(NotesFile.beginningOf(it), "{") }) {
            element("#notes").isDisplayed shouldBe false
            text shouldContain "notes in match.bag.notes.json are damaged"
            graphNames shouldBe listOf("Step 1")
        }
    }

    browserTest("a log without notes has no list of them") {
        onPage(TestPages.of(stepBag(graphs = 1))) { element("#notes").isDisplayed shouldBe false }
    }

    /** Writes [text] as a note at the cursor. */
    fun OpenPage.write(text: String) {
        press("m")
        press(text, Keys.ENTER)
        settle()
    }

    browserTest("a note is written at the cursor, changed and removed, and the page opens with it again") {
        onPage(TestPages.of(stepBag(graphs = 1))) {
            graph("Step 1").click(0.3)
            write("hit by 254")
            element("#note-dialog").isDisplayed shouldBe false
            texts("#notes .note-text") shouldBe listOf("hit by 254")
            texts("#notes .event-go") shouldBe listOf("3.000")
            keepScreenshot("note-written")
            elements("#notes .note-tools button")[0].click()
            texts("#note-dialog h2").single() shouldStartWith "Note at 3.0"
            press(" again", Keys.ENTER)
            reload()
            texts("#notes .note-text") shouldBe listOf("hit by 254 again")
            press("m")
            press("never mind", Keys.ESCAPE)
            texts("#notes .note-text") shouldBe listOf("hit by 254 again")
            elements("#notes .note-tools button")[1].click()
            element("#notes").isDisplayed shouldBe false
            reload()
            element("#notes").isDisplayed shouldBe false
        }
    }

    browserTest("what two tabs write and remove is in the notes of both, whichever of them writes last") {
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(1.0, "first"), Note(2.0, "second")), read = emptyList()) }
        onPage(page) {
            // As another tab with the same page does.
            val other = "{\"version\":1,\"notes\":[{\"x\":2,\"text\":\"second\"},{\"x\":9,\"text\":\"of the other tab\"}]}"
            val given = "{\"version\":1,\"notes\":[{\"x\":1,\"text\":\"first\"},{\"x\":2,\"text\":\"second\"}]}"
            script(
                "const key = 'badlog:notes:match.bag:' + JSON.parse(document.getElementById('about').textContent).inflatedBytes;" +
                    "localStorage.setItem(key, arguments[0] + '\\0' + arguments[1])",
                given,
                other,
            )
            graph("Step 1").click(0.5)
            write("of this tab")
            texts("#notes .note-text") shouldBe listOf("second", "of this tab", "of the other tab")
            // The other tab changes a note of which there is then still one, and this tab another.
            script(
                "const key = Object.keys(localStorage).find(k => k.startsWith('badlog:notes:'));" +
                    "localStorage[key] = localStorage[key].replace('of the other tab', 'changed there')",
            )
            elements("#notes .note-tools button")[0].click()
            press(" again", Keys.ENTER)
            settle()
            texts("#notes .note-text") shouldBe listOf("second again", "of this tab", "changed there")
            reload()
            texts("#notes .note-text") shouldBe listOf("second again", "of this tab", "changed there")
        }
    }

    browserTest("a copy of the page has the notes, the board and the log's very bytes, and needs nothing of the browser that made it") {
        val copy = tempdir().toPath().resolve("copy.html")
        onPage(TestPages.of(stepBag(graphs = 2))) {
            graph("Step 2").click(0.3)
            press("p")
            write("hit </script> by 254")
            Files.write(copy, exported("A copy of this page, with your notes and board", "test.html"))
        }
        onPage(copy, script = "localStorage.clear()") {
            texts("#notes .note-text") shouldBe listOf("hit </script> by 254")
            texts(".board .graph-title") shouldBe listOf("Step 2")
            saved("test.bag") { click("#download") } shouldBe stepBag(graphs = 2)
            // A copy of a copy is the same page once more.
            val again = exported("A copy of this page, with your notes and board", "test.html")
            again shouldBe Files.readAllBytes(copy)
        }
    }
})
