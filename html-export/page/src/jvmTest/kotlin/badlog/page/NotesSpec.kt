package badlog.page

import badlog.exporter.HtmlExporter
import badlog.exporter.NotesFile
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.toJson
import io.kotest.core.annotation.Tags
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import java.nio.file.Files
import java.nio.file.Path

/** Notes written in the window, on an exported page. */
@Tags("InCheck")
internal class NotesSpec : PageSpec({
    browserTest("notes beside a log are listed, and marked by a key; those of an older badlog stay") {
        val given = listOf(Note(3.0, "hit by 254 </script>"), Note(7.0, "second\nline"))
        val log = Files.write(tempdir().toPath().resolve("match.bag"), stepBag(graphs = 1))
        NotesFile.update(log, given, read = emptyList())
        val page = log.resolveSibling("match.html").also { HtmlExporter().export(log, it) }
        onPage(page) {
            step("notes beside a log are listed with links to their moments; a key marks the cursor's moment without a dialog, and reports it") {
                texts("#notes .finding-text") shouldBe listOf("hit by 254 </script>", "second\nline")
                elements("#notes .event-go")[0].click()
                settle()
                texts(".cursor-readout").single() shouldStartWith "3.00"
                3.0 shouldBeIn visibleRange
                graph("Step 1").scrollTo()
                texts(".event-label").first() shouldBe "hit by 254 </script>"
                keepScreenshot("notes")
                press("M")
                press("M")
                texts("#notes .finding-text") shouldBe listOf("hit by 254 </script>", "Mark 1", "Mark 2", "second\nline")
                texts(".notice p").single() shouldStartWith "Marked at 3.00"
                element("#note-dialog").isDisplayed shouldBe false
            }
            startOver()
            step("notes stored by pages of an older badlog are still there, and can be removed") {
                val (before, after) = listOf(given, listOf(Note(3.0, "changed"), Note(9.0, "added"))).map { it.toJson() }
                script(
                    "const key = 'badlog:notes:match.bag:' + JSON.parse(document.getElementById('about').textContent).inflatedBytes;" +
                        "localStorage.setItem(key, arguments[0])",
                    before + "\u0000" + after,
                )
                reload()
                texts("#notes .finding-text") shouldBe listOf("changed", "added")
                elements("#notes .note-row .pin").last().click()
                reload()
                texts("#notes .finding-text") shouldBe listOf("changed")
            }
        }
    }

    /** Writes [text] as a note at the cursor. */
    fun OpenPage.write(text: String) {
        press("m")
        press(text, Keys.ENTER)
        settle()
    }

    browserTest("notes are written, changed and removed, and a page and its copy in one browser show each once") {
        val page = TestPages.of(stepBag(graphs = 1))
        val copy = tempdir().toPath().resolve("copy.html")

        fun OpenPage.go(to: Path, vararg notes: String) {
            driver.get(to.toUri().toString())
            awaitState("ready")
            texts("#notes .finding-text") shouldBe notes.toList()
        }

        fun OpenPage.rewrite(index: Int, end: String) {
            elements("#notes .note-row")[index].findElements(By.cssSelector(".pin"))[0].click()
            press(end, Keys.ENTER)
            settle()
        }

        fun OpenPage.remove(index: Int) = elements("#notes .note-row")[index].findElements(By.cssSelector(".pin"))[1].click()
        onPage(page) {
            step("a note is written at the cursor, changed and removed, and is still there when the page is opened again") {
                element("#notes").isDisplayed shouldBe false
                graph("Step 1").click(0.3)
                write("hit by 254")
                element("#note-dialog").isDisplayed shouldBe false
                texts("#notes .finding-text") shouldBe listOf("hit by 254")
                texts("#notes .event-go") shouldBe listOf("3.000")
                keepScreenshot("note-written")
                elements("#notes .note-row .pin")[0].click()
                texts("#note-dialog h2").single() shouldStartWith "Note at 3.0"
                press(" again", Keys.ENTER)
                reload()
                texts("#notes .finding-text") shouldBe listOf("hit by 254 again")
                press("m")
                press("never mind", Keys.ESCAPE)
                texts("#notes .finding-text") shouldBe listOf("hit by 254 again")
                elements("#notes .note-row .pin")[1].click()
                element("#notes").isDisplayed shouldBe false
                reload()
                element("#notes").isDisplayed shouldBe false
            }
            startOver()
            step("a page and its copy in one browser show each note once, with its last change, and no removed note") {
                for ((place, text) in listOf(0.2 to "first", 0.4 to "second", 0.6 to "third")) {
                    graph("Step 1").click(place)
                    write(text)
                }
                Files.write(copy, exported("A copy of this page, with your notes and board", "test.html"))
                rewrite(0, " changed")
                remove(1)
                go(copy, "first changed", "third")
                rewrite(0, " in the copy")
                remove(1)
                graph("Step 1").click(0.8)
                write("fourth")
                go(page, "first changed in the copy", "fourth")
                rewrite(0, " and back")
                go(copy, "first changed in the copy and back", "fourth")
                // Another browser knows only the notes in the copy.
                script("localStorage.clear()")
                go(copy, "first", "second", "third")
            }
        }
    }

    browserTest("a copy of the page has the notes, the board and the log's exact bytes, and needs no storage of the original's browser") {
        val copy = tempdir().toPath().resolve("copy.html")
        onPage(TestPages.of(stepBag(graphs = 2))) {
            graph("Step 2").click(0.3)
            press("p")
            write("hit </script> by 254")
            Files.write(copy, exported("A copy of this page, with your notes and board", "test.html"))
        }
        onPage(copy, script = "localStorage.clear()") {
            texts("#notes .finding-text") shouldBe listOf("hit </script> by 254")
            texts(".board .graph-title") shouldBe listOf("Step 2")
            saved("test.bag") { click("#download") } shouldBe stepBag(graphs = 2)
            // A copy of a copy is the same page.
            val again = exported("A copy of this page, with your notes and board", "test.html")
            again shouldBe Files.readAllBytes(copy)
        }
    }
})
