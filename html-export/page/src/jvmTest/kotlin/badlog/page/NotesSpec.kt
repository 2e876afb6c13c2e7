package badlog.page

import badlog.exporter.EmptyPage
import badlog.exporter.HtmlExporter
import badlog.exporter.NotesFile
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.choices.note.toJson
import badlog.viewer.choices.note.toLines
import io.kotest.core.annotation.Tags
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import java.nio.file.Files
import java.nio.file.Path
import java.util.UUID

/** Notes written in the window, on an exported page. */
@Tags("InCheck")
internal class NotesSpec : PageSpec({
    fun pageOf(folder: Path, prepare: (log: Path) -> Unit): Path {
        val log = Files.write(folder.resolve("match.bag"), stepBag(graphs = 1))
        prepare(log)
        return folder.resolve("match.html").also { HtmlExporter().export(log, it) }
    }

    browserTest("notes beside a log are listed, marked by a key, and searched") {
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(3.0, "hit by 254 </script>"), Note(7.0, "second\nline")), read = emptyList()) }
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
            step("a search finds notes, and hides the others") {
                press("/")
                press("HIT")
                elements("#notes .finding-text").filter { it.isDisplayed }.map { it.text } shouldBe listOf("hit by 254 </script>")
                texts("#notes header .unit") shouldBe listOf("1 of 4 notes")
                texts(".search-count").single() shouldBe "1 note"
                press(Keys.ESCAPE)
                elements("#notes .finding-text").count { it.isDisplayed } shouldBe 4
            }
        }
    }

    /** Writes [text] as a note at the cursor. */
    fun OpenPage.write(text: String) {
        press("m")
        press(text, Keys.ENTER)
        settle()
    }

    browserTest("a page that is dropped on a page without a log shows its notes") {
        val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(1.0, "hit by 254")), read = emptyList()) }
        val empty = tempdir().toPath().resolve(EmptyPage.NAME).also { EmptyPage().write(it) }
        onPage(empty, state = "empty") {
            drop("match.html" to Files.readAllBytes(page))
            await("its note") { texts("#notes .finding-text") == listOf("hit by 254") }
        }
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

    /** Stores [text] for the log in the browser, under [key], as another tab does. */
    fun OpenPage.remember(key: String, text: String) {
        script(
            "const key = 'badlog:' + arguments[0] + ':match.bag:' + JSON.parse(document.getElementById('about').textContent).inflatedBytes;" +
                "localStorage.setItem(key, arguments[1])",
            key,
            text,
        )
    }

    browserTest("notes of another tab, of an older badlog and damaged ones") {
        step("damaged notes are listed as a problem, and nothing else changes") {
            onPage(pageOf(tempdir().toPath()) { Files.writeString(NotesFile.beginningOf(it), "{") }) {
                element("#notes").isDisplayed shouldBe false
                text shouldContain "notes in match.bag.notes.json are damaged"
                graphNames shouldBe listOf("Step 1")
            }
        }
        step("the changes of two tabs are merged in both, whichever tab writes last") {
            val page = pageOf(tempdir().toPath()) { NotesFile.update(it, listOf(Note(1.0, "first"), Note(2.0, "second")), read = emptyList()) }
            onPage(page) {
                val beginning = NoteHistory.of(listOf(Note(1.0, "first"), Note(2.0, "second")), emptyList())
                val there = listOf(Note(2.0, "second there"), Note(9.0, "of the other tab"))
                val changes = beginning.changesTo(there, beginning.notes, "", { "2099-01-01T00:00:00.000Z" }) { UUID.randomUUID().toString() }
                remember("note-changes", changes.toLines())
                graph("Step 1").click(0.5)
                write("of this tab")
                texts("#notes .finding-text") shouldBe listOf("second there", "of this tab", "of the other tab")
                // It works although the clock of the other tab is ahead.
                elements("#notes .note-row .pin")[0].click()
                press(" and here", Keys.ENTER)
                settle()
                texts("#notes .finding-text") shouldBe listOf("second there and here", "of this tab", "of the other tab")
                reload()
                texts("#notes .finding-text") shouldBe listOf("second there and here", "of this tab", "of the other tab")
            }
        }
        step("notes stored by pages of an older badlog are still there, and can be changed and removed") {
            val beside = listOf(Note(1.0, "first"), Note(2.0, "second"), Note(4.0, "hit"))
            val page = pageOf(tempdir().toPath()) { NotesFile.update(it, beside, read = emptyList()) }
            onPage(page) {
                val given = listOf(Note(1.0, "first"), Note(2.0, "second"))
                val kept = listOf(Note(2.0, "changed"), Note(4.0, "hit by 254"), Note(9.0, "added"))
                remember("notes", given.toJson() + "\u0000" + kept.toJson())
                reload()
                texts("#notes .finding-text") shouldBe listOf("changed", "hit by 254", "added")
                elements("#notes .note-row .pin")[0].click()
                press(" again", Keys.ENTER)
                elements("#notes .note-row .pin").last().click()
                settle()
                reload()
                texts("#notes .finding-text") shouldBe listOf("changed again", "hit by 254")
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
