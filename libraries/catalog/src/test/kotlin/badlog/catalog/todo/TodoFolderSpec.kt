package badlog.catalog.todo

import badlog.files.UnwritableFileException
import badlog.signals.match.MatchOfLog
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.toLine
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.appendText
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** Any second. */
private const val NOW = 1_773_500_000L

class TodoFolderSpec : FunSpec({
    fun change(text: String) = newChange(OwnTask(text), TodoDeed.Open, "Ada", last = null, now = NOW)

    fun texts(files: TodoFiles) = files.changes.map { (it.subject as OwnTask).text }

    test("each computer appends to its own file, and all files are read, including conflicted copies of a synced folder") {
        val folder = tempdir().toPath()
        val pit = TodoFolder(folder, "Pit Laptop")
        val drive = TodoFolder(folder, "drive")
        pit.file.name shouldBe "badlog-todo-pit-laptop.jsonl"
        pit.read().changes.shouldBeEmpty()
        pit.append(change("Radio"))
        val before = pit.file.readText()
        pit.append(change("Bumpers"))
        drive.append(change("Camera “left”"))
        pit.file.readText().take(before.length) shouldBe before
        folder.resolve("badlog-todo-pit (conflicted copy).jsonl").writeText(before + change("Ladder").toLine())
        folder.resolve("other.jsonl").writeText("{}")
        val all = pit.read()
        texts(all).toSet() shouldBe setOf("Radio", "Bumpers", "Camera “left”", "Ladder")
        all.problems.shouldBeEmpty()
        TodoList.of(all.changes, emptyList()).open.size shouldBe 4
    }

    test("after an incomplete line, the next one begins on a new line, and all other lines are kept") {
        val folder = TodoFolder(tempdir().toPath(), "pit")
        folder.append(change("Radio"))
        val cut = folder.file.readText() + "{\"id\":\"1\",\"ti"
        folder.file.writeText(cut)
        folder.append(change("Bumpers"))
        texts(folder.read()) shouldContainExactly listOf("Radio", "Bumpers")
        folder.read().problems shouldContainExactly
            listOf("Line 2 of badlog-todo-pit.jsonl is skipped: it is damaged, or from a newer badlog. It stays in the file.")
        folder.file.readText() shouldContain cut + "\n"
    }

    test("invalid bytes invalidate only their own line") {
        val folder = TodoFolder(tempdir().toPath(), "pit")
        folder.append(change("Radio"))
        folder.file.writeBytes(folder.file.readText().encodeToByteArray() + byteArrayOf(-1, 0, -64, '\n'.code.toByte()))
        folder.append(change("Bumpers"))
        texts(folder.read()) shouldContainExactly listOf("Radio", "Bumpers")
        folder.read().problems.size shouldBe 1
    }

    test("the team’s checklist is read, and changes are noticed without reading it") {
        val path = tempdir().toPath()
        val folder = TodoFolder(path, "pit")
        val empty = folder.stamp()
        path.resolve("checklist.md").writeText("# Before\r\n- [ ] Battery in\r\n- Bumpers\r\n")
        folder.read().checklist shouldContainExactlyInAnyOrder listOf("Battery in", "Bumpers")
        val one = folder.stamp()
        one shouldNotBe empty
        folder.append(change("Radio"))
        val two = folder.stamp()
        two shouldNotBe one
        folder.file.appendText(" ")
        val three = folder.stamp()
        three shouldNotBe two
        path.resolve("badlog-rules.toml").writeText("# rules")
        folder.stamp() shouldNotBe three
    }

    test("an unwritable folder is reported") {
        val missing = TodoFolder(tempdir().toPath().resolve("gone"), "pit")
        shouldThrow<UnwritableFileException> { missing.append(change("Radio")) }.message shouldContain "cannot be written"
    }

    test("a new change is later than all others of its subject, even if clocks are wrong, and affects no other subject") {
        val began = NOW - 3600
        val log = TodoLog("q1.bag", MatchOfLog("Mill Creek", "Qualification", "1"), began, emptyList())
        val ahead = listOf("2099-01-01T00:00:00.000Z", "9999-12-31T23:59:59.998Z").map { change("Radio").copy(time = it) }
        val done = newChange(OwnTask("Radio"), TodoDeed.Done(), " Ben ", log, ahead, NOW)
        done.time shouldBe "9999-12-31T23:59:59.999Z"
        done.run { listOf(author, seen, event) } shouldBe listOf("Ben", began, "Mill Creek")
        TodoList.of(ahead + done, emptyList()).open.shouldBeEmpty()
        val other = newChange(OwnTask("Bumpers"), TodoDeed.Open, "Ada", log, ahead + done, NOW)
        (other.time < ahead[0].time) shouldBe true
        (newChange(OwnTask("Bumpers"), TodoDeed.Done(), "Ada", log, ahead + other, NOW).time > other.time) shouldBe true
        val next = change("").copy(subject = NextMatch("Qualification 85"), time = "2099-01-01T00:00:00.000Z")
        newChange(NextMatch("Qualification 58"), TodoDeed.Open, "Ada", log, listOf(next), NOW).time shouldBe "2099-01-01T00:00:00.001Z"
    }

    test("a log of days ago does not determine the event of a new change") {
        val before = TodoLog("q78.bag", MatchOfLog("Mill Creek", "Qualification", "78"), NOW - 6 * 86_400, emptyList())
        val said = newChange(NextMatch("Qualification 1"), TodoDeed.Open, "Ada", before, now = NOW)
        said.event.shouldBeNull()
        TodoList.of(listOf(said), listOf(before)).next shouldBe "Qualification 1"
        val played = TodoLog("q1.bag", MatchOfLog("Tidewater", "Qualification", "1"), NOW + 3600, emptyList())
        TodoList.of(listOf(said), listOf(before, played)).next shouldBe "the match after Qualification 1"
    }

    test("without a known log, a change has the current time") {
        change("Radio").seen shouldBe NOW
    }
})
