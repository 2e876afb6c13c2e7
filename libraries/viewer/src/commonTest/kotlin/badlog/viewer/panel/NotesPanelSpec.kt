package badlog.viewer.panel

import badlog.viewer.bagView
import badlog.viewer.choices.note.Note
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Request
import badlog.viewer.todo.NoteTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf

class NotesPanelSpec : FunSpec({
    val times = LogTimes(10.0, bagView(listOf("Time|xaxis", "A"), listOf("0,1", "10,1")).xAxis, emptyList())
    val hit = Note(3.0, "hit by 254")
    val smell = Note(7.0, "smells burnt")
    val both = listOf(hit, smell)
    val all = Query("")

    fun List<Part>.rows() = filterIsInstance<Rows>().flatMap { it.rows }.map { it as Row }
    fun List<Part>.buttons() = filterIsInstance<Buttons>().flatMap { it.buttons }

    test("a note has its moment, to which it leads, and can be changed and removed") {
        val row = notesAbove(both, times, all).rows().first()
        row.name shouldBe "Note: hit by 254"
        row.lines.single().run { time to text } shouldBe ("3.000" to "hit by 254")
        for (open in listOf(row.open, row.lines.single().open)) open.shouldBeInstanceOf<PlaceAction.GoTo>().x shouldBe 3.0
        row.tools.map { it.label } shouldBe listOf("Change the note at 3.000", "Remove the note at 3.000")
        val (change, remove) = row.tools.map { it.action.shouldBeInstanceOf<Action.Ask>().request }
        change.shouldBeInstanceOf<Request.ChangeNote>().note shouldBe hit
        remove.shouldBeInstanceOf<Request.RemoveNote>().note shouldBe hit
        row.below.shouldBeEmpty()
    }

    test("a search lists and counts its notes; without any, there is nothing") {
        val found = notesAbove(both, times, Query("BURNT"))
        (found.first() as Heading).status shouldBe "1 of 2 notes"
        found.rows().single().lines.single().text shouldBe "smells burnt"
        (notesAbove(both, times, all).first() as Heading).status shouldBe "2 notes"
        notesAbove(both, times, Query("gone")).shouldBeEmpty()
        notesAbove(emptyList(), times, all).shouldBeEmpty()
    }

    test("a panel of notes beside a log offers to write one, unless one is being written, and says where they are kept") {
        val parts = notesPanel(emptyList(), times, "a.bag", todo = null, isWriting = false)
        parts.buttons().single().action.shouldBeInstanceOf<Action.Press>().key shouldBe KeyAction.NEW_NOTE
        parts.filterIsInstance<Paragraph>().single().text shouldContain "a.bag.notes-….jsonl"
        val writing = notesPanel(both, times, "a.bag", todo = null, isWriting = true)
        writing.buttons().shouldBeEmpty()
        writing.filterIsInstance<Paragraph>().shouldBeEmpty()
        writing.rows().size shouldBe 2
    }

    test("with a team’s list, a note has the actions for its item") {
        val below = notesPanel(both, times, "a.bag", ListedTasks(TodoList.of(emptyList(), emptyList()), "a.bag", "Ada"), isWriting = false).rows().last().below
        below.buttons().map { it.label } shouldBe listOf("Mark as done…", "Assign…", "Put on the list")
        below.buttons().last().action shouldBe Action.Ask(FolderRequest.WriteTodo(NoteTask("a.bag", 7.0, "smells burnt"), TodoDeed.Open))
    }
})
